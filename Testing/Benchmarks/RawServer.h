// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A plain TCP server: the minimum time of a fetch over the network.
 */
#ifndef RawServer_h
#define RawServer_h

#include <cstddef>
#include <thread>
#include <vector>

/// Answers each byte of a client with `answerSize` bytes from memory, in a thread per client like
/// the CORBA server.
class RawServer
{
public:
  explicit RawServer(std::size_t answerSize);
  ~RawServer();
  RawServer(const RawServer&) = delete;
  void operator=(const RawServer&) = delete;

  /// The port at 127.0.0.1.
  int GetPort() const;

private:
  void Accept();
  void Serve(int connection) const;

  const std::vector<char> Answer;
  const int Listener;
  std::vector<std::thread> Clients;
  std::thread Acceptor;
};

/// A connection to a RawServer, for one call after the other.
class RawClient
{
public:
  RawClient(int port, std::size_t answerSize);
  ~RawClient();
  RawClient(const RawClient&) = delete;
  void operator=(const RawClient&) = delete;

  /// Throws std::runtime_error if the connection ends before the whole answer arrived.
  void Fetch();

private:
  const int Connection;
  std::vector<char> Answer;
};

#endif
