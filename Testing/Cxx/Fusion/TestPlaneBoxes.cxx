// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Compares the search for planes nearby with a look at all of them.
 */
#include "Fusion/Planes/lms3dPlaneBoxes.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <vector>

TEST(LMS3DPlaneBoxes, FindTheBoxesNearAnother)
{
  constexpr int Count = 300;
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> place(-5.0, 5.0);
  std::exponential_distribution<double> extent(2.0);
  const auto makeBox = [&]
  {
    const lms3dVector low = { place(generator), place(generator), place(generator) };
    return lms3dWorldBox{ low,
      lms3dAdd(low, { extent(generator), extent(generator), extent(generator) }) };
  };
  lms3dPlaneBoxes boxes(0.5);
  for (int i = 0; i < Count; ++i)
  {
    boxes.AddPlane();
  }
  for (int i = 0; i < 2 * Count; ++i)
  {
    const lms3dWorldBox box = makeBox();
    boxes.Grow(i % (Count - 1), box.Low);
    boxes.Grow(i % (Count - 1), box.High);
    if (i % 5 == 0)
    {
      boxes.Remove(generator() % Count);
    }
    const lms3dWorldBox wanted = makeBox();
    constexpr std::size_t End = Count - 20;
    std::vector<int> expected;
    for (std::size_t plane = 0; plane < End; ++plane)
    {
      if (wanted.IsNear(boxes.GetBox(plane), 0.1))
      {
        expected.push_back(static_cast<int>(plane));
      }
    }
    ASSERT_EQ(boxes.Find(wanted, 0.1, End), expected);
  }
}
