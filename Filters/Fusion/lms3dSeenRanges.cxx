// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dSeenRanges.h"

#include <tbb/blocked_range.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

lms3dSeenRanges::lms3dSeenRanges(
  const lms3dScanInput& scan, std::shared_ptr<const lms3dBeamTable> table)
  : Table(std::move(table))
  , Pose(scan.GetPose())
  , Ranges(static_cast<std::size_t>(this->Table->GetGeometry().CountBeamsOfAllTurns()), 0.0F)
  , LargestInBin(static_cast<std::size_t>(this->Table->GetNumberOfBins()), 0.0F)
{
  this->AddReturns(scan);
  for (int bin = 0; bin < this->Table->GetNumberOfBins(); ++bin)
  {
    float& largest = this->LargestInBin[bin];
    for (int i = this->Table->GetFirstPlace(bin); i < this->Table->GetEndOfPlaces(bin); ++i)
    {
      largest = std::max(largest, this->Ranges[i]);
    }
    this->Largest = std::max<double>(this->Largest, largest);
  }
}

// The threads divide returns. The beam of a return is that of no other.
void lms3dSeenRanges::AddReturns(const lms3dScanInput& scan)
{
  const auto* const ids = scan.GetBeamIds();
  const double* const ranges = scan.GetRanges();
  tbb::combinable<lms3dWorldBox> boxes;
  tbb::parallel_for(tbb::blocked_range<vtkIdType>(0, scan.GetNumberOfReturns()),
    [&](const tbb::blocked_range<vtkIdType>& part)
    {
      lms3dWorldBox& box = boxes.local();
      for (vtkIdType i = part.begin(); i < part.end(); ++i)
      {
        const int id = ids[i];
        this->Ranges[this->Table->GetPlace(id)] = static_cast<float>(ranges[i]);
        const lms3dVector start = this->GetStart(id);
        box.Add(start);
        box.Add(lms3dAdd(start, lms3dScale(this->GetDirection(id), ranges[i])));
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
