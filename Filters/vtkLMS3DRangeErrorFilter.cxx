// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLMS3DRangeErrorFilter.h"

#include "Device/lms3dDevices.h"
#include "Device/lms3dRangeImage.h"
#include "Pipeline/lms3dAlgorithmProgress.h"
#include "Pipeline/lms3dErrorReport.h"
#include "Pipeline/lms3dFailure.h"
#include "Pipeline/lms3dPipelineRequests.h"
#include "RangeErrors/lms3dRangeErrorJob.h"
#include "RangeErrors/lms3dRangeErrors.h"
#include "Scan/lms3dProcesses.h"

#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMultiProcessController.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <limits>
#include <string>

vtkStandardNewMacro(vtkLMS3DRangeErrorFilter);

struct vtkLMS3DRangeErrorFilter::Internals
{
  static lms3dRangeErrorSettings GetSettings(const vtkLMS3DRangeErrorFilter* filter)
  {
    return { filter->RangeBias, filter->RangeNoise, filter->RangeResolution, filter->NoiseSeed };
  }

  vtkSmartPointer<vtkMultiProcessController> Controller;
  lms3dRangeErrorJob Job;
  lms3dErrorReport Errors;
};

vtkLMS3DRangeErrorFilter::vtkLMS3DRangeErrorFilter()
  : Internal(new Internals)
{
  this->SetNumberOfOutputPorts(2);
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkLMS3DRangeErrorFilter::~vtkLMS3DRangeErrorFilter() = default;

void vtkLMS3DRangeErrorFilter::SetController(vtkMultiProcessController* controller)
{
  if (this->Internal->Controller != controller)
  {
    this->Internal->Controller = controller;
    this->Modified();
  }
}

vtkMultiProcessController* vtkLMS3DRangeErrorFilter::GetController() const
{
  return this->Internal->Controller;
}

vtkImageData* vtkLMS3DRangeErrorFilter::GetRangeImage()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(1));
}

void vtkLMS3DRangeErrorFilter::SetDevice(int device)
{
  const lms3dDevice* values = lms3dGetDevice(device);
  if (!values)
  {
    vtkErrorMacro("Device " << device << ": must be from " << IDEAL << " (" << GetDeviceName(IDEAL)
                            << ") to " << LMS291 << " (" << GetDeviceName(LMS291)
                            << "). Nothing changes.");
    return;
  }
  this->SetRangeBias(values->RangeBias);
  this->SetRangeNoise(values->RangeNoise);
  this->SetRangeResolution(values->RangeResolution);
}

int vtkLMS3DRangeErrorFilter::GetDevice() const
{
  return lms3dFindDevice(
    [this](const lms3dDevice& device)
    {
      return this->RangeBias == device.RangeBias && this->RangeNoise == device.RangeNoise &&
        this->RangeResolution == device.RangeResolution;
    });
}

int vtkLMS3DRangeErrorFilter::GetNumberOfDevices()
{
  return lms3dGetNumberOfDevices();
}

const char* vtkLMS3DRangeErrorFilter::GetDeviceName(int device)
{
  return lms3dGetDeviceName(device);
}

double vtkLMS3DRangeErrorFilter::GetDeviceValue(int device, const char* property)
{
  return lms3dGetDeviceValue(device, property ? property : "");
}

int vtkLMS3DRangeErrorFilter::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkImageData");
  return 1;
}

int vtkLMS3DRangeErrorFilter::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* input = inputVector[0]->GetInformationObject(0);
  vtkInformation* image = outputVector->GetInformationObject(1);
  if (input->Has(Pipeline::WHOLE_EXTENT()))
  {
    image->CopyEntry(input, Pipeline::WHOLE_EXTENT());
    image->CopyEntry(input, vtkDataObject::ORIGIN());
    image->CopyEntry(input, vtkDataObject::SPACING());
    vtkDataObject::SetPointDataActiveScalarInfo(image, VTK_DOUBLE, 1);
    return 1;
  }
  // The data of a scan that does not come from the filter has the size of its range image.
  vtkMultiProcessController* controller = this->Internal->Controller;
  const lms3dProcesses processes(controller);
  lms3dUpdateInput(this, 0, processes.GetRank(), processes.GetCount());
  vtkPolyData* scan = vtkPolyData::GetData(inputVector[0]);
  if (!scan)
  {
    return 1;
  }
  const std::string error = lms3dRunAndGetError(
    [&]
    {
      if (const lms3dScanGeometry* geometry = this->Internal->Job.GetGeometry(scan, controller))
      {
        lms3dDescribeRangeImage(*geometry, image);
      }
    },
    "There is not enough memory for the angles of the scan.");
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    return 0;
  }
  return 1;
}

