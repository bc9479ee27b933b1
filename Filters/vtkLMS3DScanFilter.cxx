// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLMS3DScanFilter.h"

#include "lms3dAlgorithmProgress.h"
#include "lms3dBuiltScene.h"
#include "lms3dRayCaster.h"
#include "lms3dScanGeometry.h"
#include "lms3dScanOutput.h"
#include "lms3dScanner.h"
#include "lms3dThreads.h"

#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>
#include <sstream>
#include <stdexcept>
#include <vector>

vtkStandardNewMacro(vtkLMS3DScanFilter);

namespace
{
constexpr double LargestPosition = 1e18;

// What of the whole work building takes, in the eyes of the progress bar.
constexpr double BuildShare = 0.3;

template <std::size_t N>
bool IsFinite(const double (&values)[N])
{
  return std::all_of(values, values + N, [](double x) { return std::isfinite(x); });
}

// A scan is one piece; those who ask for another, such as a second process, get an empty one.
bool IsFirstPiece(vtkInformation* request, vtkInformationVector* outputVector)
{
  const int port = std::max(0, request->Get(vtkExecutive::FROM_OUTPUT_PORT()));
  vtkInformation* output = outputVector->GetInformationObject(port);
  const auto piece = vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER();
  return !output->Has(piece) || output->Get(piece) <= 0;
}

// Two different ends, or one beam that needs only the first.
bool IsProperRange(const double range[2], int resolution)
{
  return range[0] < range[1] || (resolution == 1 && range[0] == range[1]);
}

template <typename T>
std::string Pair(const T values[2])
{
  std::ostringstream words;
  words << values[0] << " to " << values[1];
  return words.str();
}
} // namespace

struct vtkLMS3DScanFilter::Internals
{
  /// Tables of sines and cosines are made for new angles only.
  const lms3dScanGeometry& GetGeometry(const vtkLMS3DScanFilter* filter)
  {
    const Angles angles = { filter->AlphaRange[0], filter->AlphaRange[1],
      static_cast<double>(filter->AlphaResolution), filter->BetaRange[0], filter->BetaRange[1],
      static_cast<double>(filter->BetaResolution) };
    if (!this->Geometry || angles != this->GeometryAngles)
    {
      this->Geometry = std::make_unique<lms3dScanGeometry>(
        filter->AlphaRange, filter->AlphaResolution, filter->BetaRange, filter->BetaResolution);
      this->GeometryAngles = angles;
    }
    return *this->Geometry;
  }

  lms3dBuiltScene Scene;
  lms3dThreads Threads;
  lms3dScanOutput Output;

private:
  using Angles = std::array<double, 6>;

  std::unique_ptr<lms3dScanGeometry> Geometry;
  Angles GeometryAngles;
};

vtkLMS3DScanFilter::vtkLMS3DScanFilter()
  : Internal(new Internals)
{
  this->SetNumberOfOutputPorts(2);
}

vtkLMS3DScanFilter::~vtkLMS3DScanFilter() = default;

vtkMTimeType vtkLMS3DScanFilter::GetBuildTime() const
{
  return this->Internal->Scene.GetBuildTime();
}

vtkImageData* vtkLMS3DScanFilter::GetRangeImage()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(1));
}

const char* vtkLMS3DScanFilter::GetIntersectionMethodAsString() const
{
  return GetIntersectionMethodName(this->IntersectionMethod);
}

int vtkLMS3DScanFilter::GetNumberOfIntersectionMethods()
{
  return lms3dRayCaster::GetNumberOfMethods();
}

const char* vtkLMS3DScanFilter::GetIntersectionMethodName(int method)
{
  const bool isMethod = method >= 0 && method < GetNumberOfIntersectionMethods();
  return isMethod ? lms3dRayCaster::GetMethodName(method) : nullptr;
}

int vtkLMS3DScanFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkLMS3DScanFilter::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkImageData");
  return 1;
}

std::string vtkLMS3DScanFilter::GetPropertyError() const
{
  std::ostringstream error;
  const auto isFar = [](double x) { return std::abs(x) > LargestPosition; };
  if (!IsFinite(this->Position) || std::any_of(this->Position, this->Position + 3, isFar) ||
    !IsFinite(this->Orientation))
  {
    error << "The pose is Position " << this->Position[0] << ' ' << this->Position[1] << ' '
          << this->Position[2] << ", Orientation " << this->Orientation[0] << ' '
          << this->Orientation[1] << ' ' << this->Orientation[2]
          << "; finite numbers are expected, positions up to 1e18 m.";
  }
  else if (this->AlphaResolution < 1 || this->BetaResolution < 1)
  {
    error << "AlphaResolution x BetaResolution is " << this->AlphaResolution << " x "
          << this->BetaResolution << "; each must be at least 1.";
  }
  else if (static_cast<std::int64_t>(this->AlphaResolution) * this->BetaResolution >
    std::numeric_limits<std::int32_t>::max())
  {
    error << "AlphaResolution x BetaResolution is " << this->AlphaResolution << " x "
          << this->BetaResolution << " beams; at most 2147483647 are possible.";
  }
  else if (!IsProperRange(this->AlphaRange, this->AlphaResolution) || this->AlphaRange[0] < -90.0 ||
    this->AlphaRange[1] > 90.0)
  {
    error << "AlphaRange is " << Pair(this->AlphaRange)
          << " degrees; it must increase, within -90 to 90.";
  }
  else if (!IsFinite(this->BetaRange) || !IsProperRange(this->BetaRange, this->BetaResolution) ||
    this->BetaRange[1] - this->BetaRange[0] > 360.0)
  {
    error << "BetaRange is " << Pair(this->BetaRange)
          << " degrees; it must increase, by at most 360.";
  }
  else if (!(this->MinimumRange >= 0.0 && this->MinimumRange <= this->MaximumRange &&
             this->MaximumRange > 0.0 && std::isfinite(this->MinimumRange)))
  {
    error << "MinimumRange and MaximumRange are " << this->MinimumRange << " and "
          << this->MaximumRange << " m; 0 <= minimum <= maximum and 0 < maximum are expected.";
  }
  return error.str();
}

