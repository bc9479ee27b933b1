// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dPatchMesher.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace
{
// How far a vertex may be off its return: as noise is at most, and in the bound with some room for
// the returns beside it.
constexpr double LiftInDeviations = 4.0;
constexpr double LiftInBounds = 0.8;
// The rounds of one new vertex a triangle, before all beams that are too far become vertices.
constexpr int PatientRounds = 12;
// The smallest cosine to the axis of projection.
constexpr double MinimumCosine = 1e-6;

double GetLength(const lms3dVector& v)
{
  return std::sqrt(lms3dDot(v, v));
}

} // namespace

struct lms3dPatchMesher::Work
{
  /// A beam that meets a triangle too far from its return, and the range where it does.
  struct Miss
  {
    GridIndex Beam;
    int Triangle;
    double Range;
    double Deviation;
  };

  int Patch;
  int Members;
  /// The numbers of the outlines' vertices, sorted.
  std::vector<std::int32_t> Numbers;
  /// By the numbers of the triangulation: those of the outline, its frame, those that were added.
  std::vector<lms3dMapVertex> Vertices;
  std::vector<lms3dTriangleCorner> Corners;
  std::unique_ptr<lms3dTriangulation> Triangulation;
  /// To the right and up, as the sensor sees them, and ahead.
  lms3dVector Axes[3];
  bool IsPatient = true;
  int Met = 0;
  /// All triangles have been met, by beams of the patch alone.
  bool IsMetByItsOwn = false;
  std::vector<Miss> Misses;
  /// A triangle when its beams were met, and the largest distance along them that is in the bound.
  struct Checked
  {
    std::array<std::int32_t, 3> Corners = { -1, -1, -1 };
    double Deviation = 0.0;
  };

  std::vector<Checked> Triangles;
  lms3dPatchMesh Result;

  void Add(const lms3dMapVertex& vertex)
  {
    this->Vertices.push_back(vertex);
    this->Corners.emplace_back(lms3dScale(vertex.Direction, 1.0 / vertex.InverseRange));
  }

  /// While patient, the worst of each triangle.
  void AddMiss(const Miss& miss)
  {
    if (!this->IsPatient || this->Misses.empty() || this->Misses.back().Triangle != miss.Triangle)
    {
      this->Misses.push_back(miss);
    }
    else if (miss.Deviation > this->Misses.back().Deviation)
    {
      this->Misses.back() = miss;
    }
  }

  lms3dPoint2 GetPoint(const lms3dVector& direction) const
  {
    const double ahead = lms3dDot(this->Axes[2], direction);
    return { lms3dDot(this->Axes[0], direction) / ahead,
      lms3dDot(this->Axes[1], direction) / ahead };
  }
};

lms3dPatchMesher::lms3dPatchMesher(const lms3dBeamSphere& sphere, const lms3dPatches& patches,
  const lms3dPatchOutlines& outlines, double maximumError, double noise)
  : Sphere(sphere)
  , Patches(patches)
  , Outlines(outlines)
  , MaximumError(maximumError)
  , Lift(std::min(LiftInBounds * maximumError, LiftInDeviations * noise))
  , States(sphere.GetSize(), IsUnmet)
{
}

lms3dPatchMesh lms3dPatchMesher::Mesh(int patch, int members)
{
  Work work;
  work.Patch = patch;
  work.Members = members;
  if (this->Project(work) && this->Refine(work))
  {
    this->Finish(work);
  }
  else if (work.IsMetByItsOwn)
  {
    this->FindUnmet(work);
  }
  return std::move(work.Result);
}

