// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scanning/lms3dScanPipeline.h"

#include "Common/lms3dChecksum.h"
#include "vtkLMS3DScanFilter.h"
#include "vtkLMS3DSurfaceReconstructionFilter.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace
{
// Neither to 0, which means no return, nor to infinity.
float ToFloat(double range)
{
  using Limits = std::numeric_limits<float>;
  return static_cast<float>(std::clamp<double>(range, Limits::min(), Limits::max()));
}

std::vector<float> GetRanges(vtkImageData* image)
{
  auto* ranges = vtkDoubleArray::SafeDownCast(image->GetPointData()->GetArray("Range"));
  const double* first = ranges->GetPointer(0);
  std::vector<float> floats(static_cast<std::size_t>(ranges->GetNumberOfValues()));
  std::transform(first, first + floats.size(), floats.begin(),
    [](double range) { return std::isnan(range) ? 0.0f : ToFloat(range); });
  return floats;
}

std::vector<double> GetCoordinates(vtkPolyData* map)
{
  if (map->GetNumberOfPoints() == 0)
  {
    return {};
  }
  auto* coordinates = vtkDoubleArray::SafeDownCast(map->GetPoints()->GetData());
  const double* first = coordinates->GetPointer(0);
  return { first, first + coordinates->GetNumberOfValues() };
}

template <typename Array>
std::vector<std::uint32_t> GetNumbers(Array* connectivity)
{
  const auto* first = connectivity->GetPointer(0);
  std::vector<std::uint32_t> numbers(static_cast<std::size_t>(connectivity->GetNumberOfValues()));
  std::transform(first, first + numbers.size(), numbers.begin(),
    [](auto number) { return static_cast<std::uint32_t>(number); });
  return numbers;
}

std::vector<std::uint32_t> GetTriangles(vtkPolyData* map)
{
  vtkCellArray* triangles = map->GetPolys();
  if (triangles->GetNumberOfCells() == 0)
  {
    return {};
  }
  return triangles->IsStorage64Bit() ? GetNumbers(triangles->GetConnectivityArray64())
                                     : GetNumbers(triangles->GetConnectivityArray32());
}
} // namespace

lms3dScanPipeline::lms3dScanPipeline(int threads)
  : Threads(threads)
{
  this->Scanner->SetNumberOfThreads(threads);
  lms3dAbortIf(this->Scanner, [this] { return this->ShouldAbort(); });
}

lms3dScanPipeline::~lms3dScanPipeline() = default;

std::shared_ptr<lms3dSnapshot> lms3dScanPipeline::Run(
  const lms3dScanSettings& settings, const lms3dStopTest& isOutdated)
{
  this->IsOutdated = isOutdated;
  this->Aborted = false;
  this->Configure(settings);
  // VTK does not reset the flag after a filter was aborted.
  this->Scanner->SetAbortExecute(0);
  if (this->Mapper)
  {
    this->Mapper->SetAbortExecute(0);
  }
  auto snapshot = std::make_shared<lms3dSnapshot>();
  snapshot->Header.generation = settings.Generation;
  snapshot->Header.scene = settings.Scene->Description.name;
  snapshot->Header.sensorPose = settings.Pose;
  snapshot->Header.settings = settings.Configuration;
  const bool isWhole =
    this->Scan(*snapshot) && (!settings.Configuration.makeMap || this->MakeMap(*snapshot));
  return isWhole ? snapshot : nullptr;
}

bool lms3dScanPipeline::ShouldAbort()
{
  if (this->Stopped || this->IsOutdated())
  {
    this->Aborted = true;
  }
  return this->Aborted;
}

