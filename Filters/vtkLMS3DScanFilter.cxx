// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLMS3DScanFilter.h"

#include "lms3dAlgorithmProgress.h"
#include "lms3dRayCaster.h"
#include "lms3dScanGeometry.h"
#include "lms3dScanOutput.h"
#include "lms3dScanner.h"
#include "lms3dSceneTriangles.h"
#include "lms3dThreads.h"

#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataObjectTree.h>
#include <vtkDataObjectTreeIterator.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTimeStamp.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <vector>

vtkStandardNewMacro(vtkLMS3DScanFilter);

namespace
{
constexpr double LargestPosition = 1e18;

// What of the whole work building takes, in the eyes of the progress bar.
constexpr double BuildShare = 0.3;

// A composite does not tell when one of its parts changes.
vtkMTimeType GetSceneTime(vtkDataObject* scene)
{
  vtkMTimeType time = scene->GetMTime();
  if (vtkDataObjectTree* tree = vtkDataObjectTree::SafeDownCast(scene))
  {
    auto nodes = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
    nodes->VisitOnlyLeavesOff();
    for (nodes->InitTraversal(); !nodes->IsDoneWithTraversal(); nodes->GoToNextItem())
    {
      time = std::max(time, nodes->GetCurrentDataObject()->GetMTime());
    }
  }
  else if (vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(scene))
  {
    auto leaves = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
    {
      time = std::max(time, leaves->GetCurrentDataObject()->GetMTime());
    }
  }
  return time;
}

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

std::string TellLeftOut(const lms3dSceneTriangles& scene)
{
  std::ostringstream words;
  if (scene.SkippedCells > 0)
  {
    words << "The scene has " << scene.SkippedCells
          << " cells with a point that is not finite, or beyond 1e18 m; they are left out. ";
  }
  if (scene.CrossedCells > 0)
  {
    words
      << "The scene has " << scene.CrossedCells
      << " polygons that cross themselves; they are left out. Split them to have them scanned. ";
  }
  return words.str();
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
  bool IsBuiltFor(vtkDataObject* scene, int method) const
  {
    return this->Caster && this->Scene == scene && this->SceneTime == GetSceneTime(scene) &&
      this->Method == method;
  }

  /// Returns words on the cells that were left out, empty where all were taken.
  std::string Build(vtkDataObject* scene, int method)
  {
    this->Caster.reset();
    lms3dSceneTriangles triangles = lms3dCollectTriangles(scene);
    std::string leftOut = TellLeftOut(triangles);
    if (triangles.Mesh.Triangles.empty())
    {
      throw std::runtime_error(leftOut.empty()
          ? "The scene has no polygons, so there is nothing to scan. Connect a data set with "
            "polygons, triangle strips or volume cells."
          : "There is nothing left to scan. " + leftOut);
    }
    this->Caster = lms3dRayCaster::New(method, std::move(triangles.Mesh));
    this->Scene = scene;
    this->SceneTime = GetSceneTime(scene);
    this->Method = method;
    this->BuildTime.Modified();
    return leftOut;
  }

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

  std::unique_ptr<lms3dRayCaster> Caster;
  vtkTimeStamp BuildTime;
  lms3dThreads Threads;
  lms3dScanOutput Output;

private:
  using Angles = std::array<double, 6>;

  std::unique_ptr<lms3dScanGeometry> Geometry;
  Angles GeometryAngles;
  vtkDataObject* Scene = nullptr;
  vtkMTimeType SceneTime = 0;
  int Method = EXACT;
};

vtkLMS3DScanFilter::vtkLMS3DScanFilter()
  : Internal(new Internals)
{
  this->SetNumberOfOutputPorts(2);
}

vtkLMS3DScanFilter::~vtkLMS3DScanFilter() = default;

vtkMTimeType vtkLMS3DScanFilter::GetBuildTime() const
{
  return this->Internal->BuildTime.GetMTime();
}

vtkImageData* vtkLMS3DScanFilter::GetRangeImage()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(1));
}

const char* vtkLMS3DScanFilter::GetIntersectionMethodAsString() const
{
  static const char* const Names[] = { "Exact", "Fast", "AngleSum", "MollerTrumbore",
    "StaticCellLocator" };
  return Names[this->IntersectionMethod];
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
    vtkDataObject* scene = vtkDataObject::GetData(inputVector[0]);
    if (!this->Internal->IsBuiltFor(scene, this->IntersectionMethod))
    {
      std::string leftOut;
      this->Internal->Threads.Run(this->NumberOfThreads,
        [&] { leftOut = this->Internal->Build(scene, this->IntersectionMethod); });
      if (!leftOut.empty())
      {
        vtkWarningMacro(<< leftOut);
      }
    }
    this->UpdateProgress(BuildShare);

    const lms3dScanGeometry& geometry = this->Internal->GetGeometry(this);
    const lms3dPose pose = lms3dPose::FromOrientation(this->Position, this->Orientation);
    const lms3dRayCaster& caster = *this->Internal->Caster;
    lms3dScanOutput& output = this->Internal->Output;
    const lms3dProgress progress = lms3dReportTo(this, BuildShare, 1.0);
    this->Internal->Threads.Run(this->NumberOfThreads,
      [&]
      {
        if (output.Cast(
              caster, geometry, pose, { this->MinimumRange, this->MaximumRange }, progress))
        {
          output.FillScan(caster.GetMesh(), geometry, pose, vtkPolyData::GetData(outputVector, 0));
          output.FillRangeImage(geometry, vtkImageData::GetData(outputVector, 1));
        }
      });
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    this->SetErrorCode(vtkErrorCode::UserError);
    return 0;
  }
  return 1;
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