// Along the patch's plane, or where its outline leaves what can be seen of it, ahead.
bool lms3dPatchMesher::Project(Work& work) const
{
  work.Numbers = this->Outlines.GetOutline(work.Patch).Vertices;
  std::sort(work.Numbers.begin(), work.Numbers.end());
  work.Numbers.erase(std::unique(work.Numbers.begin(), work.Numbers.end()), work.Numbers.end());
  lms3dVector ahead = { 0.0, 0.0, 0.0 };
  for (std::int32_t number : work.Numbers)
  {
    work.Add(this->Outlines.GetVertices()[number]);
    for (int axis = 0; axis < 3; ++axis)
    {
      ahead[axis] += work.Vertices.back().Direction[axis];
    }
  }
  return work.Numbers.size() >= 3 &&
    (this->ProjectAlong(work, this->Patches.Patches[work.Patch].Plane.Q) ||
      this->ProjectAlong(work, ahead));
}

bool lms3dPatchMesher::ProjectAlong(Work& work, const lms3dVector& axis) const
{
  work.Axes[2] = lms3dScale(axis, 1.0 / GetLength(axis));
  const lms3dVector& ahead = work.Axes[2];
  const lms3dVector other =
    std::abs(ahead[2]) < 0.7 ? lms3dVector{ 0.0, 0.0, 1.0 } : lms3dVector{ 1.0, 0.0, 0.0 };
  const lms3dVector right = lms3dCross(ahead, other);
  work.Axes[0] = lms3dScale(right, 1.0 / GetLength(right));
  work.Axes[1] = lms3dCross(work.Axes[0], ahead);
  std::vector<lms3dPoint2> points;
  for (std::size_t i = 0; i < work.Numbers.size(); ++i)
  {
    const lms3dVector& direction = work.Vertices[i].Direction;
    if (!(lms3dDot(ahead, direction) > MinimumCosine))
    {
      return false;
    }
    points.push_back(work.GetPoint(direction));
  }
  const lms3dPatchOutlines::Outline& outline = this->Outlines.GetOutline(work.Patch);
  std::vector<std::int32_t> loops;
  for (std::int32_t number : outline.Vertices)
  {
    loops.push_back(static_cast<std::int32_t>(
      std::lower_bound(work.Numbers.begin(), work.Numbers.end(), number) - work.Numbers.begin()));
  }
  work.Triangulation =
    std::make_unique<lms3dTriangulation>(std::move(points), loops, outline.LoopEnds);
  return work.Triangulation->IsValid();
}

bool lms3dPatchMesher::Refine(Work& work)
{
  for (int i = 0; i < 3; ++i)
  {
    work.Add({ work.Axes[2], 1.0 }); // In the place of the frame's corners.
  }
  for (int round = 0;; ++round)
  {
    work.IsPatient = round < PatientRounds;
    if (!this->Check(work))
    {
      return false;
    }
    if (work.Misses.empty())
    {
      return true;
    }
    if (!this->InsertBeams(work))
    {
      return false;
    }
  }
}

// A triangle that is as before has no miss: it would have got a vertex.
bool lms3dPatchMesher::Check(Work& work)
{
  work.Misses.clear();
  work.IsMetByItsOwn = false;
  work.Result.DeviationOnBeams = 0.0;
  work.Triangles.resize(work.Triangulation->GetNumberOfTriangles());
  for (int i = 0; i < work.Triangulation->GetNumberOfTriangles(); ++i)
  {
    if (!work.Triangulation->IsInside(i))
    {
      continue;
    }
    Work::Checked& triangle = work.Triangles[i];
    if (triangle.Corners != work.Triangulation->GetCorners(i))
    {
      triangle = { work.Triangulation->GetCorners(i) };
      if (!this->CheckTriangle(work, i))
      {
        return false;
      }
    }
    work.Result.DeviationOnBeams = std::max(work.Result.DeviationOnBeams, triangle.Deviation);
  }
  work.IsMetByItsOwn = true;
  return work.Met == work.Members;
}

void lms3dPatchMesher::FindUnmet(Work& work) const
{
  for (GridIndex index = 0; index < this->Sphere.GetSize(); ++index)
  {
    if (this->Patches.Labels[index] == work.Patch && this->States[index] == IsUnmet &&
      !this->Sphere.IsRepeated(index))
    {
      work.Result.Unmet.push_back(index);
    }
  }
}

