// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/lms3dHugePages.h"
#include "Geometry/lms3dTriangleMesh.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace
{
using Allocator = lms3dHugePageAllocator<double>;
using Numbers = std::vector<double, Allocator>;

constexpr std::size_t Large = Allocator::MinimumSize / sizeof(double);

template <typename Vector>
bool IsOnPages(const Vector& vector)
{
  return reinterpret_cast<std::uintptr_t>(vector.data()) % lms3dHugePageSize == 0;
}
} // namespace

TEST(HugePages, HoldLargeVectors)
{
  EXPECT_TRUE(IsOnPages(Numbers(Large)));
  EXPECT_TRUE(IsOnPages(Numbers(10 * Large + 1)));
}

TEST(HugePages, HoldLargeMeshes)
{
  lms3dTriangleMesh mesh;
  mesh.Points.resize(Large);
  mesh.Triangles.resize(Large);
  EXPECT_TRUE(IsOnPages(mesh.Points));
  EXPECT_TRUE(IsOnPages(mesh.Triangles));
}

TEST(HugePages, KeepWhatGrowsAndShrinks)
{
  Numbers numbers;
  for (std::size_t i = 0; i < 3 * Large; ++i)
  {
    numbers.push_back(static_cast<double>(i));
  }
  const Numbers copy = numbers;
  for (std::size_t count : { 3 * Large, Large, Large - 1, std::size_t(1) })
  {
    numbers.resize(count);
    numbers.shrink_to_fit();
    ASSERT_EQ(numbers.front(), 0.0);
    ASSERT_EQ(numbers.back(), static_cast<double>(count - 1));
  }
  EXPECT_EQ(copy.back(), static_cast<double>(3 * Large - 1));
}
