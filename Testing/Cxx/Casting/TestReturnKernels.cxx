// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The kernels that fill the arrays of returns, with all instruction sets and all lengths up
 * to some vectors.
 */
#include "Kernels/lms3dPacketKernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace
{
constexpr int MaximumLength = 70;

// Stands behind each array, and must stay there.
constexpr int Guard = -77;

/// The arrays of a run.
struct Arrays
{
  explicit Arrays(int count)
    : Count(count)
    , Range(static_cast<std::size_t>(count) + 1, Guard)
    , Alpha(this->Range.begin(), this->Range.end())
    , Beta(this->Alpha)
    , BeamId(static_cast<std::size_t>(count) + 1, Guard)
    , Offset(this->BeamId)
    , Point(this->BeamId)
  {
  }

  void Fill(const lms3dPacketKernels& kernels, const std::vector<double>& ranges,
    const std::vector<double>& elevations)
  {
    kernels.Returns.FillRun({ this->Count, ranges.data(), elevations.data(), 0.1f, 100000, 2345,
      this->Range.data(), this->Alpha.data(), this->Beta.data(), this->BeamId.data(),
      this->Offset.data(), this->Point.data() });
  }

  int Count;
  std::vector<double> Range;
  std::vector<float> Alpha;
  std::vector<float> Beta;
  std::vector<std::int32_t> BeamId;
  std::vector<std::int32_t> Offset;
  std::vector<std::int32_t> Point;
};

/// Returns of one turn.
struct TurnInput
{
  TurnInput()
  {
    for (int i = 0; i < MaximumLength; ++i)
    {
      this->Cosines[i] = std::cos(0.01 * i);
      this->Sines[i] = std::sin(0.01 * i);
      this->Ranges[i] = 1.0 + 0.3 * i;
    }
  }

  void Locate(const lms3dPacketKernels& kernels, int first, int count, double* points) const
  {
    kernels.Locate({ this->Cosines + first, this->Sines + first, this->Ranges + first, count,
                     this->FanAxis, this->Up, this->Position },
      points);
  }

  double Cosines[MaximumLength];
  double Sines[MaximumLength];
  double Ranges[MaximumLength];
  const double FanAxis[3] = { 0.6, 0.7, 0.1 };
  const double Up[3] = { 0.1, -0.2, 0.9 };
  const double Position[3] = { 3.1, -7.7, 0.3 };
};

void ExpectRun(
  const Arrays& run, const std::vector<double>& ranges, const std::vector<double>& elevations)
{
  for (int i = 0; i < run.Count; ++i)
  {
    EXPECT_EQ(run.Range[i], ranges[i]);
    EXPECT_EQ(run.Alpha[i], static_cast<float>(elevations[i]));
    EXPECT_EQ(run.Beta[i], 0.1f);
    EXPECT_EQ(run.BeamId[i], 100000 + i);
    EXPECT_EQ(run.Offset[i], 2345 + i);
    EXPECT_EQ(run.Point[i], 2345 + i);
  }
  EXPECT_EQ(run.Range.back(), Guard);
  EXPECT_EQ(run.Alpha.back(), Guard);
  EXPECT_EQ(run.Beta.back(), Guard);
  EXPECT_EQ(run.BeamId.back(), Guard);
  EXPECT_EQ(run.Offset.back(), Guard);
  EXPECT_EQ(run.Point.back(), Guard);
}
} // namespace

TEST(ReturnKernels, FillRunsOfAllLengths)
{
  std::vector<double> ranges(MaximumLength);
  std::vector<double> elevations(MaximumLength);
  for (int i = 0; i < MaximumLength; ++i)
  {
    ranges[i] = 1.0 / (i + 1);
    elevations[i] = -90.0 + i / 3.0;
  }
  for (int k = 0; k < lms3dGetNumberOfPacketKernels(); ++k)
  {
    for (int count = 0; count <= MaximumLength; ++count)
    {
      SCOPED_TRACE(testing::Message() << lms3dGetPacketKernels(k).Name << ", " << count);
      Arrays run(count);
      run.Fill(lms3dGetPacketKernels(k), ranges, elevations);
      ExpectRun(run, ranges, elevations);
    }
  }
}

