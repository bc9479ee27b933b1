// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Returns of a ball in any order, and all that a grid of them holds.
 */
#ifndef RangeGridFixtures_h
#define RangeGridFixtures_h

#include "LocalMap/Grid/lms3dRangeGrid.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// The returns of a scan. Both ends of each fan are poles. All ranges differ.
struct Returns
{
  static constexpr int Beams = 129;
  static constexpr int Turns = 400;
  /// A thread takes a quarter at once.
  static constexpr int Count = 48000;

  /// One beam in 131 has no return, in each turn another one.
  Returns();

  /// The same returns in another order.
  Returns Sort(const std::vector<std::size_t>& order) const;
  /// The first returns up to one of them, not included.
  Returns GetFirst(int count) const;
  /// All returns but one.
  Returns LeaveOut(int index) const;
  /// The same returns, with the beams in falling order.
  Returns Reverse() const;

  std::vector<double> Ranges;
  std::vector<int> BeamIds;
};

/// All that a grid holds, its halo included, with returns by their beams.
struct GridContent
{
  std::vector<double> Ranges;
  std::vector<std::int32_t> Vertices;
  std::vector<std::int32_t> FirstVertices;
  std::vector<int> BeamsOfVertices;
  std::vector<std::vector<double>> RangesOfPoles;

  bool operator==(const GridContent& other) const
  {
    return this->Ranges == other.Ranges && this->Vertices == other.Vertices &&
      this->FirstVertices == other.FirstVertices &&
      this->BeamsOfVertices == other.BeamsOfVertices && this->RangesOfPoles == other.RangesOfPoles;
  }
};

/// Builds a grid on a number of threads.
class RangeGridBuilder
{
public:
  explicit RangeGridBuilder(int threads)
    : Threads(threads)
  {
  }

  GridContent Build(const Returns& returns);

  /// The message of the error, or an empty one.
  std::string GetError(const Returns& returns);

private:
  /// Degrees.
  static constexpr double Alpha[2] = { -90.0, 90.0 };
  static constexpr double Beta[2] = { 0.0, 360.0 };

  const int Threads;
  const lms3dScanGeometry Geometry{ Alpha, Returns::Beams, Beta, Returns::Turns };
  lms3dRangeGrid Grid;
};

#endif
