// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The corners of outlines that become simpler.
 */
#ifndef lms3dOutlineCorners_h
#define lms3dOutlineCorners_h

#include "Fusion/Outlines/lms3dRasterOutline.h"
#include "Triangulation/lms3dOrientation.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/// Corners keep their numbers. Coordinates are cells.
class lms3dOutlineCorners
{
public:
  using Corner = std::int32_t;
  using Triangle = std::array<lms3dPoint2, 3>;

  /// `isFixed` says, in the order of the loops, which corners must stay where they are.
  lms3dOutlineCorners(const std::vector<lms3dLoop>& loops, std::vector<bool> isFixed);

  /// The number of corners, with those that have gone.
  Corner GetSize() const { return static_cast<Corner>(this->Points.size()); }
  const std::vector<lms3dPoint2>& GetPoints() const { return this->Points; }
  const lms3dPoint2& operator[](Corner corner) const { return this->Points[corner]; }
  Corner GetNext(Corner corner) const { return this->Next[corner]; }
  Corner GetPrevious(Corner corner) const { return this->Previous[corner]; }
  bool IsFixed(Corner corner) const { return this->Fixed[corner]; }
  bool HasGone(Corner corner) const { return this->Gone[corner]; }

  /// Whether the outline of a corner has no more than three.
  bool IsOfTriangle(Corner corner) const
  {
    return this->Next[this->Next[corner]] == this->Previous[corner];
  }

  /// A corner between its neighbours.
  Triangle GetTriangle(Corner corner) const
  {
    return { this->Points[this->Previous[corner]], this->Points[corner],
      this->Points[this->Next[corner]] };
  }

  void Remove(Corner corner);
  void Move(Corner corner, const lms3dPoint2& point) { this->Points[corner] = point; }

  /// Returns the largest distance of the outline's first corners between two corners, squared, or
  /// one that is larger than `limit`. `distance` returns that of a point.
  template <typename Distance>
  double GetDeviation(Corner from, Corner to, double limit, const Distance& distance) const
  {
    double deviation = 0.0;
    for (Corner corner = this->FirstNext[from]; corner != to && deviation <= limit;
         corner = this->FirstNext[corner])
    {
      deviation = std::max(deviation, distance(this->FirstPoints[corner]));
    }
    return deviation;
  }

  /// Where a corner was at first.
  const lms3dPoint2& GetFirstPoint(Corner corner) const { return this->FirstPoints[corner]; }

  /// Returns the first of the outline's first corners between two corners that is not near. Returns
  /// `to` if all are.
  template <typename Predicate>
  Corner FindFar(Corner from, Corner to, const Predicate& isNear) const
  {
    Corner corner = this->FirstNext[from];
    while (corner != to && isNear(this->FirstPoints[corner]))
    {
      corner = this->FirstNext[corner];
    }
    return corner;
  }

  std::vector<lms3dLoop> GetLoops() const;

private:
  std::vector<lms3dPoint2> Points;
  std::vector<Corner> Next;
  std::vector<Corner> Previous;
  std::vector<bool> Fixed;
  std::vector<bool> Gone;
  /// Before any corner moved or went.
  std::vector<lms3dPoint2> FirstPoints;
  std::vector<Corner> FirstNext;
  /// The first corner of each loop, and the end.
  std::vector<Corner> Ends;
};

#endif
