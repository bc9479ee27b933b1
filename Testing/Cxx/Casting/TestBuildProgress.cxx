// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dRayCaster.h"
#include "Fixtures/MeshFixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include <malloc.h>
#include <unistd.h>

namespace
{
constexpr int Side = 707; // cells; two triangles in each, 999,698 in all

lms3dTriangleMesh MakeHills()
{
  lms3dTriangleMesh mesh;
  for (int i = 0; i <= Side; ++i)
  {
    for (int j = 0; j <= Side; ++j)
    {
      mesh.Points.push_back({ double(i), double(j), std::sin(0.1 * i) * std::cos(0.1 * j) });
    }
  }
  const auto getPoint = [](int i, int j) { return static_cast<std::uint32_t>(i * (Side + 1) + j); };
  for (int i = 0; i < Side; ++i)
  {
    for (int j = 0; j < Side; ++j)
    {
      mesh.Triangles.push_back({ getPoint(i, j), getPoint(i + 1, j), getPoint(i, j + 1) });
      mesh.Triangles.push_back({ getPoint(i + 1, j), getPoint(i + 1, j + 1), getPoint(i, j + 1) });
    }
  }
  return mesh;
}

/// Bytes of memory that the process holds, after free memory went back to the system.
double GetMemory()
{
  malloc_trim(0);
  std::ifstream file("/proc/self/statm");
  double size = 0.0;
  double resident = 0.0;
  file >> size >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

class BuildProgress : public testing::TestWithParam<lms3dRayCaster::Method>
{
protected:
  const lms3dTriangleMesh Hills = MakeHills();
};
} // namespace

TEST_P(BuildProgress, RisesOnTheCallingThread)
{
  const std::thread::id caller = std::this_thread::get_id();
  std::vector<double> reports;
  bool isCaller = true;
  const auto caster = lms3dRayCaster::New(GetParam(), this->Hills,
    [&](double done)
    {
      isCaller = isCaller && std::this_thread::get_id() == caller;
      reports.push_back(done);
      return true;
    });
  ASSERT_TRUE(caster);
  EXPECT_TRUE(isCaller);
  ASSERT_GE(reports.size(), 3u);
  EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
  EXPECT_GE(reports.front(), 0.0);
  EXPECT_LT(reports.front(), 0.5);
  EXPECT_GT(reports.back(), 0.5);
  EXPECT_LE(reports.back(), 1.0);
}

TEST_P(BuildProgress, StopsAtTheFirstFalse)
{
  int reports = 0;
  const auto stop = [&reports](double)
  {
    ++reports;
    return false;
  };
  EXPECT_FALSE(lms3dRayCaster::New(GetParam(), this->Hills, stop));
  EXPECT_EQ(reports, 1);
}

TEST_P(BuildProgress, FreesTheMemoryOfAStoppedBuild)
{
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "AddressSanitizer delays the release of memory; its leak check covers this.";
#endif
  const auto build = [this]
  {
    EXPECT_FALSE(
      lms3dRayCaster::New(GetParam(), this->Hills, [](double done) { return done < 0.5; }));
  };
  build();
  const double before = GetMemory();
  constexpr int Builds = 4;
  for (int i = 0; i < Builds; ++i)
  {
    build();
  }
  // Each build takes more than 36 bytes for a triangle's corners, indices and tree.
  const double leak = Builds * 36.0 * static_cast<double>(this->Hills.GetNumberOfTriangles());
  EXPECT_LT(GetMemory() - before, 0.5 * leak);
}

TEST_P(BuildProgress, LeavesAnotherBuildAlone)
{
  EXPECT_FALSE(lms3dRayCaster::New(GetParam(), this->Hills, [](double) { return false; }));
  EXPECT_TRUE(lms3dRayCaster::New(GetParam(), this->Hills));
}

INSTANTIATE_TEST_SUITE_P(RayCaster, BuildProgress,
  testing::Values(lms3dRayCaster::EXACT, lms3dRayCaster::FAST),
  [](const auto& method) { return lms3dRayCaster::GetMethodName(method.param); });
