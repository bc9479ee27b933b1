// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ClientORB.h"
#include "ServerProcess.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace
{
/// A port of 127.0.0.5, which is this machine but not the address that servers connect to.
class OtherAddress
{
public:
  OtherAddress()
    : Socket(socket(AF_INET, SOCK_STREAM, 0))
  {
    this->Address.sin_family = AF_INET;
    inet_pton(AF_INET, "127.0.0.5", &this->Address.sin_addr);
    socklen_t size = sizeof(this->Address);
    auto* address = reinterpret_cast<sockaddr*>(&this->Address);
    EXPECT_EQ(bind(this->Socket, address, size), 0);
    EXPECT_EQ(listen(this->Socket, 8), 0);
    EXPECT_EQ(getsockname(this->Socket, address, &size), 0);
  }
  ~OtherAddress() { close(this->Socket); }
  OtherAddress(const OtherAddress&) = delete;
  void operator=(const OtherAddress&) = delete;

  std::string GetName() const
  {
    return "127.0.0.5:" + std::to_string(ntohs(this->Address.sin_port));
  }

  bool IsConnectedTo(int milliseconds) const
  {
    pollfd waiting = { this->Socket, POLLIN, 0 };
    return poll(&waiting, 1, milliseconds) == 1;
  }

private:
  int Socket;
  sockaddr_in Address = {};
};

// Of nobody, at an address of this machine.
LMS3D::ScanListener_var MakeReference(const std::string& address)
{
  const std::string uri = "corbaloc:iiop:1.2@" + address + "/nobody";
  const CORBA::Object_var object = GetClientORB()->string_to_object(uri.c_str());
  return LMS3D::ScanListener::_unchecked_narrow(object);
}

bool IsForgotten(LMS3D::LaserScanner_ptr scanner)
{
  for (int i = 0; i < 100; ++i)
  {
    const LMS3D::Status_var status = scanner->getStatus();
    if (status->listening == 0)
    {
      return true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  return false;
}
} // namespace

TEST(ServerCallbackAddresses, AListenerThatIsGoneIsForgotten)
{
  ServerProcess server({ "--callbacks" });
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  // A port that nobody listens to.
  scanner->subscribe(MakeReference("127.0.0.1:1"));
  EXPECT_TRUE(IsForgotten(scanner));
}

TEST(ServerCallbackAddresses, NobodyElseIsConnectedTo)
{
  ServerProcess server({ "--callbacks" });
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const OtherAddress other;
  scanner->subscribe(MakeReference(other.GetName()));
  EXPECT_TRUE(IsForgotten(scanner));
  EXPECT_FALSE(other.IsConnectedTo(0));
}

TEST(ServerCallbackAddresses, ThoseThatAreAllowedAre)
{
  ServerProcess server({ "--callbacks", "--connect-to", "127.0.0.5/255.255.255.255" });
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const OtherAddress other;
  scanner->subscribe(MakeReference(other.GetName()));
  EXPECT_TRUE(other.IsConnectedTo(10000));
}

TEST(ServerCallbackAddresses, WithoutCallbacksNobodyIsConnectedTo)
{
  ServerProcess server;
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const OtherAddress other;
  EXPECT_THROW(scanner->subscribe(MakeReference(other.GetName())), LMS3D::NotPermitted);
  EXPECT_FALSE(other.IsConnectedTo(500));
}
