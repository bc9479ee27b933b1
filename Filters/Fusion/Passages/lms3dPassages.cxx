// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Passages/lms3dPassages.h"

#include "Geometry/lms3dWideLoops.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
// The share of the bound from which on a beam counts as passed; less than 1 because of rounding.
constexpr double PassedShare = 0.999;
constexpr double SmallestCosine = 1e-9;
// More than the rounding of a quick look at a beam, as a share of ranges and heights, and metres.
constexpr double QuickShare = 4e-6;
} // namespace

/// Drops most of the beams that end before a plane, or pass beside all blocks of groups, in single
/// precision.
class lms3dPassages::QuickLook
{
public:
  /// How many beams are looked at together.
  static constexpr int Count = 64;

  QuickLook(const lms3dSeenRanges& ranges, const lms3dPlaneFrame& frame,
    const lms3dBlockGroup& blocks, double maximumError)
    : Table(ranges.GetTable())
    , Ranges(ranges.GetRangesOfPlaces())
    , Bound(static_cast<float>(PassedShare * maximumError))
  {
    const double height = frame.GetHeight(ranges.GetPosition());
    const lms3dVector normal = ranges.ToSensor(lms3dAdd(ranges.GetPosition(), frame.GetNormal()));
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Behind[axis] = static_cast<float>(height >= 0.0 ? -normal[axis] : normal[axis]);
    }
    this->Height = static_cast<float>(std::abs(height) * (1.0 - QuickShare) - QuickShare);
    const lms3dPoint2 foot = frame.ToCells(ranges.GetPosition());
    this->Blocks[0].Set(
      ranges, frame, 0, blocks.Left - foot[0] / Size, blocks.Right + 1 - foot[0] / Size);
    this->Blocks[1].Set(
      ranges, frame, 1, blocks.Bottom - foot[1] / Size, blocks.Top + 1 - foot[1] / Size);
  }

  /// Whether each beam from a place on may pass. Beams must start at the sensor's position.
  std::array<bool, Count> Look(int place, int count) const
  {
    const std::array<const float*, 3> directions = { this->Table.GetNarrowDirections(0) + place,
      this->Table.GetNarrowDirections(1) + place, this->Table.GetNarrowDirections(2) + place };
    std::array<bool, Count> mayPass;
    this->Look(directions, this->Ranges + place, count, mayPass.data());
    return mayPass;
  }

private:
  static constexpr double Size = lms3dRaster::Size;

  /// Where a beam passes between two sides of the blocks, times the cosine of its angle to the
  /// normal. In blocks, from the foot of the sensor's position.
  struct Sides
  {
    void Set(const lms3dSeenRanges& ranges, const lms3dPlaneFrame& frame, int axis, double first,
      double last)
    {
      const double foot = frame.ToCells(ranges.GetPosition())[axis];
      const double height = std::abs(frame.GetHeight(ranges.GetPosition()));
      for (int i = 0; i < 3; ++i)
      {
        const lms3dPoint2 ahead =
          frame.ToCells(lms3dAdd(ranges.GetPosition(), ranges.GetPose().Axes[i]));
        this->Slope[i] = static_cast<float>(height * (ahead[axis] - foot) / Size);
      }
      this->First = static_cast<float>(first);
      this->Last = static_cast<float>(last);
      this->Margin = static_cast<float>(QuickShare *
        (std::max(std::abs(first), std::abs(last)) + height / (Size * frame.GetCell())));
    }

    std::array<float, 3> Slope = {};
    float First = 0.0F;
    float Last = 0.0F;
    /// More than what rounding may change.
    float Margin = 0.0F;
  };

  LMS3D_WIDE_LOOPS void Look(const std::array<const float*, 3>& directions, const float* ranges,
    int count, bool* mayPass) const
  {
    const auto [x, y, z] = directions;
    const std::array<float, 3> behind = this->Behind;
    const float bound = this->Bound;
    const float height = this->Height;
    constexpr auto Share = static_cast<float>(QuickShare);
    const Sides u = this->Blocks[0];
    const Sides v = this->Blocks[1];
    for (int i = 0; i < count; ++i)
    {
      const float cosine = behind[0] * x[i] + behind[1] * y[i] + behind[2] * z[i];
      const float alongU = u.Slope[0] * x[i] + u.Slope[1] * y[i] + u.Slope[2] * z[i];
      const float alongV = v.Slope[0] * x[i] + v.Slope[1] * y[i] + v.Slope[2] * z[i];
      mayPass[i] = ((ranges[i] - bound) * cosine + Share * ranges[i] >= height) &
        (alongU >= u.First * cosine - u.Margin) & (alongU <= u.Last * cosine + u.Margin) &
        (alongV >= v.First * cosine - v.Margin) & (alongV <= v.Last * cosine + v.Margin);
    }
  }

  const lms3dBeamTable& Table;
  const float* const Ranges;
  const float Bound;
  /// The normal in the sensor frame, towards the side behind the plane.
  std::array<float, 3> Behind = {};
  /// The sensor's distance from the plane, less what rounding may change, metres.
  float Height = 0.0F;
  /// Along both axes of the plane.
  std::array<Sides, 2> Blocks;
};

