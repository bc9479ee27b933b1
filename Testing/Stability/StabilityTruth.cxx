// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "StabilityTruth.h"

#include <algorithm>
#include <cmath>

namespace
{
// Relative. Coarser than what single precision rounds away but at a grazing angle, and finer than
// any distance between two surfaces of the situations.
constexpr double LargestError = 1e-6;

// Below, products of coordinates leave the numbers that the reference takes.
constexpr double MinimumSize = 1e-30;

bool IsFinite(const Vector& p)
{
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

lms3dTriangleMesh KeepFinite(const lms3dTriangleMesh& mesh)
{
  lms3dTriangleMesh kept;
  kept.Points = mesh.Points;
  std::copy_if(mesh.Triangles.begin(), mesh.Triangles.end(), std::back_inserter(kept.Triangles),
    [&mesh](const std::array<std::uint32_t, 3>& triangle)
    {
      return std::all_of(triangle.begin(), triangle.end(),
        [&mesh](std::uint32_t corner) { return IsFinite(mesh.Points[corner]); });
    });
  return kept;
}

double GetSize(const lms3dTriangleMesh& mesh)
{
  double size = 0.0;
  for (const std::array<std::uint32_t, 3>& triangle : mesh.Triangles)
  {
    for (std::uint32_t corner : triangle)
    {
      for (double x : mesh.Points[corner])
      {
        size = std::max(size, std::abs(x));
      }
    }
  }
  return size;
}

// Exact, as long as nothing becomes smaller.
Vector Enlarge(const Vector& p, int exponent)
{
  return { std::ldexp(p[0], exponent), std::ldexp(p[1], exponent), std::ldexp(p[2], exponent) };
}
} // namespace

StabilityTruth::StabilityTruth(const StabilityCase& scene)
{
  lms3dTriangleMesh mesh = KeepFinite(scene.Mesh);
  const double size = GetSize(mesh);
  this->Exponent = size < MinimumSize ? -std::ilogb(size) : 0;
  mesh = Map(std::move(mesh), [this](const Vector& p) { return Enlarge(p, this->Exponent); });
  const ExactReference reference(
    { mesh.Points.begin(), mesh.Points.end() }, { mesh.Triangles.begin(), mesh.Triangles.end() });
  this->Hits.reserve(scene.Shots.size() * lms3dBeamPacket::Size);
  for (const StabilityShot& shot : scene.Shots)
  {
    const Vector sensor = Enlarge(shot.Sensor, this->Exponent);
    for (const Vector& direction : shot.Directions)
    {
      this->Hits.push_back(reference.Cast(sensor, direction));
    }
  }
}

StabilityTally StabilityTruth::Judge(const std::vector<double>& ranges) const
{
  StabilityTally tally;
  tally.Beams = this->Hits.size();
  for (std::size_t i = 0; i < this->Hits.size(); ++i)
  {
    const ExactReference::Hit& truth = this->Hits[i];
    const bool isTrueHit = truth.Triangle != ExactReference::NoTriangle;
    const bool isHit = std::isfinite(ranges[i]);
    tally.Hits += isTrueHit;
    tally.Missed += isTrueHit && !isHit;
    tally.False += isHit && !isTrueHit;
    if (isHit && isTrueHit)
    {
      const double range = std::ldexp(ranges[i], this->Exponent);
      const double error = std::abs(range - truth.Range) / truth.Range;
      tally.Wrong += !(error <= LargestError);
      tally.WorstError = std::max(tally.WorstError, error);
      tally.WorstUnits = std::max(tally.WorstUnits, ExactReference::GetError(range, truth));
    }
  }
  return tally;
}
