// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/TrueSteps.h"

#include <vtkIdList.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace
{
using Beam = ScanGrid::Beam;

constexpr double Infinity = std::numeric_limits<double>::infinity();
// The parts of the way between two beams, and how often each is halved at most.
constexpr int NumberOfParts = 12;
constexpr int MaximumHalvings = 20;
// The largest jump of a map's surface that bridges a step, or closes a slope, as a share of it.
constexpr double LargestShare = 0.25;
// Radians by which a ray may pass outside of a triangle.
constexpr double Margin = 1e-9;

/// A part of the way: two shares of it, and the ranges there.
struct Part
{
  double Low;
  double AtLow;
  double High;
  double AtHigh;
  /// How often it may be halved. A change of range that is left then is a jump.
  int Halvings;
};

/// The way from one beam to another.
struct Way
{
  // The nearest range at a share of the way, or infinity.
  double GetRange(double share) const
  {
    std::vector<TriangleTree::Hit> hits;
    this->Surface.Cast(
      this->Grid.GetDirection({ this->From.Turn + share * (this->To.Turn - this->From.Turn),
        this->From.Number + share * (this->To.Number - this->From.Number) }),
      Margin, hits);
    const auto nearest = std::min_element(hits.begin(), hits.end(),
      [](const TriangleTree::Hit& p, const TriangleTree::Hit& q) { return p.Range < q.Range; });
    return nearest == hits.end() ? Infinity : nearest->Range;
  }

  // The sum of the jumps in a part of the way, with signs; infinity where a ray meets nothing.
  double SumJumps(const Part& whole) const
  {
    double sum = 0.0;
    std::vector<Part> parts = { whole };
    while (!parts.empty() && !std::isinf(sum))
    {
      const Part part = parts.back();
      parts.pop_back();
      const double change = part.AtHigh - part.AtLow;
      if (std::isinf(part.AtLow) || std::isinf(part.AtHigh))
      {
        sum = Infinity;
      }
      else if (part.Halvings == 0 && std::abs(change) >= this->SmallChange)
      {
        sum += change;
      }
      else if (std::abs(change) >= this->SmallChange)
      {
        this->Halve(part, parts);
      }
    }
    return sum;
  }

  // Appends both halves of a part.
  void Halve(const Part& part, std::vector<Part>& parts) const
  {
    const double middle = 0.5 * (part.Low + part.High);
    const double atMiddle = this->GetRange(middle);
    parts.push_back({ middle, atMiddle, part.High, part.AtHigh, part.Halvings - 1 });
    parts.push_back({ part.Low, part.AtLow, middle, atMiddle, part.Halvings - 1 });
  }

  const ScanGrid& Grid;
  const TriangleTree& Surface;
  Beam From;
  Beam To;
  // A change of range that is no jump, metres.
  double SmallChange;
};
} // namespace

TrueSteps::TrueSteps(vtkPolyData* scan, vtkPolyData* scene, double depthStep, double share)
  : Grid(scan)
  , Scene(scene)
  , DepthStep(depthStep)
  , Share(share)
{
  const std::unique_ptr<TriangleTree> surface = this->MakeTree(scene);
  for (int turn = 0; turn < this->Grid.GetNumberOfTurns(); ++turn)
  {
    for (int number = 0; number < this->Grid.GetNumberOfBeams(); ++number)
    {
      this->AddIfStep(*surface, { turn, number }, { turn, number + 1 });
      if (!this->Grid.IsPole(number))
      {
        this->AddIfStep(*surface, { turn, number }, { turn + 1, number });
      }
    }
  }
}

void TrueSteps::AddIfStep(const TriangleTree& scene, const Beam& beam, const Beam& next)
{
  if (!this->Grid.Contains(next) || this->Grid.GetReturn(beam) == ScanGrid::NoReturn ||
    this->Grid.GetReturn(next) == ScanGrid::NoReturn)
  {
    return;
  }
  const double range = this->Grid.GetRange(this->Grid.GetReturn(beam));
  const double rangeOfNext = this->Grid.GetRange(this->Grid.GetReturn(next));
  const double minimum = 2.0 * (this->DepthStep + this->Share * std::min(range, rangeOfNext));
  if (std::abs(range - rangeOfNext) > minimum)
  {
    const double jump = this->GetJump(scene, beam, next);
    if (jump > minimum && !std::isinf(jump))
    {
      this->Steps.push_back({ beam, next, jump });
    }
    else if (jump < this->GetSmallChange())
    {
      this->Slopes.push_back({ beam, next, std::abs(range - rangeOfNext) });
    }
  }
}

// The smallest jump that a map may have at a step. Smaller changes need not be divided.
double TrueSteps::GetSmallChange() const
{
  return 2.0 * LargestShare * this->DepthStep;
}

double TrueSteps::GetJump(const TriangleTree& surface, const Beam& a, const Beam& b) const
{
  const Way way = { this->Grid, surface, a, b, this->GetSmallChange() };
  double sum = 0.0;
  double last = way.GetRange(0.0);
  for (int i = 1; i <= NumberOfParts; ++i)
  {
    const double share = static_cast<double>(i) / NumberOfParts;
    const double range = way.GetRange(share);
    sum += way.SumJumps({ share - 1.0 / NumberOfParts, last, share, range, MaximumHalvings });
    last = range;
  }
  return std::abs(sum);
}

int TrueSteps::CountBridged(vtkPolyData* map, const std::vector<Step>& steps) const
{
  const std::unique_ptr<TriangleTree> surface = this->MakeTree(map);
  return static_cast<int>(std::count_if(steps.begin(), steps.end(),
    [&](const Step& step)
    { return !(this->GetJump(*surface, step.From, step.Next) > LargestShare * step.Jump); }));
}

int TrueSteps::CountOpen(vtkPolyData* map, const std::vector<Step>& slopes) const
{
  const std::unique_ptr<TriangleTree> surface = this->MakeTree(map);
  return static_cast<int>(std::count_if(slopes.begin(), slopes.end(),
    [&](const Step& slope)
    { return this->GetJump(*surface, slope.From, slope.Next) > LargestShare * slope.Jump; }));
}

std::unique_ptr<TriangleTree> TrueSteps::MakeTree(vtkPolyData* triangles) const
{
  std::vector<Vector> points(triangles->GetNumberOfPoints());
  for (vtkIdType i = 0; i < triangles->GetNumberOfPoints(); ++i)
  {
    triangles->GetPoint(i, points[i].data());
    points[i] = points[i] - this->Grid.GetSensor();
  }
  std::vector<TriangleTree::Triangle> corners;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < triangles->GetNumberOfCells(); ++cell)
  {
    triangles->GetCellPoints(cell, ids);
    corners.push_back({ ids->GetId(0), ids->GetId(1), ids->GetId(2) });
  }
  return std::make_unique<TriangleTree>(std::move(points), std::move(corners));
}
