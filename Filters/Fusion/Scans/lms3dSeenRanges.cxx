// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Scans/lms3dSeenRanges.h"

#include <tbb/blocked_range.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace
{
// A positive, finite number that is not above the range: a longer beam would pass through its own
// return.
float ToFloat(double range)
{
  using Limits = std::numeric_limits<float>;
  const double clamped = std::clamp<double>(range, Limits::min(), Limits::max());
  const auto narrow = static_cast<float>(clamped);
  return narrow > clamped ? std::nextafter(narrow, 0.0F) : narrow;
}
} // namespace

lms3dSeenRanges::lms3dSeenRanges(const lms3dScanInput& scan,
  std::shared_ptr<const lms3dBeamTable> table, const std::vector<bool>& isFree)
  : Table(std::move(table))
  , Pose(scan.GetPose())
  , Ranges(static_cast<std::size_t>(this->Table->GetSize()), 0.0F)
  , LargestInBin(static_cast<std::size_t>(this->Table->GetNumberOfBins()), 0.0F)
{
  const vtkIdType count = scan.GetNumberOfReturns();
  const auto* const ids = scan.GetBeamIds();
  const double* const ranges = scan.GetRanges();
  for (vtkIdType i = 0; i < count; ++i)
  {
    const float range = ToFloat(ranges[i]);
    this->Ranges[this->Table->GetPlace(ids[i])] = range;
    this->Largest = std::max<double>(this->Largest, range);
  }
  if (count < this->Table->GetSize())
  {
    this->FillFree(isFree);
  }
  this->FillLargest();
  this->FillBox();
}

void lms3dSeenRanges::FillFree(const std::vector<bool>& isFree)
{
  for (int id = 0; id < this->Table->GetSize(); ++id)
  {
    float& range = this->Ranges[this->Table->GetPlace(id)];
    if (range == 0.0F && isFree[id])
    {
      range = static_cast<float>(this->Largest);
    }
  }
}

void lms3dSeenRanges::FillLargest()
{
  for (int bin = 0; bin < this->Table->GetNumberOfBins(); ++bin)
  {
    float& largest = this->LargestInBin[bin];
    for (int i = this->Table->GetFirstPlace(bin); i < this->Table->GetEndOfPlaces(bin); ++i)
    {
      largest = std::max(largest, this->Ranges[i]);
    }
  }
}

// The threads divide beams.
void lms3dSeenRanges::FillBox()
{
  tbb::combinable<lms3dWorldBox> boxes;
  tbb::parallel_for(tbb::blocked_range<int>(0, this->Table->GetSize()),
    [&](const tbb::blocked_range<int>& part)
    {
      lms3dWorldBox& box = boxes.local();
      for (int id = part.begin(); id < part.end(); ++id)
      {
        const double range = this->GetRange(id);
        if (range > 0.0)
        {
          const lms3dVector start = this->GetStart(id);
          box.Add(start);
          box.Add(lms3dAdd(start, lms3dScale(this->GetDirection(id), range)));
        }
      }
    });
  this->Box.Add(this->Pose.Position);
  boxes.combine_each([this](const lms3dWorldBox& box) { this->Box.Add(box); });
}

void lms3dSeenRanges::FindBins(
  const lms3dVector& centre, double radius, std::vector<int>& bins) const
{
  bins.clear();
  const lms3dVector inSensor = this->ToSensor(centre);
  const double nearest = lms3dGetLength(inSensor) - radius;
  // Starts beside the sensor's position change distances by less than the ranges' order of size.
  const double margin = this->Table->HasStarts() ? this->Largest : 0.0;
  if (nearest > this->Largest + margin)
  {
    return;
  }
  this->Table->FindBins(inSensor, radius, bins);
  bins.erase(std::remove_if(bins.begin(), bins.end(),
               [&](int bin) { return this->LargestInBin[bin] + margin < nearest; }),
    bins.end());
}
