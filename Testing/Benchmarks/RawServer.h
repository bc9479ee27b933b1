// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A bare TCP server: the least that a fetch over the network can cost.
 */
#ifndef RawServer_h
#define RawServer_h

#include <cstddef>
#include <thread>
#include <vector>

/// Answers each byte of a client with as many bytes as a scan has, from memory; a thread for each
/// client, as the CORBA server has.
class RawServer
{
public:
  explicit RawServer(std::size_t answerSize);
  ~RawServer();
  RawServer(const RawServer&) = delete;
  void operator=(const RawServer&) = delete;

  /// Of 127.0.0.1.
  int GetPort() const;

private:
  void Accept();
  void Serve(int connection) const;

  const std::vector<char> Answer;
  const int Listener;
  std::vector<std::thread> Clients;
  std::thread Acceptor;
};

/// One call after the other to a RawServer.
class RawClient
{
public:
  RawClient(int port, std::size_t answerSize);
  ~RawClient();
  RawClient(const RawClient&) = delete;
  void operator=(const RawClient&) = delete;

  /// Throws std::runtime_error where the answer is cut.
  void Fetch();

private:
  const int Connection;
  std::vector<char> Answer;
};

#endif