int vtkLMS3DScanFilter::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  // RequestData reports bad properties; an extent needs good ones.
  if (this->GetPropertyError().empty())
  {
    lms3dDescribeRangeImage(this->AlphaRange, this->AlphaResolution, this->BetaRange,
      this->BetaResolution, outputVector->GetInformationObject(1));
  }
  return 1;
}

int vtkLMS3DScanFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  // Every beam may meet any part of the scene, whatever part of the outputs is asked for.
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* input = inputVector[0]->GetInformationObject(0);
  input->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
  input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
  input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  if (input->Has(Pipeline::WHOLE_EXTENT()))
  {
    input->Set(Pipeline::UPDATE_EXTENT(), input->Get(Pipeline::WHOLE_EXTENT()), 6);
  }
  return 1;
}

int vtkLMS3DScanFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  // An image keeps its arrays from one execution to the next.
  vtkImageData::GetData(outputVector, 1)->Initialize();
  if (!IsFirstPiece(request, outputVector))
  {
    return 1;
  }
  const std::string propertyError = this->GetPropertyError();
  if (!propertyError.empty())
  {
    vtkErrorMacro(<< propertyError);
    this->SetErrorCode(vtkErrorCode::UserError);
    return 0;
  }

  try
  {
    this->Scan(vtkDataObject::GetData(inputVector[0]), vtkPolyData::GetData(outputVector, 0),
      vtkImageData::GetData(outputVector, 1));
  }
  catch (const std::bad_alloc&)
  {
    vtkErrorMacro("There is not enough memory for the scan. Simplify the scene, or lower the "
                  "resolutions.");
    this->SetErrorCode(vtkErrorCode::UserError);
    return 0;
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    this->SetErrorCode(vtkErrorCode::UserError);
    return 0;
  }
  return 1;
}

void vtkLMS3DScanFilter::Scan(vtkDataObject* scene, vtkPolyData* scan, vtkImageData* image)
{
  lms3dBuiltScene& built = this->Internal->Scene;
  if (!built.IsFor(scene, this->IntersectionMethod))
  {
    std::string leftOut;
    this->Internal->Threads.Run(
      this->NumberOfThreads, [&] { leftOut = built.Build(scene, this->IntersectionMethod); });
    if (!leftOut.empty())
    {
      vtkWarningMacro(<< leftOut);
    }
  }
  this->UpdateProgress(BuildShare);

  const lms3dScanGeometry& geometry = this->Internal->GetGeometry(this);
  const lms3dPose pose = lms3dPose::FromOrientation(this->Position, this->Orientation);
  const lms3dRayCaster& caster = built.GetCaster();
  lms3dScanOutput& output = this->Internal->Output;
  const lms3dProgress progress = lms3dReportTo(this, BuildShare, 1.0);
  this->Internal->Threads.Run(this->NumberOfThreads,
    [&]
    {
      if (output.Cast(caster, geometry, pose, { this->MinimumRange, this->MaximumRange }, progress))
      {
        output.FillScan(caster.GetMesh(), geometry, pose, scan);
        output.FillRangeImage(geometry, image);
      }
    });
  output.Discard();
}

void vtkLMS3DScanFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto vector = [&os](const double* v) { os << v[0] << ' ' << v[1] << ' ' << v[2] << '\n'; };
  os << indent << "Position: ";
  vector(this->Position);
  os << indent << "Orientation: ";
  vector(this->Orientation);
  os << indent << "AlphaRange: " << Pair(this->AlphaRange) << '\n';
  os << indent << "AlphaResolution: " << this->AlphaResolution << '\n';
  os << indent << "BetaRange: " << Pair(this->BetaRange) << '\n';
  os << indent << "BetaResolution: " << this->BetaResolution << '\n';
  os << indent << "MinimumRange: " << this->MinimumRange << '\n';
  os << indent << "MaximumRange: " << this->MaximumRange << '\n';
  os << indent << "IntersectionMethod: " << this->GetIntersectionMethodAsString() << '\n';
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << '\n';
  os << indent << "BuildTime: " << this->GetBuildTime() << '\n';
}
