// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How far the space along each beam of a scan is free: what a fusion keeps of a scan.
 */
#ifndef lms3dSeenRanges_h
#define lms3dSeenRanges_h

#include "Device/lms3dScanInput.h"
#include "Fusion/Scans/lms3dBeamTable.h"
#include "Fusion/Scans/lms3dWorldBox.h"
#include "Geometry/lms3dVector.h"

#include <memory>
#include <vector>

class lms3dSeenRanges
{
public:
  /// The table must have the angles of the scan, which must have returns. `isFree` says for each
  /// BeamId whether there is nothing along the beam if it has no return. Such a beam counts as free
  /// up to the farthest return of the scan, since the device measures at least that far.
  lms3dSeenRanges(const lms3dScanInput& scan, std::shared_ptr<const lms3dBeamTable> table,
    const std::vector<bool>& isFree);

  const lms3dBeamTable& GetTable() const { return *this->Table; }
  const lms3dPose& GetPose() const { return this->Pose; }
  const lms3dVector& GetPosition() const { return this->Pose.Position; }
  /// The box of all beams, from their starts to their ranges.
  const lms3dWorldBox& GetBox() const { return this->Box; }

  /// How far a beam is free: up to its return, or as the constructor says; 0 if that is not known.
  /// Metres, rounded down to single precision.
  double GetRange(int beamId) const { return this->Ranges[this->Table->GetPlace(beamId)]; }
  /// The ranges in the order of the places of lms3dBeamTable.
  const float* GetRangesOfPlaces() const { return this->Ranges.data(); }
  /// World coordinates.
  lms3dVector GetDirection(int beamId) const
  {
    return this->Rotate(this->Table->GetDirection(beamId));
  }
  lms3dVector GetStart(int beamId) const
  {
    return this->Table->HasStarts()
      ? lms3dAdd(this->Pose.Position, this->Rotate(this->Table->GetStart(beamId)))
      : this->Pose.Position;
  }

  /// Into the sensor frame.
  lms3dVector ToSensor(const lms3dVector& point) const
  {
    const lms3dVector v = lms3dSubtract(point, this->Pose.Position);
    return { lms3dDot(v, this->Pose.Axes[0]), lms3dDot(v, this->Pose.Axes[1]),
      lms3dDot(v, this->Pose.Axes[2]) };
  }

  /// Replaces `bins` by those with a beam that can pass through the sphere, or end in it.
  void FindBins(const lms3dVector& centre, double radius, std::vector<int>& bins) const;

private:
  /// Sets the ranges of the free beams without a return.
  void FillFree(const std::vector<bool>& isFree);
  void FillLargest();
  void FillBox();
  lms3dVector Rotate(const lms3dVector& v) const
  {
    return lms3dAdd(lms3dScale(this->Pose.Axes[0], v[0]),
      lms3dAdd(lms3dScale(this->Pose.Axes[1], v[1]), lms3dScale(this->Pose.Axes[2], v[2])));
  }

  std::shared_ptr<const lms3dBeamTable> Table;
  lms3dPose Pose;
  std::vector<float> Ranges;
  std::vector<float> LargestInBin;
  double Largest = 0.0;
  lms3dWorldBox Box;
};

#endif
