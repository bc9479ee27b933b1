// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Finds where patches meet.
 */
#ifndef lms3dLabelChanges_h
#define lms3dLabelChanges_h

#include "LocalMap/Patches/lms3dPatches.h"

#include <cstdint>
#include <vector>

/**
 * Compares the entries of a column of lms3dBeamSphere with their upper and their right neighbours.
 * Most entries lie inside of a patch, and many of them are compared at a time.
 */
class lms3dLabelChanges
{
public:
  using GridIndex = lms3dBeamSphere::GridIndex;

  /// What two neighbours have between them, as bits.
  enum Change : std::uint8_t
  {
    /// They belong to different patches, and lie on one surface.
    BorderUp = 1,
    BorderRight = 2,
    /// They belong to different patches, or to a patch and do not lie on one surface.
    GateUp = 4,
    GateRight = 8
  };

  /// Keeps references.
  lms3dLabelChanges(const lms3dBeamSphere& sphere, const lms3dBeamVector<std::int32_t>& labels)
    : Sphere(sphere)
    , Labels(labels)
    , Changes(sphere.GetNumberOfRows())
  {
  }

  /// The changes of each row of a column. They stay until the next call.
  const std::vector<std::uint8_t>& Find(int column);

  /// Calls visit(index, changes) for each entry of a column that has any of some changes, from the
  /// lowest row to the highest.
  template <typename Visitor>
  void ForEach(int column, int any, const Visitor& visit)
  {
    const std::uint8_t* const changes = this->Find(column).data();
    const GridIndex start = this->Sphere.GetIndex(column, 0);
    const int rows = this->Sphere.GetNumberOfRows();
    for (int row = FindFirst(changes, 0, rows, any); row < rows;
         row = FindFirst(changes, row + 1, rows, any))
    {
      visit(start + row, changes[row]);
    }
  }

  /// Calls visit(index, neighbor) for each two neighbours that have a border between them: those
  /// in a column, and those in it and the next one.
  template <typename Visitor>
  void ForEachBorder(int column, const Visitor& visit)
  {
    const GridIndex start = this->Sphere.GetIndex(column, 0);
    const GridIndex toRight = this->Sphere.GetNeighbor(start, lms3dBeamSphere::Right) - start;
    this->ForEach(column, BorderUp | BorderRight,
      [&](GridIndex index, int changes)
      {
        if (changes & BorderUp)
        {
          visit(index, index + 1);
        }
        if (changes & BorderRight)
        {
          visit(index, index + toRight);
        }
      });
  }

  /// The first of some bytes, from one on, that has any of some bits; `end` if none has.
  static GridIndex FindFirst(const std::uint8_t* bytes, GridIndex from, GridIndex end, int any);

private:
  const lms3dBeamSphere& Sphere;
  const lms3dBeamVector<std::int32_t>& Labels;
  std::vector<std::uint8_t> Changes;
};

#endif
