// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dRegularMoves.h"

#include "LocalMap/Bounded/lms3dVertexFit.h"

bool lms3dRegularMoves::MayLeaveBorder(
  const lms3dVertexStars& stars, std::int32_t last, std::int32_t middle, std::int32_t next) const
{
  return this->Shortcuts.IsAllowed(
    stars.GetVertex(last), stars.GetVertex(middle), stars.GetVertex(next));
}

bool lms3dRegularMoves::MayLeaveOffset(
  const lms3dVertexStars& stars, std::int32_t last, std::int32_t middle, std::int32_t next) const
{
  return this->Shortcuts.PassesSameGates(
    stars.GetVertex(last), stars.GetVertex(middle), stars.GetVertex(next));
}

// The triangle in place of the vertex comes first, because the surface moves most there.
bool lms3dRegularMoves::KeepsBound(
  const lms3dVertexStars& stars, std::int32_t from, std::int32_t to) const
{
  const lms3dVertexStars::Vertex& target = stars.GetVertex(to);
  const lms3dVector& at = stars.GetVertex(from).Corner.Position;
  const auto isOnLeft = [&](const lms3dVector& a, const lms3dVector& b)
  { return lms3dDot(lms3dCross(b, a), target.Corner.Position) >= 0.0; };
  const auto isInPlace = [&](std::int32_t next, std::int32_t last)
  {
    return isOnLeft(stars.GetVertex(next).Corner.Position, at) &&
      isOnLeft(at, stars.GetVertex(last).Corner.Position);
  };
  const auto isAllowed = [&](std::int32_t next, std::int32_t last)
  {
    return lms3dVertexFit::Allows(
      this->Demands, target.Corner, target.Inverse, lms3dVertexFit::GetSide(stars, next, last));
  };
  return stars.ForEachSide(from, to,
           [&](std::int32_t next, std::int32_t last)
           { return !isInPlace(next, last) || isAllowed(next, last); }) &&
    stars.ForEachSide(from, to,
      [&](std::int32_t next, std::int32_t last)
      { return isInPlace(next, last) || isAllowed(next, last); });
}
