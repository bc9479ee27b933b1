// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which surfaces the device detects, and why beams gave no return.
 */
#ifndef lms3dDetection_h
#define lms3dDetection_h

#include "Pipeline/lms3dProgress.h"
#include "Scan/lms3dBeamCasting.h"
#include "Scan/lms3dBuiltScene.h"
#include "Scan/lms3dMovingBeams.h"
#include "Scan/lms3dScanOutput.h"
#include "Scan/lms3dScanSettings.h"
#include "Scan/lms3dSurfaceAttributes.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>
#include <vtkUnsignedCharArray.h>

#include <string>
#include <vector>

class vtkDataObject;
class vtkImageData;
class vtkMultiProcessController;
class vtkPolyData;

/// What one scan needs. References and pointers must outlive it.
struct lms3dDetectionRequest
{
  const lms3dScanSettings& Settings;

  /// How the scan was cast.
  const lms3dBeamCastRequest& Cast;

  /// May be null if RangeAtTenPercent is 0.
  const lms3dMovingBeams* Beams;

  vtkMultiProcessController* Controller;

  /// The progress of the whole scan.
  const lms3dProgress& Progress;
};

/// Applies RangeAtTenPercent to a scan that was cast, and finds the status of its beams. Keeps the
/// reflectances from scan to scan.
class lms3dDetection
{
public:
  /// Reads the reflectances of the scene's triangles, if the settings use them and if the scene or
  /// the name of the array changed. Throws std::runtime_error, with a text for the user, if the
  /// array is bad.
  void ReadReflectances(
    const lms3dScanSettings& settings, const lms3dBuiltScene& built, vtkDataObject* scene);

  /// Returns the reflectance of each triangle; empty if all are 1.
  const std::vector<double>& GetReflectances() const { return this->Reflectances; }

  /// Returns the progress of the first cast. Run needs the rest of the scan's progress, which must
  /// outlive the result.
  static lms3dProgress GetCastProgress(
    const lms3dProgress& scan, const lms3dScanSettings& settings);

  /**
   * Removes the weak returns from `output`, which has been cast (and reduced to the nearest of all
   * processes), and finds the status of all beams if the settings ask for it. Does nothing with
   * default settings. Returns false, in all processes, if `Progress` stopped it in one of them.
   * Collective.
   */
  bool Run(const lms3dDetectionRequest& request, lms3dScanOutput& output);

  /// Adds the array Status, if there is one, to the point data of the range image, and to the field
  /// data of `scan`, if it is not null.
  void AddStatus(const lms3dScanGeometry& geometry, vtkPolyData* scan, vtkImageData* image) const;

  /// Copies the status of each beam, if there is one.
  void CopyStatus(vtkUnsignedCharArray* status) const;

  /// Frees what only one scan needs.
  void Discard();

private:
  bool FindUnlimited(const lms3dDetectionRequest& request, const lms3dScanOutput& output);
  bool CastUnlimited(const lms3dDetectionRequest& request);
  void RemoveWeakReturns(const lms3dDetectionRequest& request, lms3dScanOutput& output);
  void MakeStatus(const lms3dDetectionRequest& request, const lms3dScanOutput& output);

  std::vector<double> Reflectances;

  ///@{
  /// What the reflectances were read for. The pointer is compared, never followed.
  std::string Array;
  vtkDataObject* Scene = nullptr;
  vtkMTimeType SceneTime = 0;
  vtkMTimeType BuildTime = 0;
  ///@}

  ///@{
  /// For one scan: what the beams meet without limits, whether this is needed, and what is too
  /// weak.
  lms3dScanOutput Unlimited;
  bool HasUnlimited = false;
  std::vector<unsigned char> IsWeak;
  vtkSmartPointer<vtkUnsignedCharArray> Status;
  ///@}
};

#endif
