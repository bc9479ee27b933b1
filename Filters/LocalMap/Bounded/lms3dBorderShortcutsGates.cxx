// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
// The gates that the border passes between two vertices.
#include "LocalMap/Bounded/lms3dBorderShortcuts.h"

#include "Geometry/lms3dAngle.h"
#include "LocalMap/Bounded/lms3dSortedSearch.h"

#include <algorithm>
#include <cmath>

namespace
{
// The longest part of a border and the widest column, radians.
constexpr double MaximumAngle = 1.5;
constexpr double MaximumColumn = 0.5;
// The arc of a great circle between two columns has larger tangents than its ends: by at most this
// share of their tangents, over the square of the columns' distance.
constexpr double BulgeShare = 0.3;

double GetTangent(const lms3dVector& direction)
{
  return direction[2] / std::sqrt(direction[0] * direction[0] + direction[1] * direction[1]);
}
} // namespace

// Appends the gates that an arc of the border passes or touches. Returns false if they are not
// certain.
bool lms3dBorderShortcuts::FindGates(
  const Vertex& from, const Vertex& to, std::vector<Gate>& gates) const
{
  const std::vector<double>& azimuths = this->Sphere.GetAzimuths();
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
  if (!std::isfinite(tangent) || !std::isfinite(lastTangent))
  {
    return false;
  }
  low -= 2.0 * lms3dPi * std::floor((low - azimuths.front()) / (2.0 * lms3dPi));
  const double high = low + std::abs(width) + Rounding;
  low -= Rounding;
  const int near = static_cast<int>((low - azimuths.front()) * columns / (2.0 * lms3dPi));
  int column = lms3dFindEndOf(azimuths, near, [low](double azimuth) { return azimuth < low; });
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
    const int above = this->FindRowAbove(here);
    if (above == 0 || above == this->Sphere.GetNumberOfRows())
    {
      return false;
    }
    gates.push_back({ this->Sphere.GetIndex(column, above - 1), lms3dBeamSphere::Up });
    tangent = here;
    ++column;
  }
}

// Appends the gates between a column and the next one that an arc passes. There, its tangents lie
// between two.
void lms3dBorderShortcuts::AppendGatesOfRows(
  const Arc& arc, int column, double width, double low, double high, std::vector<Gate>& gates) const
{
  const GridIndex start = this->Sphere.GetIndex(column, 0);
  const GridIndex toRight = this->Sphere.GetNeighbor(start, lms3dBeamSphere::Right) - start;
  const double largest = std::max(std::abs(low), std::abs(high));
  const double bulge = Rounding + BulgeShare * width * width * largest;
  const double lowest = std::min(low, high) - bulge;
  const int first = lms3dFindEndOf(this->Sphere.GetTangents(), this->Sphere.GetRowNear(lowest),
    [lowest](double tangent) { return tangent < lowest; });
  const int last = this->FindRowAbove(std::max(low, high) + bulge);
  for (int row = first; row < last; ++row)
  {
    if (this->Sphere.IsPoleRow(row))
    {
      continue;
    }
    const GridIndex index = start + row;
    const lms3dVector left = this->Sphere.GetDirection(index);
    const lms3dVector right = this->Sphere.GetDirection(index + toRight);
    const auto areApart = [](double a, double b, double tolerance)
    { return std::min(a, b) <= tolerance && std::max(a, b) >= -tolerance; };
    if (!areApart(lms3dDot(arc.Normal, left), lms3dDot(arc.Normal, right), arc.Tolerance))
    {
      continue;
    }
    const lms3dVector across = lms3dCross(left, right);
    if (areApart(
          lms3dDot(across, arc.From), lms3dDot(across, arc.To), Rounding * lms3dGetLength(across)))
    {
      gates.push_back({ index, lms3dBeamSphere::Right });
    }
  }
}

// The first row with a larger tangent, or the number of rows.
int lms3dBorderShortcuts::FindRowAbove(double tangent) const
{
  return lms3dFindEndOf(this->Sphere.GetTangents(), this->Sphere.GetRowNear(tangent),
    [tangent](double ofRow) { return ofRow <= tangent; });
}
