// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
// A server that accepts connections but does not answer.
#include "ServerProcess.h"
#include "WatchingSource.h"

#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdint>

namespace
{
using Clock = std::chrono::steady_clock;

// Far below each Timeout. ThreadSanitizer makes everything ten times as slow.
#ifdef __SANITIZE_THREAD__
constexpr double AtOnce = 2.0;
#else
constexpr double AtOnce = 1.0;
#endif

double SecondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A process that is stopped. The system still accepts connections for it.
class Hanging
{
public:
  explicit Hanging(const ServerProcess& server)
    : Process(server.GetProcess())
  {
    kill(this->Process, SIGSTOP);
  }
  ~Hanging() { kill(this->Process, SIGCONT); }
  Hanging(const Hanging&) = delete;
  void operator=(const Hanging&) = delete;

private:
  const pid_t Process;
};
} // namespace

TEST(RemoteFaults, ServerHangsFromTheStart)
{
  ServerProcess server;
  WatchingSource source(server.GetCorbaloc());
  {
    const Hanging hanging(server);
    source->SetTimeout(1.0);
    const Clock::time_point start = Clock::now();
    source.ExpectNothing();
    EXPECT_LT(SecondsSince(start), 1.0 + AtOnce);
    EXPECT_FALSE(source.TakeWarnings().empty());
  }
  EXPECT_TRUE(source.UpdateUntil([&] { return source.GetScan()->GetNumberOfPoints() > 0; }));
}

TEST(RemoteFaults, ServerHangsForAWhile)
{
  ServerProcess server;
  WatchingSource source(server.GetCorbaloc());
  source->SetTimeout(3.0);
  source->Update();
  std::uint64_t before = 0;
  {
    const Hanging hanging(server);
    const Clock::time_point start = Clock::now();
    source->SendPose();
    source->GetNeedsUpdate();
    source->Update();
    EXPECT_LT(SecondsSince(start), AtOnce);
    EXPECT_TRUE(source.UpdateUntil([&] { return !source->GetProblem().empty(); }));
    EXPECT_EQ(source.GetScan()->GetNumberOfPoints(), 129960) << "the last scan does not stay";
    before = source.GetNumber("ScanNumber");
  }
  EXPECT_TRUE(source.UpdateUntil([&] { return source.GetNumber("ScanNumber") > before; }));
  EXPECT_EQ(source->GetProblem(), "");
}

TEST(RemoteFaults, DestructionNeverWaits)
{
  ServerProcess server;
  WatchingSource source(server.GetCorbaloc());
  source->SetTimeout(4.0);
  source->Update();
  const Hanging hanging(server);
  // By then the thread is in the middle of a call.
  EXPECT_TRUE(source.UpdateUntil([&] { return !source->GetNeedsUpdate(); }));
  const Clock::time_point start = Clock::now();
  source.Destroy();
  EXPECT_LT(SecondsSince(start), AtOnce);
}

TEST(RemoteFaults, AnotherURLOrTimeoutIsFollowedAtOnce)
{
  ServerProcess first;
  ServerProcess second;
  WatchingSource source(first.GetCorbaloc());
  source->SetTimeout(6.0);
  source->Update();
  const std::uint64_t incarnation = source.GetNumber("Incarnation");
  const Hanging hanging(first);
  const Clock::time_point start = Clock::now();
  source->SetURL(second.GetCorbaloc().c_str());
  source->Update();
  EXPECT_GT(source.GetNumber("Incarnation"), incarnation);
  source->SetTimeout(5.0);
  source->Update();
  EXPECT_EQ(source.GetScan()->GetNumberOfPoints(), 129960);
  EXPECT_LT(SecondsSince(start), 2 * AtOnce);
}
