// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A finished scan, which nobody changes any more.
 */
#ifndef lms3dSnapshot_h
#define lms3dSnapshot_h

#include "LMS3DScanner.hh"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

struct lms3dSnapshot
{
  LMS3D::ScanHeader Header;
  /// How long the scan and its map took.
  double ScanSeconds = 0.0;
  double MapSeconds = 0.0;
  /// Metres, 0 without a return; turn * beams of the fan + beam.
  std::vector<float> Ranges;
  /// x, y, z of each point of the local map, metres, world coordinates.
  std::vector<double> MapPoints;
  /// Three point numbers of each triangle.
  std::vector<std::uint32_t> MapTriangles;

  /// Of what grows with beams and map.
  std::size_t GetBytes() const
  {
    return sizeof(float) * this->Ranges.size() + sizeof(double) * this->MapPoints.size() +
      sizeof(std::uint32_t) * this->MapTriangles.size();
  }
};

using lms3dSnapshotPointer = std::shared_ptr<const lms3dSnapshot>;

#endif