TEST(ReturnKernels, FillRunsInTheArrayOfTheirRanges)
{
  std::vector<double> ranges(MaximumLength);
  for (int i = 0; i < MaximumLength; ++i)
  {
    ranges[i] = 1.0 / (i + 1);
  }
  const std::vector<double> elevations(MaximumLength, 0.5);
  for (int k = 0; k < lms3dGetNumberOfPacketKernels(); ++k)
  {
    for (int count = 0; count <= MaximumLength; ++count)
    {
      SCOPED_TRACE(testing::Message() << lms3dGetPacketKernels(k).Name << ", " << count);
      Arrays run(count);
      std::copy_n(ranges.begin(), count, run.Range.begin());
      run.Fill(lms3dGetPacketKernels(k), run.Range, elevations);
      ExpectRun(run, ranges, elevations);
    }
  }
}

// Each point has the bits that the return has alone, wherever the points begin in a cache line.
TEST(ReturnKernels, LocateReturnsOfAllLengthsAnywhereInMemory)
{
  const TurnInput turn;
  for (int k = 0; k < lms3dGetNumberOfPacketKernels(); ++k)
  {
    const lms3dPacketKernels& kernels = lms3dGetPacketKernels(k);
    std::vector<double> alone(3 * MaximumLength);
    for (int i = 0; i < MaximumLength; ++i)
    {
      turn.Locate(kernels, i, 1, alone.data() + 3 * i);
    }
    for (int start = 1; start <= 8; ++start)
    {
      for (int count = 0; count <= MaximumLength; ++count)
      {
        SCOPED_TRACE(testing::Message() << kernels.Name << ", " << count << " from " << start);
        std::vector<double> points(3 * MaximumLength + 9, Guard);
        turn.Locate(kernels, 0, count, points.data() + start);
        const auto end = points.begin() + start + 3 * count;
        EXPECT_TRUE(std::equal(points.begin() + start, end, alone.begin()));
        EXPECT_EQ(points[start - 1], Guard);
        EXPECT_EQ(*end, Guard);
      }
    }
  }
}

TEST(ReturnKernels, CountBeamsWithATriangle)
{
  std::vector<std::int32_t> triangles(MaximumLength);
  for (int i = 0; i < MaximumLength; ++i)
  {
    triangles[i] = i % 3 == 0 ? lms3dBeamPacket::NoTriangle : (i % 2 == 0 ? 2147483647 : i - 1);
  }
  for (int k = 0; k < lms3dGetNumberOfPacketKernels(); ++k)
  {
    for (int count = 0; count <= MaximumLength; ++count)
    {
      SCOPED_TRACE(testing::Message() << lms3dGetPacketKernels(k).Name << ", " << count);
      const auto misses = std::count(triangles.begin(), triangles.begin() + count, -1);
      EXPECT_EQ(
        lms3dGetPacketKernels(k).Returns.CountReturns(triangles.data(), count), count - misses);
    }
  }
}

TEST(ReturnKernels, WidenTheNumbersOfTriangles)
{
  std::vector<std::int32_t> triangles(MaximumLength);
  for (int i = 0; i < MaximumLength; ++i)
  {
    triangles[i] = i % 3 == 0 ? 2147483647 - i : i;
  }
  for (int k = 0; k < lms3dGetNumberOfPacketKernels(); ++k)
  {
    for (int count = 0; count <= MaximumLength; ++count)
    {
      SCOPED_TRACE(testing::Message() << lms3dGetPacketKernels(k).Name << ", " << count);
      std::vector<long long> cells(static_cast<std::size_t>(count) + 1, Guard);
      lms3dGetPacketKernels(k).Returns.WidenTriangles(triangles.data(), count, cells.data());
      EXPECT_TRUE(std::equal(triangles.begin(), triangles.begin() + count, cells.begin()));
      EXPECT_EQ(cells.back(), Guard);
    }
  }
}