bool lms3dPatchMesher::CheckTriangle(Work& work, int triangle)
{
  const std::array<std::int32_t, 3>& corners = work.Triangulation->GetCorners(triangle);
  const lms3dTriangleRasterizer beams(
    this->Sphere, work.Corners[corners[0]], work.Corners[corners[1]], work.Corners[corners[2]]);
  bool areOwn = true;
  beams.ForColumns(
    [&](int column, int first, int last) {
      areOwn = areOwn && this->CheckBeams(work, triangle, beams.GetPlane(), column, first, last);
    });
  return areOwn;
}

bool lms3dPatchMesher::CheckBeams(
  Work& work, int triangle, const lms3dPlane& plane, int column, int first, int last)
{
  const lms3dColumnPlane inColumn(plane, this->Sphere, column);
  const GridIndex start = this->Sphere.GetIndex(column, 0);
  double largest = work.Triangles[triangle].Deviation;
  for (int row = first; row <= last; ++row)
  {
    const GridIndex index = start + row;
    if (this->Patches.Labels[index] != work.Patch)
    {
      return false;
    }
    if (column > 0 && this->Sphere.IsPoleRow(row))
    {
      continue;
    }
    if (this->States[index] == IsUnmet)
    {
      this->States[index] = IsMet;
      ++work.Met;
    }
    const double inverse =
      inColumn.GetInverseRange(this->Sphere.GetCosines()[row], this->Sphere.GetSines()[row]);
    const double deviation =
      std::abs(this->Sphere.GetRange(index) - 1.0 / inverse) + this->Sphere.GetSpread(row);
    if (deviation <= this->MaximumError)
    {
      largest = std::max(largest, deviation);
    }
    else if (this->States[index] != IsVertex)
    {
      work.AddMiss({ index, triangle, 1.0 / inverse, deviation });
    }
  }
  work.Triangles[triangle].Deviation = largest;
  return true;
}

bool lms3dPatchMesher::InsertBeams(Work& work)
{
  for (const Work::Miss& miss : work.Misses)
  {
    if (this->States[miss.Beam] == IsVertex)
    {
      continue; // On the edge of two triangles.
    }
    this->States[miss.Beam] = IsVertex;
    const lms3dVector direction = this->Sphere.GetDirection(miss.Beam);
    const double range = this->Sphere.GetRange(miss.Beam);
    const double spread = this->Sphere.GetSpread(this->Sphere.GetRow(miss.Beam));
    const double rest = std::max(0.0, this->Lift - spread);
    const double lifted = miss.Range > range ? range + rest : range - rest;
    const std::int32_t number = work.Triangulation->Insert(work.GetPoint(direction), miss.Triangle);
    // Behind the horizon of its triangle a beam has no range to start from.
    const bool isLiftable = lifted > 0.0 && miss.Range > 0.0;
    if (number == lms3dTriangulation::None)
    {
      return false;
    }
    work.Add({ direction, 1.0 / (isLiftable ? lifted : range) });
  }
  return true;
}

void lms3dPatchMesher::Finish(Work& work) const
{
  const std::int32_t shared = static_cast<std::int32_t>(work.Numbers.size());
  const std::int32_t firstAdded = shared + 3;
  const std::int32_t outlineVertices =
    static_cast<std::int32_t>(this->Outlines.GetVertices().size());
  lms3dPatchMesh& result = work.Result;
  result.IsValid = true;
  result.Added.assign(work.Vertices.begin() + firstAdded, work.Vertices.end());
  for (int i = 0; i < work.Triangulation->GetNumberOfTriangles(); ++i)
  {
    if (work.Triangulation->IsInside(i))
    {
      std::array<std::int32_t, 3> corners = work.Triangulation->GetCorners(i);
      for (std::int32_t& corner : corners)
      {
        corner = corner < shared ? work.Numbers[corner] : outlineVertices + corner - firstAdded;
      }
      result.Triangles.push_back(corners);
    }
  }
}
