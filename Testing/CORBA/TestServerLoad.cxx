// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Client/lms3dRemoteScan.h"
#include "ClientORB.h"
#include "Common/lms3dChecksum.h"
#include "DirectPipeline.h"
#include "ServerProcess.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <string>
#include <thread>
#include <vector>

namespace
{
CORBA::ULong CountWaiting(LMS3D::LaserScanner_ptr scanner)
{
  const LMS3D::Status_var status = scanner->getStatus();
  return status->waiting;
}

/// Joins the threads in its destructor.
class ClientThreads
{
public:
  ~ClientThreads() { this->Join(); }

  void Add(int count, const std::function<void()>& work)
  {
    for (int i = 0; i < count; ++i)
    {
      this->Threads.emplace_back(work);
    }
  }

  void Join()
  {
    for (std::thread& thread : this->Threads)
    {
      thread.join();
    }
    this->Threads.clear();
  }

private:
  std::vector<std::thread> Threads;
};

// Returns false if the server is gone.
bool Call(const std::function<void()>& call, std::atomic<int>& good)
{
  try
  {
    call();
    ++good;
  }
  catch (const LMS3D::NoScanYet&)
  {
    return true;
  }
  catch (const CORBA::SystemException&)
  {
    return false;
  }
  return true;
}

void CallUntilTheEnd(const std::function<void()>& call, std::atomic<int>& good)
{
  bool isThere = true;
  while (isThere)
  {
    isThere = Call(call, good);
  }
}

bool IsOneOf(const LMS3D::Data& triples, const std::vector<DirectPipeline>& expected)
{
  for (const DirectPipeline& direct : expected)
  {
    if (triples.length() == direct.Triples.size() &&
      std::memcmp(
        triples.get_buffer(), direct.Triples.data(), direct.Triples.size() * sizeof(float)) == 0)
    {
      return true;
    }
  }
  return false;
}

int GetNumberOfFetches()
{
  const char* const number = std::getenv("LMS3D_SOAK_FETCHES");
  return number ? std::atoi(number) : 4000;
}
} // namespace

TEST(ServerLoad, EndsSoonUnderBusyAndWaitingClients)
{
  ServerProcess server;
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  WaitFor(scanner);
  std::atomic<int> fetched(0);
  std::atomic<int> waited(0);
  ClientThreads clients;
  clients.Add(8,
    [&] { CallUntilTheEnd([&] { const LMS3D::Data_var triples = scanner->fetch(); }, fetched); });
  clients.Add(20,
    [&]
    { CallUntilTheEnd([&] { scanner->waitForScan(~CORBA::ULongLong(0), 0, 10000); }, waited); });
  bool areAllBusy = false;
  for (int i = 0; i < 600 && !areAllBusy; ++i)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    areAllBusy = fetched >= 50 && CountWaiting(scanner) == 20;
  }
  EXPECT_TRUE(areAllBusy);
  server.ExpectPromptEnd();
  clients.Join();
  EXPECT_EQ(waited, 0);
}

TEST(ServerLoad, EndsBySIGINTToo)
{
  ServerProcess server;
  EXPECT_EQ(server.Terminate(SIGINT), 0);
}

// The signal arrives during the casting, the map, or afterwards.
TEST(ServerLoad, EndsInTheMiddleOfALargeScan)
{
  for (const int milliseconds : { 10, 50, 200 })
  {
    ServerProcess server;
    const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
    WaitFor(scanner);
    LMS3D::Configuration configuration = GetCoarseGrid();
    configuration.alpha = { -90.0, 90.0, 2000 };
    configuration.beta = { 0.0, 360.0, 2000 };
    scanner->setConfiguration(configuration);
    std::this_thread::sleep_for(std::chrono::milliseconds(100 + milliseconds));
    server.ExpectPromptEnd();
  }
}

// Poses alternate between two. Each answer belongs wholly to one of them.
TEST(ServerLoad, NothingTearsWhileThePoseMoves)
{
  const LMS3D::Pose poses[2] = { At(0.3, -0.2, 1.0), At(-1.0, 0.5, 1.4) };
  ServerProcess server({ "--rate", "0" });
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const LMS3D::Configuration configuration = scanner->getConfiguration();
  const std::vector<DirectPipeline> expected = { { "room.wrl", poses[0], configuration },
    { "room.wrl", poses[1], configuration } };
  ASSERT_NE(expected[0].Triples, expected[1].Triples);
  ASSERT_NE(WaitFor(scanner, scanner->setPose(poses[1])).number, 0u);

  std::atomic<bool> isOver(false);
  std::atomic<int> good(0);
  std::atomic<int> torn(0);
  ClientThreads clients;
  clients.Add(3,
    [&]
    {
      while (!isOver)
      {
        const LMS3D::Data_var triples = scanner->fetch();
        ++(IsOneOf(triples, expected) ? good : torn);
      }
    });
  // Checks header and checksums of what comes in parts.
  clients.Add(1,
    [&]
    {
      while (!isOver)
      {
        try
        {
          const LMS3D::Scan_var scan = scanner->getScan();
          const std::vector<float> ranges(scan->beamRanges.get_buffer(),
            scan->beamRanges.get_buffer() + scan->beamRanges.length());
          const bool isWhole = lms3dGetRangesChecksum(ranges) == scan->header.rangesChecksum;
          ++(isWhole ? good : torn);
          lms3dFetchScan(scanner, scan->header);
        }
        catch (const LMS3D::ScanGone&)
        {
          continue;
        }
      }
    });
  for (int i = 0; i < 40; ++i)
  {
    const LMS3D::ScanHeader header = WaitFor(scanner, scanner->setPose(poses[i % 2]));
    EXPECT_EQ(header.sensorPose.position.x, poses[i % 2].position.x);
  }
  isOver = true;
  clients.Join();
  EXPECT_GT(good, 40);
  EXPECT_EQ(torn, 0);
  EXPECT_EQ(server.Terminate(SIGTERM), 0);
}

// LMS3D_SOAK_FETCHES=100000 for the long run.
TEST(ServerLoad, MemoryStaysFlat)
{
  constexpr int Threads = 4;
  // The allocator keeps some answers of 1.5 MB per thread. A leak of each answer would make
  // gigabytes.
  constexpr long Tolerance = 16 << 20;
  ServerProcess server;
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const auto fetch = [&scanner](int count)
  {
    ClientThreads clients;
    clients.Add(Threads,
      [&]
      {
        for (int i = 0; i < count / Threads; ++i)
        {
          const LMS3D::Data_var triples = scanner->fetch();
        }
      });
  };
  fetch(1000);
  const long before = server.GetResidentMemory();
  fetch(GetNumberOfFetches());
  const long after = server.GetResidentMemory();
  RecordProperty("BytesBefore", std::to_string(before));
  RecordProperty("BytesAfter", std::to_string(after));
  EXPECT_LT(after - before, Tolerance) << before << " bytes before, " << after << " after";
  EXPECT_EQ(server.Terminate(SIGTERM), 0);
}
