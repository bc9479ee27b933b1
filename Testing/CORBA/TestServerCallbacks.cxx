// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ClientListener.h"
#include "ClientORB.h"
#include "ServerProcess.h"

#include <gtest/gtest.h>

#include <array>
#include <csignal>
#include <list>
#include <string>
#include <thread>

namespace
{
/// Unreachable listeners, each at a port of its own.
class SilentListeners
{
public:
  static constexpr CORBA::ULong Number = 8;

  explicit SilentListeners(LMS3D::LaserScanner_ptr scanner)
  {
    for (CORBA::ULong i = 0; i < Number; ++i)
    {
      this->Ports.emplace_back(i % 2 != 0);
      scanner->subscribe(this->Ports.back().GetReference());
    }
  }

private:
  std::list<SilentPort> Ports;
};
} // namespace

TEST(ServerCallbacks, AreOffUnlessAskedFor)
{
  ServerProcess server;
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  ActiveListener listener;
  EXPECT_THROW(scanner->subscribe(listener.GetReference()), LMS3D::NotPermitted);
  const LMS3D::Status_var status = scanner->getStatus();
  EXPECT_FALSE(status->hasCallbacks);
  EXPECT_EQ(listener->GetCount(), 0);
}

TEST(ServerCallbacks, TellOfEachScanUntilUnsubscribed)
{
  ServerProcess server({ "--callbacks" });
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  ActiveListener listener;
  const CORBA::ULong subscription = scanner->subscribe(listener.GetReference());
  EXPECT_TRUE(listener->WaitFor(5));
  EXPECT_GT(listener->GetMinimumStep(), 0);
  scanner->unsubscribe(subscription);
  EXPECT_THROW(scanner->unsubscribe(subscription), LMS3D::InvalidArgument);
  // One call may be in progress.
  const int count = listener->GetCount();
  WaitFor(scanner, 0, WaitFor(scanner).number + 3);
  EXPECT_LE(listener->GetCount(), count + 1);
  EXPECT_EQ(server.Terminate(SIGTERM), 0);
}

TEST(ServerCallbacks, SilentListenersDelayNoOtherAndAreDropped)
{
  ServerProcess server({ "--callbacks" });
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  WaitFor(scanner, scanner->setConfiguration(GetCoarseGrid()));
  ActiveListener good;
  scanner->subscribe(good.GetReference());
  const SilentListeners silent(scanner);
  EXPECT_TRUE(HasListeners(scanner, 1 + SilentListeners::Number));
  EXPECT_TRUE(HasListeners(scanner, 1));
  // If they were called one after the other, the silent ones would take five seconds per scan.
  EXPECT_GT(good->GetCount(), 5);
  EXPECT_LT(good->GetMaximumStep(), 20);
  EXPECT_EQ(server.Terminate(SIGTERM), 0);
}

TEST(ServerCallbacks, SilentListenersDoNotDelayTheEnd)
{
  ServerProcess server({ "--callbacks" });
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const SilentListeners silent(scanner);
  // One scan later the server calls them.
  WaitFor(scanner, 0, WaitFor(scanner).number);
  server.ExpectPromptEnd();
}

// The exceptions of calls while the end waits for a listener that does not answer.
TEST(ServerCallbacks, CallsAtTheEndMayBeTriedAgain)
{
  ServerProcess server({ "--callbacks" });
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const SilentListeners silent(scanner);
  WaitFor(scanner, 0, WaitFor(scanner).number);
  std::string answer;
  std::thread client(
    [&]
    {
      while (answer.empty())
      {
        try
        {
          scanner->getPose();
        }
        catch (const CORBA::SystemException& problem)
        {
          answer = problem._name();
        }
      }
    });
  EXPECT_EQ(server.Terminate(SIGTERM), 0);
  client.join();
  EXPECT_EQ(answer, "TRANSIENT");
}

TEST(ServerCallbacks, SubscriptionsCannotBeGuessed)
{
  ServerProcess server({ "--callbacks" });
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  ActiveListener listener;
  const CORBA::ULong first = scanner->subscribe(listener.GetReference());
  const CORBA::ULong second = scanner->subscribe(listener.GetReference());
  EXPECT_NE(first, second);
  for (const CORBA::ULong guess : { 0u, 1u, 2u, first - 1, first + 1 })
  {
    EXPECT_THROW(scanner->unsubscribe(guess), LMS3D::InvalidArgument);
  }
  EXPECT_TRUE(HasListeners(scanner, 2));
}

// At this rate no listener fails often enough to be dropped.
TEST(ServerCallbacks, TakeFourOfAClientSixteenInAllAndNoNil)
{
  ServerProcess server({ "--callbacks", "--rate", "0.001" });
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  EXPECT_THROW(scanner->subscribe(LMS3D::ScanListener::_nil()), LMS3D::InvalidArgument);
  const std::array<SilentPort, 5> clients;
  const auto getLimit = [&scanner](const SilentPort& client) -> CORBA::ULongLong
  {
    try
    {
      scanner->subscribe(client.GetReference());
      return 0;
    }
    catch (const LMS3D::LimitExceeded& problem)
    {
      return problem.limit;
    }
  };
  for (std::size_t client = 0; client < 4; ++client)
  {
    for (int i = 0; i < 4; ++i)
    {
      EXPECT_EQ(getLimit(clients[client]), 0u);
    }
    EXPECT_EQ(getLimit(clients[client]), 4u);
  }
  EXPECT_EQ(getLimit(clients[4]), 16u);
  EXPECT_EQ(server.Terminate(SIGTERM), 0);
}
