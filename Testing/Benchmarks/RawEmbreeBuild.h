// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The least that building for a scan can cost: Embree's own tree over ready-made boxes.
 */
#ifndef RawEmbreeBuild_h
#define RawEmbreeBuild_h

#include <array>
#include <vector>

class vtkPolyData;

class RawEmbreeBuild
{
public:
  enum Quality
  {
    LOW,
    MEDIUM
  };

  /// Makes one box around each triangle.
  explicit RawEmbreeBuild(vtkPolyData* surface);

  /// The time of making a robust scene of one user geometry and of committing it.
  double GetMilliseconds(Quality quality, int threads) const;

private:
  struct Box
  {
    std::array<float, 3> Low;
    std::array<float, 3> High;
  };
  std::vector<Box> Boxes;
};

#endif
