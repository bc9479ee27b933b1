// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "NetworkLine.h"

#include "ServerProcess.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace
{
sockaddr_in GetAddress(int port)
{
  sockaddr_in address = {};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  return address;
}

bool IsReadable(int file)
{
  pollfd entry = { file, POLLIN, 0 };
  return poll(&entry, 1, 0) > 0;
}
} // namespace

NetworkLine::NetworkLine(const std::string& corbaloc, std::size_t bytesPerSecond)
  : BytesPerSecond(bytesPerSecond)
{
  const std::size_t start = corbaloc.rfind(':') + 1;
  const std::size_t end = corbaloc.find('/', start);
  this->ServerPort = std::stoi(corbaloc.substr(start, end - start));
  const int port = FindFreePort();
  this->Corbaloc = corbaloc.substr(0, start) + std::to_string(port) + corbaloc.substr(end);

  this->Listener = socket(AF_INET, SOCK_STREAM, 0);
  const sockaddr_in address = GetAddress(port);
  EXPECT_EQ(bind(this->Listener, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
  listen(this->Listener, SOMAXCONN);
  this->Thread = std::thread([this] { this->Run(); });
}

NetworkLine::~NetworkLine()
{
  this->IsOver = true;
  this->Thread.join();
  close(this->Listener);
  for (const Connection& connection : this->Connections)
  {
    close(connection.Client);
    close(connection.Server);
  }
}

void NetworkLine::BreakAt(const std::string& word)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->BreakingWord = word;
}

bool NetworkLine::IsBroken() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->BreakingWord.empty();
}

void NetworkLine::Lose(const std::string& word)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->LostWord = word;
}

bool NetworkLine::IsLost(const std::string& message) const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return !this->LostWord.empty() && message.find(this->LostWord) != std::string::npos;
}

void NetworkLine::Replace(const std::string& word, const std::string& other)
{
  ASSERT_EQ(word.size(), other.size());
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->ReplacedWord = word;
  this->OtherWord = other;
}

void NetworkLine::ReplaceWord(char* message, std::size_t size)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (!this->ReplacedWord.empty())
  {
    char* const end = message + size;
    char* const found =
      std::search(message, end, this->ReplacedWord.begin(), this->ReplacedWord.end());
    if (found != end)
    {
      std::copy(this->OtherWord.begin(), this->OtherWord.end(), found);
    }
  }
}

bool NetworkLine::IsBreaking(const std::string& message)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  const bool isBreaking =
    !this->BreakingWord.empty() && message.find(this->BreakingWord) != std::string::npos;
  if (isBreaking)
  {
    this->BreakingWord.clear();
  }
  return isBreaking;
}

void NetworkLine::Run()
{
  while (!this->IsOver)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (IsReadable(this->Listener))
    {
      this->Accept();
    }
    const auto isEnded = [this](const Connection& connection)
    {
      const bool goesOn = this->Forward(connection, connection.Client, connection.Server) &&
        this->Forward(connection, connection.Server, connection.Client);
      if (!goesOn)
      {
        close(connection.Client);
        close(connection.Server);
      }
      return !goesOn;
    };
    this->Connections.erase(
      std::remove_if(this->Connections.begin(), this->Connections.end(), isEnded),
      this->Connections.end());
  }
}

void NetworkLine::Accept()
{
  const Connection connection = { accept(this->Listener, nullptr, nullptr),
    socket(AF_INET, SOCK_STREAM, 0) };
  const sockaddr_in address = GetAddress(this->ServerPort);
  EXPECT_EQ(
    connect(connection.Server, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
  this->Connections.push_back(connection);
}

// Forwards what has arrived. Returns false if one of the two ends is closed.
bool NetworkLine::Forward(const Connection& connection, int from, int to)
{
  if (!IsReadable(from))
  {
    return true;
  }
  std::array<char, 16384> buffer;
  const ssize_t size = recv(from, buffer.data(), buffer.size(), 0);
  if (size <= 0)
  {
    return false;
  }
  const auto count = static_cast<std::size_t>(size);
  if (from == connection.Server)
  {
    this->Bytes += count;
    std::this_thread::sleep_for(
      std::chrono::duration<double>(static_cast<double>(count) / this->BytesPerSecond));
  }
  else if (this->IsBreaking({ buffer.data(), count }))
  {
    return false;
  }
  else if (this->IsLost({ buffer.data(), count }))
  {
    return true;
  }
  else
  {
    this->ReplaceWord(buffer.data(), count);
  }
  return send(to, buffer.data(), count, MSG_NOSIGNAL) == size;
}
