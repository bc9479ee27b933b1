// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ClientListener.h"
#include "ClientORB.h"
#include "ServerProcess.h"

#include <gtest/gtest.h>

namespace
{
// This machine, but not the address that servers connect to.
constexpr const char* Other = "127.0.0.5";
} // namespace

TEST(ServerCallbackAddresses, AListenerThatIsGoneIsForgotten)
{
  ServerProcess server({ "--callbacks" });
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  // A port without a listening socket.
  scanner->subscribe(MakeReference("127.0.0.1:1"));
  EXPECT_TRUE(HasListeners(scanner, 0));
}

TEST(ServerCallbackAddresses, NoOtherAddressIsConnectedTo)
{
  ServerProcess server({ "--callbacks" });
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const SilentPort other(false, Other);
  scanner->subscribe(other.GetReference());
  EXPECT_TRUE(HasListeners(scanner, 0));
  EXPECT_FALSE(other.IsConnectedTo(0));
}

TEST(ServerCallbackAddresses, ThoseThatAreAllowedAre)
{
  ServerProcess server({ "--callbacks", "--connect-to", "127.0.0.5/255.255.255.255" });
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const SilentPort other(false, Other);
  scanner->subscribe(other.GetReference());
  EXPECT_TRUE(other.IsConnectedTo(60000));
}

TEST(ServerCallbackAddresses, WithoutCallbacksNoAddressIsConnectedTo)
{
  ServerProcess server;
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const SilentPort other(false, Other);
  EXPECT_THROW(scanner->subscribe(other.GetReference()), LMS3D::NotPermitted);
  EXPECT_FALSE(other.IsConnectedTo(500));
}
