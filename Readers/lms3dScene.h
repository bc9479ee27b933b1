// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What an engine reads from a file: shapes, and words on what it could not read.
 */
#ifndef lms3dScene_h
#define lms3dScene_h

#include <array>
#include <cstdint>
#include <string>
#include <vector>

struct lms3dShape
{
  /// The name that the file gives it, or empty.
  std::string Name;
  std::array<std::uint8_t, 4> Color;
  /// World coordinates, metres.
  std::vector<std::array<double, 3>> Points;
  std::vector<std::array<std::int64_t, 3>> Triangles;
};

struct lms3dScene
{
  std::vector<lms3dShape> Shapes;
  std::vector<std::string> Messages;
};

#endif
