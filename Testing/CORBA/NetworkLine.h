// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A connection to a server that is as slow as a test needs, and breaks on demand.
 */
#ifndef NetworkLine_h
#define NetworkLine_h

#include <atomic>
#include <cstddef>
#include <limits>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

class NetworkLine
{
public:
  /// Leads to the server of a corbaloc, which can send up to `bytesPerSecond`.
  explicit NetworkLine(const std::string& corbaloc,
    std::size_t bytesPerSecond = std::numeric_limits<std::size_t>::max());
  ~NetworkLine();
  NetworkLine(const NetworkLine&) = delete;
  void operator=(const NetworkLine&) = delete;

  /// The server's corbaloc at this end of the line.
  const std::string& GetCorbaloc() const { return this->Corbaloc; }

  /// The number of bytes that came from the server.
  std::size_t GetBytes() const { return this->Bytes; }

  /// Drops the next message to the server that contains `word`, and closes its connection.
  void BreakAt(const std::string& word);
  bool IsBroken() const;

  /// Drops each message to the server that contains `word`, from now on. None if it is empty.
  void Lose(const std::string& word);

  /// Writes `other` in place of `word`, which is as long, in each message to the server from now
  /// on.
  void Replace(const std::string& word, const std::string& other);

private:
  struct Connection
  {
    int Client;
    int Server;
  };

  void Run();
  void Accept();
  bool Forward(const Connection& connection, int from, int to);
  bool IsBreaking(const std::string& message);
  bool IsLost(const std::string& message) const;
  void ReplaceWord(char* message, std::size_t size);

  int ServerPort = 0;
  std::string Corbaloc;
  const std::size_t BytesPerSecond;
  std::atomic<std::size_t> Bytes{ 0 };

  mutable std::mutex Mutex;
  std::string BreakingWord;
  std::string LostWord;
  std::string ReplacedWord;
  std::string OtherWord;

  int Listener = -1;
  std::vector<Connection> Connections;
  std::atomic<bool> IsOver{ false };
  std::thread Thread;
};

#endif
