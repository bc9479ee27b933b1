// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dBorderShortcuts.h"

#include "Geometry/lms3dAngle.h"
#include "LocalMap/Borders/lms3dRangeSupport.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
// Radians that the border keeps from beams when it moves.
constexpr double BeamMargin = 1e-4;
// Radians within which a vertex lies in a gate.
constexpr double Rounding = 1e-9;
// The longest part of a border and the widest column, radians.
constexpr double MaximumAngle = 1.5;
constexpr double MaximumColumn = 0.5;
// The arc of a great circle between two columns has larger tangents than its ends: by at most this
// share of their tangents, over the square of the columns' distance.
constexpr double BulgeShare = 0.3;
// Room for the gates of most parts of a border.
constexpr std::size_t UsualGates = 16;

double GetTangent(const lms3dVector& direction)
{
  return direction[2] / std::sqrt(direction[0] * direction[0] + direction[1] * direction[1]);
}
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

// Appends the gates that an arc of the border passes or touches. Returns false if they are not
// certain.
bool lms3dBorderShortcuts::FindGates(
  const Vertex& from, const Vertex& to, std::vector<Gate>& gates) const
{
  const std::vector<double>& azimuths = this->Sphere.GetAzimuths();
  const std::vector<double>& tangents = this->Sphere.GetTangents();
  const int columns = this->Sphere.GetNumberOfColumns();
  const lms3dVector normal = lms3dCross(from.Corner.Position, to.Corner.Position);
  const Arc arc = { from.Corner.Position, to.Corner.Position, normal,
    Rounding * lms3dGetLength(normal) };
  double width = to.Corner.Azimuth - from.Corner.Azimuth;
  width -= 2.0 * lms3dPi * std::round(width / (2.0 * lms3dPi));
  if (!(std::abs(width) < MaximumAngle) || from.Corner.IsPole || to.Corner.IsPole)
  {
    return false;
  }
  const bool isTurned = width < 0.0;
  double low = isTurned ? to.Corner.Azimuth : from.Corner.Azimuth;
  double tangent = GetTangent(isTurned ? arc.To : arc.From);
  const double lastTangent = GetTangent(isTurned ? arc.From : arc.To);
  low -= 2.0 * lms3dPi * std::floor((low - azimuths.front()) / (2.0 * lms3dPi));
  const double high = low + std::abs(width) + Rounding;
  low -= Rounding;
  int column =
    static_cast<int>(std::lower_bound(azimuths.begin(), azimuths.end(), low) - azimuths.begin());
  double turns = 0.0;
  while (true)
  {
    const int before = (column + columns - 1) % columns;
    column = column == columns ? 0 : column;
    turns += column == 0 && before == columns - 1 && low > azimuths.front() ? 2.0 * lms3dPi : 0.0;
    const double azimuth = azimuths[column] + turns;
    double step = azimuths[column] - azimuths[before];
    step += step < 0.0 ? 2.0 * lms3dPi : 0.0;
    if (step > MaximumColumn)
    {
      return false;
    }
    if (azimuth > high)
    {
      this->AppendGatesOfRows(arc, before, step, tangent, lastTangent, gates);
      return true;
    }
    // Where the border passes the column.
    const std::array<double, 2>& level = this->Sphere.GetHorizontal(column);
    if (std::abs(normal[2]) <= arc.Tolerance)
    {
      return false;
    }
    const double here = -(normal[0] * level[0] + normal[1] * level[1]) / normal[2];
    this->AppendGatesOfRows(arc, before, step, tangent, here, gates);
    const auto above = std::upper_bound(tangents.begin(), tangents.end(), here);
    if (above == tangents.begin() || above == tangents.end())
    {
      return false;
    }
    gates.push_back({ this->Sphere.GetIndex(column, static_cast<int>(above - tangents.begin()) - 1),
      lms3dBeamSphere::Up });
    tangent = here;
    ++column;
  }
}

// Appends the gates between a column and the next one that an arc passes. There, its tangents lie
// between two.
void lms3dBorderShortcuts::AppendGatesOfRows(
  const Arc& arc, int column, double width, double low, double high, std::vector<Gate>& gates) const
{
  const std::vector<double>& tangents = this->Sphere.GetTangents();
  const GridIndex start = this->Sphere.GetIndex(column, 0);
  const GridIndex toRight = this->Sphere.GetNeighbor(start, lms3dBeamSphere::Right) - start;
  const double largest = std::max(std::abs(low), std::abs(high));
  const double bulge = Rounding + BulgeShare * width * width * largest;
  const int first = static_cast<int>(
    std::lower_bound(tangents.begin(), tangents.end(), std::min(low, high) - bulge) -
    tangents.begin());
  const int last = static_cast<int>(
    std::upper_bound(tangents.begin(), tangents.end(), std::max(low, high) + bulge) -
    tangents.begin());
  for (int row = first; row < last; ++row)
  {
    if (this->Sphere.IsPoleRow(row))
    {
      continue;
    }
    const GridIndex index = start + row;
    const lms3dVector left = this->Sphere.GetDirection(index);
    const lms3dVector right = this->Sphere.GetDirection(index + toRight);
    const lms3dVector across = lms3dCross(left, right);
    const auto areApart = [](double a, double b, double tolerance)
    { return std::min(a, b) <= tolerance && std::max(a, b) >= -tolerance; };
    if (areApart(lms3dDot(arc.Normal, left), lms3dDot(arc.Normal, right), arc.Tolerance) &&
      areApart(
        lms3dDot(across, arc.From), lms3dDot(across, arc.To), Rounding * lms3dGetLength(across)))
    {
      gates.push_back({ index, lms3dBeamSphere::Right });
    }
  }
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
