// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Finds the corners near a triangle.
 */
#ifndef lms3dCornerBuckets_h
#define lms3dCornerBuckets_h

#include "Fusion/Cells/lms3dBlockIndex.h"
#include "Fusion/Cells/lms3dRasterRows.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

/// Corners are numbers. Coordinates are cells.
class lms3dCornerBuckets
{
public:
  using Corner = std::int32_t;

  /// The corners have the numbers of their points. `isLeft` says of a number whether the corner is
  /// one that can be found.
  template <typename Predicate>
  void Fill(const std::vector<lms3dPoint2>& points, const Predicate& isLeft)
  {
    this->BucketOf.assign(points.size(), -1);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      if (isLeft(static_cast<Corner>(i)))
      {
        this->BucketOf[i] = this->GetBucket(points[i]);
        ++this->Buckets[this->BucketOf[i]].Count;
      }
    }
    std::size_t first = 0;
    for (Bucket& bucket : this->Buckets)
    {
      bucket.First = first;
      first += std::exchange(bucket.Count, 0);
    }
    this->Places.resize(first);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      if (this->BucketOf[i] >= 0)
      {
        Bucket& bucket = this->Buckets[this->BucketOf[i]];
        this->Places[bucket.First + bucket.Count++] = { points[i], static_cast<Corner>(i) };
      }
    }
  }

  void Remove(Corner corner)
  {
    Bucket& bucket = this->Buckets[this->BucketOf[corner]];
    --bucket.Count;
    std::size_t place = bucket.First;
    while (this->Places[place].Number != corner)
    {
      ++place;
    }
    this->Places[place] = this->Places[bucket.First + bucket.Count];
  }

  /// Whether `predicate` holds for the points and numbers of all corners in a triangle. It is also
  /// asked about others.
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

  struct Bucket
  {
    std::size_t First = 0;
    std::size_t Count = 0;
  };

  struct Place
  {
    lms3dPoint2 Point;
    Corner Number;
  };

  template <typename Predicate>
  bool AllInRow(
    std::int32_t v, std::int32_t first, std::int32_t last, const Predicate& predicate) const
  {
    for (std::int32_t u = first; u <= last; ++u)
    {
      const int number = this->Numbers.Find(u, v);
      if (number < 0)
      {
        continue;
      }
      const Bucket& bucket = this->Buckets[number];
      const Place* const places = this->Places.data() + bucket.First;
      for (std::size_t i = 0; i < bucket.Count; ++i)
      {
        if (!predicate(places[i].Point, places[i].Number))
        {
          return false;
        }
      }
    }
    return true;
  }

  int GetBucket(const lms3dPoint2& point)
  {
    const auto u = lms3dGetCellOf(point[0] / Size);
    const auto v = lms3dGetCellOf(point[1] / Size);
    int number = this->Numbers.Find(u, v);
    if (number < 0)
    {
      number = static_cast<int>(this->Buckets.size());
      this->Numbers.Add(u, v, number);
      this->Buckets.emplace_back();
    }
    return number;
  }

  lms3dBlockIndex Numbers;
  std::vector<Bucket> Buckets;
  /// -1 for a corner that cannot be found.
  std::vector<int> BucketOf;
  std::vector<Place> Places;
};

#endif
