// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dPassages.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
// The diagonal of a block from its centre, cells.
constexpr double HalfDiagonal = 45.26;
// The share of the bound from which on a beam counts as passed; less than 1 because of rounding.
constexpr double PassedShare = 0.999;
constexpr double SmallestCosine = 1e-9;
// More than the rounding of a quick look at a beam, as a share of ranges and heights, and metres.
constexpr double QuickShare = 4e-6;
} // namespace

lms3dPassage lms3dPassages::Look(int beamId) const
{
  const double range = this->Ranges->GetRange(beamId);
  if (range == 0.0)
  {
    return {};
  }
  const lms3dVector direction = this->Ranges->GetDirection(beamId);
  const lms3dVector start = this->Ranges->GetStart(beamId);
  const double cosine = lms3dDot(this->Plane->Frame.GetNormal(), direction);
  if (std::abs(cosine) < SmallestCosine)
  {
    return {};
  }
  const double crossing = -this->Plane->Frame.GetHeight(start) / cosine;
  if (!(crossing > 0.0) || range - crossing <= PassedShare * this->MaximumError)
  {
    return {};
  }
  return { true, this->Plane->Frame.ToCells(lms3dAdd(start, lms3dScale(direction, crossing))) };
}

void lms3dPassages::FindBins(int firstBlock)
{
  this->HasBin.resize(static_cast<std::size_t>(this->Ranges->GetTable().GetNumberOfBins()));
  const double radius = HalfDiagonal * this->Plane->Frame.GetCell();
  for (int block = firstBlock; block < this->Plane->Raster.GetNumberOfBlocks(); ++block)
  {
    const lms3dRasterBlock& cells = this->Plane->Raster.GetBlock(block);
    const lms3dVector centre = this->Plane->Frame.ToWorld(
      { (cells.U + 0.5) * lms3dRaster::Size, (cells.V + 0.5) * lms3dRaster::Size });
    if (!this->Ranges->GetBox().IsNear(centre, radius))
    {
      continue;
    }
    this->Ranges->FindBins(centre, radius, this->BinsOfBlock);
    for (const int bin : this->BinsOfBlock)
    {
      if (this->HasBin[bin] == 0)
      {
        this->HasBin[bin] = 1;
        this->Bins.push_back(bin);
      }
    }
  }
}

void lms3dPassages::FindInBins()
{
  const lms3dBeamTable& table = this->Ranges->GetTable();
  this->Numbers.resize(
    std::max(this->Numbers.size(), static_cast<std::size_t>(table.GetSize())), -1);
  std::sort(this->Bins.begin(), this->Bins.end());
  for (std::size_t i = 0; i < this->Bins.size();)
  {
    const std::size_t first = i;
    do
    {
      ++i;
    } while (i < this->Bins.size() && this->Bins[i] == this->Bins[i - 1] + 1);
    this->FindAt(table.GetFirstPlace(this->Bins[first]), table.GetEndOfPlaces(this->Bins[i - 1]));
  }
}

// A quick look at many beams in single precision comes first.
void lms3dPassages::FindAt(int firstPlace, int endOfPlaces)
{
  const lms3dBeamTable& table = this->Ranges->GetTable();
  const lms3dVector& position = this->Ranges->GetPosition();
  const double height = this->Plane->Frame.GetHeight(position);
  // The normal in the sensor frame, towards the side behind the plane.
  const lms3dVector behind =
    lms3dScale(this->Ranges->ToSensor(lms3dAdd(position, this->Plane->Frame.GetNormal())),
      height >= 0.0 ? -1.0 : 1.0);
  const std::array<float, 3> normal = { static_cast<float>(behind[0]),
    static_cast<float>(behind[1]), static_cast<float>(behind[2]) };
  const auto bound = static_cast<float>(PassedShare * this->MaximumError);
  const auto least = static_cast<float>(std::abs(height) * (1.0 - QuickShare) - QuickShare);
  const float* const x = table.GetNarrowDirections(0);
  const float* const y = table.GetNarrowDirections(1);
  const float* const z = table.GetNarrowDirections(2);
  const float* const ranges = this->Ranges->GetRangesOfPlaces();
  constexpr int Chunk = 64;
  std::array<bool, Chunk> isLong = {};
  for (int place = firstPlace; place < endOfPlaces; place += Chunk)
  {
    const int count = std::min(Chunk, endOfPlaces - place);
    for (int i = 0; i < count; ++i)
    {
      const int k = place + i;
      const float cosine = normal[0] * x[k] + normal[1] * y[k] + normal[2] * z[k];
      const auto share = static_cast<float>(QuickShare);
      isLong[i] = (ranges[k] - bound) * cosine + share * ranges[k] >= least;
    }
    for (int i = 0; i < count; ++i)
    {
      if (!isLong[i] && !table.HasStarts())
      {
        continue;
      }
      const int beam = table.GetBeam(place + i);
      const lms3dPassage passage = this->Look(beam);
      if (passage.IsPassed)
      {
        this->Numbers[beam] = static_cast<int>(this->Beams.size());
        this->Beams.push_back(beam);
        this->Places.push_back(passage.Place);
      }
    }
  }
}

void lms3dPassages::Find(
  const lms3dSeenRanges& ranges, const lms3dFusedPlane& plane, int firstBlock)
{
  this->Forget();
  this->Ranges = &ranges;
  this->Plane = &plane;
  this->FindBins(firstBlock);
  this->FindInBins();
}

lms3dPassage lms3dPassages::Get(int beamId) const
{
  const int number = this->Numbers[beamId];
  if (number >= 0)
  {
    return { true, this->Places[number] };
  }
  return this->HasBin[this->Ranges->GetTable().GetBin(beamId)] != 0 ? lms3dPassage()
                                                                    : this->Look(beamId);
}

void lms3dPassages::Forget()
{
  for (const int bin : this->Bins)
  {
    this->HasBin[bin] = 0;
  }
  for (const int beam : this->Beams)
  {
    this->Numbers[beam] = -1;
  }
  this->Bins.clear();
  this->Beams.clear();
  this->Places.clear();
}