// The mapper keeps its memory for the next map. If that is much smaller or will not come, a new mapper
// gives the memory back.
void lms3dScanPipeline::PrepareMapper(const LMS3D::Configuration& configuration)
{
  const CORBA::ULongLong beams =
    CORBA::ULongLong(configuration.alpha.count) * configuration.beta.count;
  if (!configuration.makeMap || beams < this->MapperBeams / ReleaseFactor)
  {
    this->Mapper = nullptr;
    this->MapperBeams = 0;
  }
  if (!configuration.makeMap)
  {
    return;
  }
  if (!this->Mapper)
  {
    this->Mapper = vtkSmartPointer<vtkLMS3DSurfaceReconstructionFilter>::New();
    this->Mapper->SetNumberOfThreads(this->Threads);
    this->Mapper->SetInputConnection(this->Scanner->GetOutputPort());
    lms3dAbortIf(this->Mapper, [this] { return this->ShouldAbort(); });
  }
  this->MapperBeams = std::max(this->MapperBeams, beams);
  this->Mapper->SetMaximumError(configuration.mapError);
}

void lms3dScanPipeline::Configure(const lms3dScanSettings& settings)
{
  if (this->Scene != settings.Scene)
  {
    this->Scene = settings.Scene;
    this->Scanner->SetInputData(this->Scene->Surface);
  }
  const LMS3D::Pose& pose = settings.Pose;
  this->Scanner->SetPosition(pose.position.x, pose.position.y, pose.position.z);
  this->Scanner->SetOrientation(pose.orientation.x, pose.orientation.y, pose.orientation.z);

  const LMS3D::Configuration& configuration = settings.Configuration;
  this->Scanner->SetAlphaRange(configuration.alpha.start, configuration.alpha.stop);
  this->Scanner->SetAlphaResolution(static_cast<int>(configuration.alpha.count));
  this->Scanner->SetBetaRange(configuration.beta.start, configuration.beta.stop);
  this->Scanner->SetBetaResolution(static_cast<int>(configuration.beta.count));
  this->Scanner->SetMinimumRange(configuration.minimumRange);
  this->Scanner->SetMaximumRange(configuration.maximumRange);
  this->Scanner->SetIntersectionMethod(configuration.method == LMS3D::METHOD_FAST
      ? vtkLMS3DScanFilter::FAST
      : vtkLMS3DScanFilter::EXACT);
  this->PrepareMapper(configuration);
}

bool lms3dScanPipeline::Update(vtkAlgorithm* algorithm, double& seconds) const
{
  lms3dAlgorithmMessages messages(algorithm);
  const auto start = std::chrono::steady_clock::now();
  algorithm->Update();
  seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  // The outputs of an aborted filter have no arrays.
  if (this->Aborted)
  {
    return false;
  }
  const std::string error = messages.TakeError();
  if (!error.empty())
  {
    throw std::runtime_error(error);
  }
  return true;
}

// Modified(), because the loop scans again even if nothing has changed.
bool lms3dScanPipeline::Scan(lms3dSnapshot& snapshot)
{
  this->Scanner->Modified();
  if (!this->Update(this->Scanner, snapshot.ScanSeconds))
  {
    return false;
  }
  snapshot.Ranges = GetRanges(this->Scanner->GetRangeImage());
  snapshot.Header.beams = static_cast<CORBA::ULong>(snapshot.Ranges.size());
  snapshot.Header.returns =
    static_cast<CORBA::ULong>(this->Scanner->GetOutput()->GetNumberOfPoints());
  snapshot.Header.rangesChecksum = lms3dGetRangesChecksum(snapshot.Ranges);
  snapshot.Header.mapPoints = 0;
  snapshot.Header.mapTriangles = 0;
  snapshot.Header.mapChecksum = lms3dGetMapChecksum({}, {});
  return true;
}

bool lms3dScanPipeline::MakeMap(lms3dSnapshot& snapshot)
{
  if (!this->Update(this->Mapper, snapshot.MapSeconds))
  {
    return false;
  }
  snapshot.MapPoints = GetCoordinates(this->Mapper->GetOutput());
  snapshot.MapTriangles = GetTriangles(this->Mapper->GetOutput());
  snapshot.Header.mapPoints = static_cast<CORBA::ULong>(snapshot.MapPoints.size() / 3);
  snapshot.Header.mapTriangles = static_cast<CORBA::ULong>(snapshot.MapTriangles.size() / 3);
  snapshot.Header.mapChecksum = lms3dGetMapChecksum(snapshot.MapPoints, snapshot.MapTriangles);
  return true;
}