int vtkLMS3DRangeErrorFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  const lms3dProcesses processes(this->Internal->Controller);
  lms3dRequestPiece(
    processes.GetRank(), processes.GetCount(), inputVector[0]->GetInformationObject(0));
  return 1;
}

int vtkLMS3DRangeErrorFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // Without SetErrorCode(), which modifies the filter, so that every update would run it again.
  this->ErrorCode = vtkErrorCode::NoError;
  // An image that the pipeline empties keeps its scalars.
  vtkImageData::GetData(outputVector, 1)->GetPointData()->SetScalars(nullptr);
  vtkMultiProcessController* controller = this->Internal->Controller;
  // In one process the first piece is the whole scan, and other pieces are empty.
  if (!lms3dProcesses(controller).IsParallel() &&
    !lms3dIsFirstPiece(lms3dGetRequestedOutput(request, outputVector)))
  {
    return 1;
  }
  const lms3dRangeErrorSettings settings = Internals::GetSettings(this);
  std::string error = lms3dFindRangeErrorProblem(settings);
  bool isDone = false;
  if (error.empty())
  {
    const lms3dRangeErrorJobRequest job = { settings, this->NumberOfThreads, controller,
      vtkPolyData::GetData(inputVector[0]), outputVector, lms3dReportTo(this, 0.0, 1.0) };
    error = lms3dRunAndGetError([&] { isDone = this->Internal->Job.Run(job); },
      "There is not enough memory for the scan with errors. Choose lower resolutions for the "
      "scan.");
  }
  if (!error.empty())
  {
    this->ErrorCode = vtkErrorCode::UserError;
    return this->Internal->Errors.Report(this, error, outputVector);
  }
  if (!isDone)
  {
    lms3dClearOutputs(outputVector);
  }
  return 1;
}

bool vtkLMS3DRangeErrorFilter::AddErrors(double time, int turn, vtkDoubleArray* ranges)
{
  if (!ranges)
  {
    vtkErrorMacro("There is no array of ranges. Pass a vtkDoubleArray.");
    return false;
  }
  const lms3dRangeErrorSettings settings = Internals::GetSettings(this);
  std::string error = lms3dFindRangeErrorProblem(settings);
  if (error.empty() && turn < 0)
  {
    error = "The turn is below 0. Turns count from 0.";
  }
  if (error.empty() && ranges->GetNumberOfValues() > std::numeric_limits<int>::max())
  {
    error = "A turn has more beams than an int can count. Pass one turn at a time.";
  }
  if (error.empty() && !settings.AreOff())
  {
    error = lms3dRunAndGetError(
      [&]
      {
        lms3dAddRangeErrors(settings, lms3dGetScanNumber(time), turn,
          static_cast<int>(ranges->GetNumberOfValues()), ranges->GetPointer(0));
        ranges->Modified();
      },
      "There is not enough memory for the errors of a turn.");
  }
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
  }
  return error.empty();
}

void vtkLMS3DRangeErrorFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Device: " << this->GetDevice() << '\n';
  os << indent << "RangeBias: " << this->RangeBias << '\n';
  os << indent << "RangeNoise: " << this->RangeNoise << '\n';
  os << indent << "RangeResolution: " << this->RangeResolution << '\n';
  os << indent << "NoiseSeed: " << this->NoiseSeed << '\n';
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << '\n';
  os << indent << "Controller: " << this->GetController() << '\n';
}
