// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dBorderShortcuts.h"

#include "LocalMap/Borders/lms3dRangeSupport.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
// Radians that the border keeps from beams when it moves.
constexpr double BeamMargin = 1e-4;
// Room for the gates of most parts of a border.
constexpr std::size_t UsualGates = 16;
} // namespace

lms3dBorderShortcuts::lms3dBorderShortcuts(
  const lms3dBeamSphere& sphere, const lms3dPatches& patches, double tolerance)
  : Sphere(sphere)
  , Patches(patches)
  , Margins(sphere, patches, tolerance)
{
}

bool lms3dBorderShortcuts::IsAllowed(
  const Vertex& last, const Vertex& middle, const Vertex& next) const
{
  return this->MayLeaveOut(
    last, middle, next, [&](const Gate& gate) { return this->IsSupported(gate, last, next); });
}

bool lms3dBorderShortcuts::PassesSameGates(
  const Vertex& last, const Vertex& middle, const Vertex& next) const
{
  return this->MayLeaveOut(last, middle, next, [](const Gate&) { return true; });
}

lms3dBorderShortcuts::Support lms3dBorderShortcuts::GetSupportAtDepthSteps(
  const Vertex& from, const Vertex& to) const
{
  std::vector<Gate> gates;
  gates.reserve(UsualGates);
  if (!this->FindGates(from, to, gates))
  {
    return Support::Unsupported;
  }
  const auto last = std::partition(
    gates.begin(), gates.end(), [this](const Gate& gate) { return this->IsDepthStep(gate); });
  if (last == gates.begin())
  {
    return Support::NoDepthStep;
  }
  return std::all_of(
           gates.begin(), last, [&](const Gate& gate) { return this->IsSupported(gate, from, to); })
    ? Support::Supported
    : Support::Unsupported;
}

bool lms3dBorderShortcuts::IsDepthStep(const Gate& gate) const
{
  const GridIndex other = this->Sphere.GetNeighbor(gate.Index, gate.Side);
  return this->Patches.Labels[gate.Index] >= 0 && this->Patches.Labels[other] >= 0 &&
    !this->Sphere.IsJoined(gate.Index, gate.Side);
}

template <typename Predicate>
bool lms3dBorderShortcuts::MayLeaveOut(
  const Vertex& last, const Vertex& middle, const Vertex& next, const Predicate& isSupported) const
{
  if (this->AreBeamsBetween(last, middle, next))
  {
    return false;
  }
  std::vector<Gate> before;
  std::vector<Gate> after;
  before.reserve(UsualGates);
  after.reserve(UsualGates);
  if (!this->FindGates(last, next, after) ||
    !std::all_of(after.begin(), after.end(), isSupported) ||
    !this->FindGates(last, middle, before) || !this->FindGates(middle, next, before))
  {
    return false;
  }
  std::sort(after.begin(), after.end());
  return std::all_of(before.begin(), before.end(),
    [&](const Gate& gate) { return std::binary_search(after.begin(), after.end(), gate); });
}

bool lms3dBorderShortcuts::AreBeamsBetween(
  const Vertex& last, const Vertex& middle, const Vertex& next) const
{
  const lms3dTriangleCorner* a = &last.Corner;
  const lms3dTriangleCorner* b = &next.Corner;
  if (lms3dDot(lms3dCross(b->Position, a->Position), middle.Corner.Position) < 0.0)
  {
    std::swap(a, b);
  }
  const lms3dTriangleRasterizer triangle(this->Sphere, middle.Corner, *a, *b, BeamMargin);
  return !triangle.ForEachColumnWhile([](int, int, int) { return false; });
}

// Whether the returns support the range of the surface where its border passes a gate.
bool lms3dBorderShortcuts::IsSupported(const Gate& gate, const Vertex& from, const Vertex& to) const
{
  const lms3dVector& a = from.Corner.Position;
  const lms3dVector& b = to.Corner.Position;
  const lms3dVector normal = lms3dCross(a, b);
  const double square = lms3dDot(normal, normal);
  GridIndex own = gate.Index;
  GridIndex other = this->Sphere.GetNeighbor(own, gate.Side);
  int side = gate.Side;
  // The surface lies where the product with the normal is below 0.
  if (lms3dDot(normal, this->Sphere.GetDirection(own)) > 0.0)
  {
    std::swap(own, other);
    side = (side + 2) % 4;
  }
  const lms3dVector here = this->Sphere.GetDirection(own);
  const lms3dVector there = this->Sphere.GetDirection(other);
  const double sideOfOwn = lms3dDot(normal, here);
  const double sideOfOther = lms3dDot(normal, there);
  const double rounding = Rounding * std::sqrt(square);
  if (!(sideOfOwn < -rounding) || !(sideOfOther > rounding) || this->Patches.Labels[own] < 0 ||
    (this->Patches.Labels[other] >= 0 && this->Sphere.IsJoined(own, side)))
  {
    return false;
  }
  const double at = sideOfOwn / (sideOfOwn - sideOfOther);
  const lms3dVector point = lms3dAdd(lms3dScale(here, 1.0 - at), lms3dScale(there, at));
  const double inverse = (lms3dDot(lms3dCross(point, b), normal) * from.Inverse +
                           lms3dDot(lms3dCross(a, point), normal) * to.Inverse) /
    square;
  const double length = lms3dGetLength(point);
  return lms3dRangeSupport::GetInterval(
    this->Sphere.GetRange(own), this->Margins.GetMargin(own, side), lms3dDot(point, here) / length)
    .Contains(inverse / length);
}