lms3dPassage lms3dPassages::Look(int beamId) const
{
  const double range = this->Ranges->GetRange(beamId);
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

void lms3dPassages::FindBins(const lms3dBlockGroups& groups)
{
  this->HasBin.resize(static_cast<std::size_t>(this->Ranges->GetTable().GetNumberOfBins()));
  const lms3dPlaneFrame& frame = this->Plane->Frame;
  for (const lms3dBlockGroup& group : groups.Get())
  {
    const lms3dVector centre = group.GetCentre(frame);
    const double radius = group.GetRadius(frame);
    if (!this->Ranges->GetBox().IsNear(centre, radius))
    {
      continue;
    }
    this->Ranges->FindBins(centre, radius, this->BinsOfGroup);
    for (const int bin : this->BinsOfGroup)
    {
      if (this->HasBin[bin] == 0)
      {
        this->HasBin[bin] = 1;
        this->Bins.push_back(bin);
      }
    }
  }
}

void lms3dPassages::FindInBins(const lms3dBlockGroup& blocks)
{
  const lms3dBeamTable& table = this->Ranges->GetTable();
  this->Numbers.resize(
    std::max(this->Numbers.size(), static_cast<std::size_t>(table.GetSize())), -1);
  std::sort(this->Bins.begin(), this->Bins.end());
  const QuickLook look(*this->Ranges, this->Plane->Frame, blocks, this->MaximumError);
  for (std::size_t i = 0; i < this->Bins.size();)
  {
    const std::size_t first = i;
    do
    {
      ++i;
    } while (i < this->Bins.size() && this->Bins[i] == this->Bins[i - 1] + 1);
    this->FindAt(
      look, table.GetFirstPlace(this->Bins[first]), table.GetEndOfPlaces(this->Bins[i - 1]));
  }
}

// A quick look at many beams comes first.
void lms3dPassages::FindAt(const QuickLook& look, int firstPlace, int endOfPlaces)
{
  const lms3dBeamTable& table = this->Ranges->GetTable();
  for (int place = firstPlace; place < endOfPlaces; place += QuickLook::Count)
  {
    const int count = std::min(QuickLook::Count, endOfPlaces - place);
    const std::array<bool, QuickLook::Count> mayPass = look.Look(place, count);
    for (int i = 0; i < count; ++i)
    {
      if (!mayPass[i] && !table.HasStarts())
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
  const lms3dSeenRanges& ranges, const lms3dFusedPlane& plane, const lms3dBlockGroups& groups)
{
  this->Forget();
  this->Ranges = &ranges;
  this->Plane = &plane;
  this->FindBins(groups);
  this->FindInBins(groups.GetAll());
}

lms3dPassage lms3dPassages::Get(int beamId) const
{
  const int number = this->Numbers[beamId];
  if (number >= 0)
  {
    return { true, this->Places[number] };
  }
  return this->Look(beamId);
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
