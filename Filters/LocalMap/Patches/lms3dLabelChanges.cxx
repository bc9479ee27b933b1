// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Patches/lms3dLabelChanges.h"

#include "Geometry/lms3dWideLoops.h"

#include <cstddef>
#include <cstring>

namespace
{
// Compares labels with the labels of neighbours on one side. Sets `border` and `gate` in the
// changes. `joins` has the bit `join` where neighbours lie on one surface. Without branches, so
// that the compiler makes it a loop over vectors.
LMS3D_WIDE_LOOPS
void AddChanges(const std::int32_t* labels, const std::int32_t* neighbors,
  const std::uint8_t* joins, int count, int join, std::uint8_t* changes)
{
  const int border = join == lms3dBeamSphere::JoinedUp ? lms3dLabelChanges::BorderUp
                                                       : lms3dLabelChanges::BorderRight;
  const int gate =
    join == lms3dBeamSphere::JoinedUp ? lms3dLabelChanges::GateUp : lms3dLabelChanges::GateRight;
  for (int i = 0; i < count; ++i)
  {
    const bool isJoined = (joins[i] & join) != 0;
    const bool differs = labels[i] != neighbors[i];
    const int change =
      (differs & isJoined ? border : 0) | (differs | (!isJoined & (labels[i] >= 0)) ? gate : 0);
    changes[i] = static_cast<std::uint8_t>(changes[i] | change);
  }
}
} // namespace

const std::vector<std::uint8_t>& lms3dLabelChanges::Find(int column)
{
  const int rows = this->Sphere.GetNumberOfRows();
  const GridIndex start = this->Sphere.GetIndex(column, 0);
  const std::int32_t* const labels = this->Labels.data() + start;
  const std::int32_t* const toRight =
    this->Labels.data() + this->Sphere.GetNeighbor(start, lms3dBeamSphere::Right);
  const std::uint8_t* const joins = this->Sphere.GetJoins() + start;
  this->Changes.assign(rows, 0);
  AddChanges(labels, labels + 1, joins, rows - 1, lms3dBeamSphere::JoinedUp, this->Changes.data());
  AddChanges(labels, toRight, joins, rows, lms3dBeamSphere::JoinedRight, this->Changes.data());
  return this->Changes;
}

lms3dLabelChanges::GridIndex lms3dLabelChanges::FindFirst(
  const std::uint8_t* bytes, GridIndex from, GridIndex end, int any)
{
  constexpr GridIndex BytesOfWord = sizeof(std::uint64_t);
  constexpr std::uint64_t EachByte = 0x0101010101010101;
  const std::uint64_t anyInWord = EachByte * static_cast<std::uint64_t>(any);
  GridIndex at = from;
  while (at < end && (bytes[at] & any) == 0)
  {
    std::uint64_t word = anyInWord;
    if (at + BytesOfWord <= end)
    {
      std::memcpy(&word, bytes + at, sizeof(word));
    }
    at += (word & anyInWord) == 0 ? BytesOfWord : 1;
  }
  return at;
}
