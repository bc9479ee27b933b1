// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The arrays of a scan, checked.
 */
#ifndef lms3dScanInput_h
#define lms3dScanInput_h

#include "Device/lms3dScanGeometry.h"

#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkSmartPointer.h>

#include <array>

class vtkPolyData;

/// Throws std::runtime_error, with words for the user, where an array is missing or of a wrong
/// size.
class lms3dScanInput
{
public:
  explicit lms3dScanInput(vtkPolyData* scan);

  /// Where it is 0, there is nothing else to ask.
  vtkIdType GetNumberOfReturns() const
  {
    return this->Ranges ? this->Ranges->GetNumberOfValues() : 0;
  }
  const double* GetPoints() const { return this->Points->GetPointer(0); }
  const double* GetRanges() const { return this->Ranges->GetPointer(0); }
  const int* GetBeamIds() const { return this->BeamIds->GetPointer(0); }

  /// Throws as the constructor does where a coordinate is not finite. Uses the threads of the calling
  /// TBB arena.
  void CheckPoints() const;

  lms3dScanGeometry GetGeometry() const;
  bool HasAngles(const lms3dScanGeometry& geometry) const;
  std::array<double, 3> GetSensorPosition() const;
  /// Row by row.
  const double* GetSensorToWorld() const { return this->SensorToWorld->GetPointer(0); }

private:
  vtkSmartPointer<vtkDoubleArray> Points;
  vtkSmartPointer<vtkDoubleArray> Ranges;
  vtkSmartPointer<vtkIntArray> BeamIds;
  vtkSmartPointer<vtkDoubleArray> AlphaAngles;
  vtkSmartPointer<vtkDoubleArray> BetaAngles;
  vtkSmartPointer<vtkDoubleArray> SensorToWorld;
};

#endif
