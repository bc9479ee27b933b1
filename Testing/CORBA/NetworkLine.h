// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A line to a server that is as slow as a test needs, and breaks when it says.
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
  /// To the server of a corbaloc. At most so many bytes a second come from there.
  explicit NetworkLine(const std::string& corbaloc,
    std::size_t bytesPerSecond = std::numeric_limits<std::size_t>::max());
  ~NetworkLine();
  NetworkLine(const NetworkLine&) = delete;
  void operator=(const NetworkLine&) = delete;

  /// The server at this end of the line.
  const std::string& GetCorbaloc() const { return this->Corbaloc; }

  /// How many have come from the server.
  std::size_t GetBytes() const { return this->Bytes; }

  /// The next message to the server that has this word in it is lost, and its connection with it.
  void BreakAt(const std::string& word);
  bool IsBroken() const;

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

  int ServerPort = 0;
  std::string Corbaloc;
  const std::size_t BytesPerSecond;
  std::atomic<std::size_t> Bytes{ 0 };

  mutable std::mutex Mutex;
  std::string BreakingWord;

  int Listener = -1;
  std::vector<Connection> Connections;
  std::atomic<bool> IsOver{ false };
  std::thread Thread;
};

#endif
