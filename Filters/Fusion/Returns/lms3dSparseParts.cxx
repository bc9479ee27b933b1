// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Returns/lms3dSparseParts.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

namespace
{
// Blocks for each return. The limit falls if the scan has too many blocks.
constexpr double LargestLimit = 64.0;
constexpr double SmallestLimit = 16.0;
// Blocks that a patch may have on top.
constexpr double BlocksOfPatch = 64.0;
// A scan with fewer blocks has none too many.
constexpr double SmallestCount = 500000.0;

using Corners = std::array<lms3dVector, 3>;

// About how many blocks of a plane a triangle meets.
double CountBlocks(const Corners& corners, double cell)
{
  const double side = cell * lms3dRaster::Size;
  const lms3dVector first = lms3dSubtract(corners[1], corners[0]);
  const lms3dVector second = lms3dSubtract(corners[2], corners[0]);
  const double area = 0.5 * lms3dGetLength(lms3dCross(first, second));
  const double perimeter = lms3dGetLength(first) + lms3dGetLength(second) +
    lms3dGetLength(lms3dSubtract(corners[2], corners[1]));
  return area / (side * side) + perimeter / side + 1.0;
}

struct Part
{
  bool IsSparse(double limit) const { return this->Blocks > limit * this->Returns + this->Free; }

  /// The largest number of blocks that the scan can have because of the part.
  double GetLargestCount(double limit) const
  {
    return this->IsSparse(limit) ? std::min(this->Blocks, limit * this->Returns) : this->Blocks;
  }

  /// Blocks that are no part of the limit.
  double Free = 0.0;
  double Blocks = 0.0;
  double Returns = 0.0;
};

std::vector<bool> FindSparse(const std::vector<Part>& parts, double limit)
{
  std::vector<bool> sparse(parts.size());
  std::transform(parts.begin(), parts.end(), sparse.begin(),
    [&](const Part& part) { return part.IsSparse(limit); });
  return sparse;
}

double CountBlocks(const std::vector<Part>& parts, double limit)
{
  return std::accumulate(parts.begin(), parts.end(), 0.0,
    [&](double sum, const Part& part) { return sum + part.GetLargestCount(limit); });
}

// The blocks that a part may have for each of its returns.
double FindLimit(const std::vector<Part>& parts, std::size_t returns)
{
  const double largest = std::max(SmallestCount, SmallestLimit * static_cast<double>(returns));
  double limit = LargestLimit;
  while (limit > SmallestLimit && CountBlocks(parts, limit) > largest)
  {
    limit /= 2.0;
  }
  return limit;
}

/// Lets a plane have surface between the beams of a patch.
class BeamGuess
{
public:
  BeamGuess(
    const lms3dLocalMap& local, const lms3dBeamTable& table, double limit, lms3dFusedPlanes& planes)
    : Local(local)
    , Table(table)
    , Limit(limit)
    , Planes(planes)
    , ReturnOfBeam(static_cast<std::size_t>(table.GetSize()), -1)
  {
  }

  void Guess(const std::vector<int>& returns, int plane)
  {
    for (const int i : returns)
    {
      this->ReturnOfBeam[this->Local.Returns[i].BeamId] = i;
      this->Planes.GrowBox(plane, this->Local.Returns[i].Point);
    }
    for (const int i : returns)
    {
      this->GuessAt(i, plane);
    }
    for (const int i : returns)
    {
      this->ReturnOfBeam[this->Local.Returns[i].BeamId] = -1;
    }
  }

private:
  /// Looks at the triangles between a beam, the next one in the fan or that of the next turn, and
  /// the one between these.
  void GuessAt(int number, int plane)
  {
    const int beam = this->Local.Returns[number].BeamId;
    const auto [next, across, turn] = this->Table.GetNeighbours(beam);
    this->GuessBetween({ beam, next, across }, plane);
    this->GuessBetween({ beam, across, turn }, plane);
  }

  void GuessBetween(const std::array<int, 3>& beams, int plane)
  {
    Corners corners = {};
    for (std::size_t i = 0; i < beams.size(); ++i)
    {
      const int number = beams[i] < 0 ? -1 : this->ReturnOfBeam[beams[i]];
      if (number < 0)
      {
        return;
      }
      corners[i] = this->Local.Returns[number].Point;
    }
    // A beam has two of these triangles.
    if (CountBlocks(corners, this->Planes.GetCell()) <= this->Limit / 2.0)
    {
      this->Planes.GuessTriangle(plane, corners);
    }
  }

  const lms3dLocalMap& Local;
  const lms3dBeamTable& Table;
  const double Limit;
  lms3dFusedPlanes& Planes;
  /// -1 for a beam without a return on the patch.
  std::vector<int> ReturnOfBeam;
};
} // namespace

lms3dSparseParts::lms3dSparseParts(const lms3dLocalMap& local, double cell)
  : Local(local)
{
  std::vector<Part> triangles(local.PatchIds.size());
  for (const lms3dMappedReturn& mapped : local.Returns)
  {
    triangles[mapped.Triangle].Returns += 1.0;
  }
  std::vector<Part> patches(static_cast<std::size_t>(local.NumberOfPatches), { BlocksOfPatch });
  std::vector<Part> loose;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const auto number = static_cast<int>(i);
    triangles[i].Blocks = CountBlocks(
      { local.GetCorner(number, 0), local.GetCorner(number, 1), local.GetCorner(number, 2) }, cell);
    if (local.PatchIds[i] >= 0)
    {
      patches[local.PatchIds[i]].Blocks += triangles[i].Blocks;
      patches[local.PatchIds[i]].Returns += triangles[i].Returns;
    }
    else if (triangles[i].Returns > 0.0)
    {
      loose.push_back(triangles[i]);
    }
  }
  std::vector<Part> all = patches;
  all.insert(all.end(), loose.begin(), loose.end());
  this->Limit = FindLimit(all, local.Returns.size());
  this->SparseTriangles = FindSparse(triangles, this->Limit);
  this->SparsePatches = FindSparse(patches, this->Limit);
}

std::vector<int> lms3dSparseParts::SelectDense(std::vector<int> planeOfPatch) const
{
  for (std::size_t patch = 0; patch < planeOfPatch.size(); ++patch)
  {
    planeOfPatch[patch] = this->SparsePatches[patch] ? -1 : planeOfPatch[patch];
  }
  return planeOfPatch;
}

void lms3dSparseParts::Guess(const std::vector<std::vector<int>>& returns,
  const std::vector<int>& planeOfPatch, const lms3dBeamTable& table, lms3dFusedPlanes& planes) const
{
  BeamGuess guess(this->Local, table, this->Limit, planes);
  for (std::size_t patch = 0; patch < planeOfPatch.size(); ++patch)
  {
    if (this->SparsePatches[patch] && planeOfPatch[patch] >= 0)
    {
      guess.Guess(returns[patch], planeOfPatch[patch]);
    }
  }
}
