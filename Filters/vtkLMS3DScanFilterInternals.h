// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What vtkLMS3DScanFilter keeps, and its properties as settings.
 */
#ifndef vtkLMS3DScanFilterInternals_h
#define vtkLMS3DScanFilterInternals_h

#include "vtkLMS3DScanFilter.h"

#include "Pipeline/lms3dErrorReport.h"
#include "Pipeline/lms3dPipelineRequests.h"
#include "Scan/lms3dProcesses.h"
#include "Scan/lms3dScanJob.h"
#include "Scan/lms3dScanSettings.h"

#include <vtkDemandDrivenPipeline.h>
#include <vtkInformationVector.h>
#include <vtkMultiProcessController.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <array>
#include <exception>
#include <string>
#include <vector>

struct vtkLMS3DScanFilter::Internals
{
  static lms3dScanSettings GetSettings(const vtkLMS3DScanFilter* filter)
  {
    const auto vector = [](const double v[3]) { return lms3dVector{ v[0], v[1], v[2] }; };
    const auto range = [](const double v[2]) { return std::array<double, 2>{ v[0], v[1] }; };
    return { vector(filter->Position), vector(filter->Orientation), range(filter->AlphaRange),
      filter->AlphaResolution, range(filter->BetaRange), filter->BetaResolution,
      { filter->MinimumRange, filter->MaximumRange }, filter->IntersectionMethod,
      filter->NumberOfThreads, filter->SurfaceAttributes, GetDeviceSettings(filter) };
  }

  // The threads wake up, and plan the scan, while the pipeline goes on. A plan of a scene that the
  // pipeline is about to replace would only take time.
  void Wake(vtkLMS3DScanFilter* self, const lms3dScanSettings& settings)
  {
    const bool isAtSettings = self->GetNumberOfInputConnections(1) == 0;
    this->Job.Wake(settings,
      isAtSettings && this->SceneTime == GetSceneTime(self) &&
        !lms3dProcesses(this->Controller).IsParallel());
  }

  // Returns the time of the pipeline that ends with the scene.
  static vtkMTimeType GetSceneTime(vtkLMS3DScanFilter* self)
  {
    auto* pipeline = vtkDemandDrivenPipeline::SafeDownCast(self->GetInputExecutive(0, 0));
    return pipeline ? pipeline->GetPipelineMTime() : 0;
  }

  static std::string FindFanError(vtkLMS3DScanFilter* self, double beta, vtkDoubleArray* ranges);

  static lms3dDeviceSettings GetDeviceSettings(const vtkLMS3DScanFilter* filter)
  {
    const double* offset = filter->AxisOffset;
    const char* reflectance = filter->ReflectanceArray;
    return { { static_cast<lms3dMounting>(filter->Mounting), { offset[0], offset[1], offset[2] },
               filter->TurnRate },
      filter->MotionDuringScan,
      { filter->BeamDiameter, filter->BeamDivergence, filter->BeamSamples, filter->PulseLength },
      { filter->RangeAtTenPercent, reflectance ? reflectance : "" },
      { filter->ComputeIncidence, filter->ComputeIntensity, filter->ComputeTime,
        filter->ComputeStatus, filter->ComputePoses } };
  }

  // RequestData reports a bad trajectory.
  void PublishTimeSteps(
    vtkPolyData* poses, const lms3dVector& orientation, vtkInformationVector* outputVector)
  {
    try
    {
      const std::vector<double>& times = this->Job.GetTrajectory(poses, orientation).GetTimes();
      lms3dSetTimeSteps(times, outputVector->GetInformationObject(0));
      lms3dSetTimeSteps(times, outputVector->GetInformationObject(1));
    }
    catch (const std::exception&)
    {
    }
  }

  vtkSmartPointer<vtkMultiProcessController> Controller;
  lms3dScanJob Job;

  // That of the scene of the last run, 0 before the first.
  vtkMTimeType SceneTime = 0;
  lms3dErrorReport Errors;
};

#endif
