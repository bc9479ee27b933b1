// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RawServer.h"

#include <stdexcept>

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

namespace
{
sockaddr_in GetLoopback(int port)
{
  sockaddr_in address = {};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(static_cast<in_port_t>(port));
  return address;
}

int Require(int result)
{
  if (result < 0)
  {
    throw std::runtime_error("a socket of 127.0.0.1 failed");
  }
  return result;
}

int Listen()
{
  constexpr int Waiting = 128;
  const int listener = Require(socket(AF_INET, SOCK_STREAM, 0));
  const sockaddr_in address = GetLoopback(0);
  Require(bind(listener, reinterpret_cast<const sockaddr*>(&address), sizeof(address)));
  Require(listen(listener, Waiting));
  return listener;
}

int Connect(int port)
{
  const int connection = Require(socket(AF_INET, SOCK_STREAM, 0));
  const sockaddr_in address = GetLoopback(port);
  Require(connect(connection, reinterpret_cast<const sockaddr*>(&address), sizeof(address)));
  const int noDelay = 1;
  Require(setsockopt(connection, IPPROTO_TCP, TCP_NODELAY, &noDelay, sizeof(noDelay)));
  return connection;
}
} // namespace

RawServer::RawServer(std::size_t answerSize)
  : Answer(answerSize, 'x')
  , Listener(Listen())
  , Acceptor([this] { this->Accept(); })
{
}

RawServer::~RawServer()
{
  shutdown(this->Listener, SHUT_RDWR);
  this->Acceptor.join();
  close(this->Listener);
  for (std::thread& client : this->Clients)
  {
    client.join();
  }
}

int RawServer::GetPort() const
{
  sockaddr_in address = {};
  socklen_t size = sizeof(address);
  Require(getsockname(this->Listener, reinterpret_cast<sockaddr*>(&address), &size));
  return ntohs(address.sin_port);
}

void RawServer::Accept()
{
  for (int connection; (connection = accept(this->Listener, nullptr, nullptr)) >= 0;)
  {
    this->Clients.emplace_back([this, connection] { this->Serve(connection); });
  }
}

// Serves until the client closes the connection.
void RawServer::Serve(int connection) const
{
  bool isWell = true;
  for (char request; isWell && recv(connection, &request, 1, 0) == 1;)
  {
    isWell = send(connection, this->Answer.data(), this->Answer.size(), MSG_NOSIGNAL) ==
      static_cast<ssize_t>(this->Answer.size());
  }
  close(connection);
}

RawClient::RawClient(int port, std::size_t answerSize)
  : Connection(Connect(port))
  , Answer(answerSize)
{
}

RawClient::~RawClient()
{
  close(this->Connection);
}

void RawClient::Fetch()
{
  const char request = 'f';
  const bool isSent = send(this->Connection, &request, 1, MSG_NOSIGNAL) == 1;
  const bool isThere = isSent &&
    recv(this->Connection, this->Answer.data(), this->Answer.size(), MSG_WAITALL) ==
      static_cast<ssize_t>(this->Answer.size());
  if (!isThere)
  {
    throw std::runtime_error("the raw server's answer is incomplete");
  }
}
