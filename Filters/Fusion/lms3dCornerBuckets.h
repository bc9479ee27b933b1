// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Finds the corners near a triangle.
 */
#ifndef lms3dCornerBuckets_h
#define lms3dCornerBuckets_h

#include "Fusion/lms3dBlockIndex.h"
#include "Fusion/lms3dRasterRows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

/// Corners are numbers. Coordinates are cells.
class lms3dCornerBuckets
{
public:
  using Corner = std::int32_t;

  void Add(Corner corner, const lms3dPoint2& point) { this->GetBucket(point).push_back(corner); }

  /// Takes a corner out that was added with this point.
  void Remove(Corner corner, const lms3dPoint2& point)
  {
    std::vector<Corner>& bucket = this->GetBucket(point);
    *std::find(bucket.begin(), bucket.end(), corner) = bucket.back();
    bucket.pop_back();
  }

  /// Whether `predicate` holds for all corners in a triangle. It is also asked about other corners.
  template <typename Predicate>
  bool AllOf(const std::array<lms3dPoint2, 3>& triangle, const Predicate& predicate) const
  {
    std::array<lms3dPoint2, 3> scaled = triangle;
    for (lms3dPoint2& point : scaled)
    {
      point = { point[0] / Size, point[1] / Size };
    }
    const lms3dCellBox box = lms3dGetTouchedBox(scaled);
    // The buckets of a small box cost less than the rows of a triangle.
    if (box.Right - box.Left <= 1 && box.Top - box.Bottom <= 1)
    {
      return this->AllInRow(box.Bottom, box.Left, box.Right, predicate) &&
        (box.Top == box.Bottom || this->AllInRow(box.Top, box.Left, box.Right, predicate));
    }
    return lms3dForTouchedRows(scaled,
      [&](std::int32_t row, std::int32_t first, std::int32_t last)
      { return this->AllInRow(row, first, last, predicate); });
  }

private:
  /// Cells: the size of a bucket.
  static constexpr double Size = 16.0;

  template <typename Predicate>
  bool AllInRow(
    std::int32_t v, std::int32_t first, std::int32_t last, const Predicate& predicate) const
  {
    for (std::int32_t u = first; u <= last; ++u)
    {
      const int bucket = this->Numbers.Find(u, v);
      if (bucket >= 0 &&
        !std::all_of(this->Corners[bucket].begin(), this->Corners[bucket].end(), predicate))
      {
        return false;
      }
    }
    return true;
  }

  std::vector<Corner>& GetBucket(const lms3dPoint2& point)
  {
    const auto u = static_cast<std::int32_t>(std::floor(point[0] / Size));
    const auto v = static_cast<std::int32_t>(std::floor(point[1] / Size));
    const int found = this->Numbers.Find(u, v);
    if (found >= 0)
    {
      return this->Corners[found];
    }
    this->Numbers.Add(u, v, static_cast<int>(this->Corners.size()));
    return this->Corners.emplace_back();
  }

  lms3dBlockIndex Numbers;
  std::vector<std::vector<Corner>> Corners;
};

#endif
