// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The arrays of a scan that a filter has as its input, checked.
 */
#ifndef lms3dScanInput_h
#define lms3dScanInput_h

#include "Device/lms3dScanGeometry.h"

#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cstdint>

class vtkPolyData;

/// Throws std::runtime_error, with a text for the user: the return has a BeamId outside of the
/// `beams` of the grid, or a Range that is not a finite number above 0, or otherwise the BeamId of
/// another return.
[[noreturn]] void lms3dThrowBadReturn(
  std::int64_t index, double range, int beamId, std::int64_t beams);

/// Returns the sensor's position, world coordinates, metres, also if the scan has no returns. 0 0 0
/// if the scan has no SensorToWorld, or one that is not finite.
std::array<double, 3> lms3dFindSensorPosition(vtkPolyData* scan);

/// Keeps the arrays of a scan alive, and shares them unless another filter changed their types.
class lms3dScanInput
{
public:
  /// Throws std::runtime_error, with a text for the user, if an array is missing or has a wrong
  /// size.
  explicit lms3dScanInput(vtkPolyData* scan);

  /// Returns the number of returns. If it is 0, no other method may be called.
  vtkIdType GetNumberOfReturns() const
  {
    return this->Ranges ? this->Ranges->GetNumberOfValues() : 0;
  }

  /// World coordinates, metres, three for each return.
  const double* GetPoints() const { return this->Points->GetPointer(0); }

  /// Metres, one for each return.
  const double* GetRanges() const { return this->Ranges->GetPointer(0); }

  /// turn * beams + beam, one for each return. The values are not checked.
  const int* GetBeamIds() const { return this->BeamIds->GetPointer(0); }

  /// Throws std::runtime_error, with a text for the user, if a coordinate is not finite. Uses the
  /// threads of the calling TBB arena.
  void CheckPoints() const;

  lms3dScanGeometry GetGeometry() const;

  lms3dPose GetPose() const;

  /// Returns whether the angles and the platform of the scan and of `geometry` are equal to the
  /// bit.
  bool HasAngles(const lms3dScanGeometry& geometry) const;

  /// World coordinates, metres.
  std::array<double, 3> GetSensorPosition() const;

  /// The pose as 16 values, row by row.
  const double* GetSensorToWorld() const { return this->SensorToWorld->GetPointer(0); }

private:
  vtkSmartPointer<vtkDoubleArray> Points;
  vtkSmartPointer<vtkDoubleArray> Ranges;
  vtkSmartPointer<vtkIntArray> BeamIds;
  vtkSmartPointer<vtkDoubleArray> AlphaAngles;
  vtkSmartPointer<vtkDoubleArray> BetaAngles;
  vtkSmartPointer<vtkDoubleArray> SensorToWorld;
  lms3dPlatform Platform;
};

#endif
