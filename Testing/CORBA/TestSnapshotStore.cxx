// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Common/lms3dChecksum.h"
#include "Scanning/lms3dSnapshotStore.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace
{
using Clock = lms3dSnapshotStore::Clock;

lms3dSnapshotPointer MakeSnapshot(
  std::uint64_t number, std::uint64_t generation = 1, std::size_t beams = 4)
{
  auto snapshot = std::make_shared<lms3dSnapshot>();
  snapshot->Header.number = number;
  snapshot->Header.generation = generation;
  snapshot->Ranges.assign(beams, static_cast<float>(number));
  snapshot->Header.rangesChecksum = lms3dGetRangesChecksum(snapshot->Ranges);
  return snapshot;
}

Clock::time_point In(int milliseconds)
{
  return Clock::now() + std::chrono::milliseconds(milliseconds);
}
} // namespace

TEST(SnapshotStore, IsEmptyBeforeTheFirstScan)
{
  const lms3dSnapshotStore store(4);
  EXPECT_EQ(store.GetNewest(), nullptr);
  EXPECT_EQ(store.GetNewestNumber(), 0u);
  EXPECT_EQ(store.GetOldestNumber(), 0u);
  EXPECT_EQ(store.Find(0), nullptr);
  EXPECT_EQ(store.Find(1), nullptr);
  EXPECT_EQ(store.Wait(0, 0, In(10)), nullptr);
}

TEST(SnapshotStore, KeepsTheNewest)
{
  lms3dSnapshotStore store(3);
  for (std::uint64_t number = 1; number <= 5; ++number)
  {
    store.Publish(MakeSnapshot(number));
  }
  EXPECT_EQ(store.GetOldestNumber(), 3u);
  EXPECT_EQ(store.GetNewestNumber(), 5u);
  EXPECT_EQ(store.Find(2), nullptr);
  EXPECT_EQ(store.Find(6), nullptr);
  for (std::uint64_t number = 3; number <= 5; ++number)
  {
    ASSERT_NE(store.Find(number), nullptr);
    EXPECT_EQ(store.Find(number)->Header.number, number);
  }
}

// 100 beams are 400 bytes.
TEST(SnapshotStore, KeepsFewerWhereTheyAreLarge)
{
  lms3dSnapshotStore store(10, 1000);
  for (std::uint64_t number = 1; number <= 5; ++number)
  {
    store.Publish(MakeSnapshot(number, 1, 100));
  }
  EXPECT_EQ(store.GetOldestNumber(), 4u);
  store.Publish(MakeSnapshot(6, 1, 10));
  EXPECT_EQ(store.GetOldestNumber(), 4u);
  store.Publish(MakeSnapshot(7, 1, 1000));
  EXPECT_EQ(store.GetOldestNumber(), 7u);
  EXPECT_EQ(store.GetNewestNumber(), 7u);
  store.Publish(MakeSnapshot(8, 1, 100));
  store.Publish(MakeSnapshot(9, 1, 100));
  EXPECT_EQ(store.GetOldestNumber(), 8u);
}

TEST(SnapshotStore, CountsRangesAndMap)
{
  lms3dSnapshot snapshot;
  snapshot.Ranges.resize(5);
  snapshot.MapPoints.resize(6);
  snapshot.MapTriangles.resize(9);
  EXPECT_EQ(snapshot.GetBytes(), 5u * 4u + 6u * 8u + 9u * 4u);
}

TEST(SnapshotStore, ASnapshotLivesAsLongAsItsReaders)
{
  lms3dSnapshotStore store(1);
  store.Publish(MakeSnapshot(1));
  const lms3dSnapshotPointer read = store.GetNewest();
  store.Publish(MakeSnapshot(2));
  EXPECT_EQ(read.use_count(), 1);
  EXPECT_EQ(read->Ranges, std::vector<float>(4, 1.0f));
}

TEST(SnapshotStore, WaitsForNumberAndGeneration)
{
  lms3dSnapshotStore store(4);
  store.Publish(MakeSnapshot(7, 3));
  EXPECT_NE(store.Wait(0, 0, In(0)), nullptr);
  EXPECT_NE(store.Wait(6, 3, In(0)), nullptr);
  EXPECT_EQ(store.Wait(7, 0, In(10)), nullptr);
  EXPECT_EQ(store.Wait(0, 4, In(10)), nullptr);

  std::thread writer(
    [&store]
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      store.Publish(MakeSnapshot(8, 3));
      store.Publish(MakeSnapshot(9, 4));
    });
  const lms3dSnapshotPointer snapshot = store.Wait(0, 4, In(60000));
  writer.join();
  ASSERT_NE(snapshot, nullptr);
  EXPECT_EQ(snapshot->Header.number, 9u);
}

TEST(SnapshotStore, StopEndsAllWaiting)
{
  lms3dSnapshotStore store(4);
  store.Publish(MakeSnapshot(1));
  std::atomic<int> ended(0);
  std::vector<std::thread> waiting;
  waiting.reserve(8);
  for (int i = 0; i < 8; ++i)
  {
    waiting.emplace_back([&] { ended += store.Wait(1, 0, In(60000)) ? 100 : 1; });
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  store.Stop();
  for (std::thread& thread : waiting)
  {
    thread.join();
  }
  EXPECT_EQ(ended, 8);
  EXPECT_TRUE(store.IsStopped());
  EXPECT_EQ(store.Wait(0, 0, In(60000)), nullptr);
  EXPECT_NE(store.GetNewest(), nullptr);
}

// Each reader gets complete scans, and never an older one than before.
TEST(SnapshotStore, NothingTearsUnderEightReaders)
{
  constexpr std::uint64_t Scans = 2000;
  lms3dSnapshotStore store(4);
  std::atomic<int> torn(0);
  std::atomic<int> backwards(0);
  std::vector<std::thread> readers;
  readers.reserve(8);
  for (int i = 0; i < 8; ++i)
  {
    readers.emplace_back(
      [&]
      {
        for (std::uint64_t last = 0; last < Scans;)
        {
          const lms3dSnapshotPointer snapshot = store.Wait(last, 0, In(60000));
          const std::vector<float> copy = snapshot->Ranges;
          const bool isWhole = lms3dGetRangesChecksum(copy) == snapshot->Header.rangesChecksum &&
            copy.front() == static_cast<float>(snapshot->Header.number);
          torn += isWhole ? 0 : 1;
          backwards += snapshot->Header.number > last ? 0 : 1;
          last = snapshot->Header.number;
        }
      });
  }
  for (std::uint64_t number = 1; number <= Scans; ++number)
  {
    store.Publish(MakeSnapshot(number, 1, 5000));
  }
  for (std::thread& reader : readers)
  {
    reader.join();
  }
  EXPECT_EQ(torn, 0);
  EXPECT_EQ(backwards, 0);
}

// zlib's CRC-32 of "123456789" is the check value of the algorithm's catalogue.
TEST(Checksum, IsTheCommonOne)
{
  std::vector<float> ranges(2);
  std::copy_n("12345678", 8, reinterpret_cast<char*>(ranges.data()));
  EXPECT_EQ(lms3dGetRangesChecksum(ranges), 0x9ae0daafu);
  EXPECT_EQ(lms3dGetRangesChecksum({}), 0u);
}
