// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scanning/lms3dFusedMapMaker.h"

#include "Common/lms3dLog.h"
#include "Scanning/lms3dAlgorithmObservers.h"
#include "Scanning/lms3dFusedRegions.h"
#include "vtkLMS3DMapFusion.h"

#include <vtkPolyData.h>

#include <chrono>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#include <numeric>
#include <string>

namespace
{
constexpr double BytesPerBeam = 4.0;

// The farthest return in each of 90 x 180 directions.
constexpr double BytesPerScan = 65e3;

// A full block of 64 x 64 cells has 4.6 kB, but the blocks at borders are not full.
constexpr double BytesPerCell = 1.7;

// In the worst case each triangle of a local map becomes a region of its own, with a block of cells
// for its small area, and its outline.
constexpr double BytesPerRegion = 6e3;

// Relative, of a coordinate.
constexpr double RoundingOfFloats = std::numeric_limits<float>::epsilon() / 2.0;

// The share of the error bound that rounding may take at the sensor.
constexpr double MaximumRounding = 0.1;

std::uint64_t CountBeams(const LMS3D::Configuration& configuration)
{
  return std::uint64_t(configuration.alpha.count) * configuration.beta.count;
}
} // namespace

lms3dFusedMapMaker::lms3dFusedMapMaker(
  const lms3dFusedMapOptions& options, std::uint64_t incarnation, lms3dFusedMapStore& store)
  : Options(options)
  , Store(store)
{
  this->Fusion->SetMaximumError(options.MaximumError);
  this->Fusion->SetNumberOfThreads(options.Threads);
  lms3dAbortIf(this->Fusion, [this] { return this->Stopped.load(); });
  this->State.Header.number = incarnation;
  this->State.Header.incarnation = incarnation;
  this->State.Header.maximumError = options.MaximumError;
}

lms3dFusedMapMaker::~lms3dFusedMapMaker() = default;

void lms3dFusedMapMaker::Add(
  const lms3dScanSettings& settings, std::uint64_t number, vtkPolyData* map, vtkPolyData* scan)
{
  if (settings.Generation == this->Generation)
  {
    return;
  }
  this->Generation = settings.Generation;
  const bool isNewMap = settings.FusedMap != this->MapSettings;
  if (isNewMap)
  {
    this->BeginMap(settings);
  }
  const auto start = std::chrono::steady_clock::now();
  std::string problem = this->FindProblem(settings, map);
  if (problem.empty())
  {
    problem = this->Fuse(map, scan);
  }
  if (this->Stopped)
  {
    return;
  }
  this->SetProblem(problem);
  if (problem.empty())
  {
    this->PublishScan(settings, number, start);
  }
  else if (isNewMap)
  {
    this->Publish({});
  }
}

void lms3dFusedMapMaker::BeginMap(const lms3dScanSettings& settings)
{
  this->Fusion->Reset();
  this->PublishedRevision = this->Fusion->GetRevision();
  this->MapSettings = settings.FusedMap;
  this->Beams = 0;
  this->State.Regions.clear();
  LMS3D::FusedMapHeader& header = this->State.Header;
  header.firstNumber = header.number + 1;
  header.scans = 0;
  header.newestScan = 0;
  header.seconds = 0.0;
  header.allTriangles = 0;
  header.scene = settings.Scene->Description.name;
}

std::string lms3dFusedMapMaker::FindProblem(
  const lms3dScanSettings& settings, vtkPolyData* map) const
{
  const LMS3D::Configuration& configuration = settings.Configuration;
  if (!map || !(configuration.mapError > 0.0) ||
    configuration.mapError > this->Options.MaximumError)
  {
    return "the configuration needs makeMap, and a mapError above 0 and up to " +
      std::to_string(this->Options.MaximumError) + " m";
  }
  if (this->IsTooFar(settings.Pose.position))
  {
    return "the sensor is so far from the origin of the map that floats are too coarse; "
           "resetFusedMap() begins a new map";
  }
  if (this->EstimateBytes(settings, map) > this->Options.MaximumBytes)
  {
    return "another scan would exceed --fused-memory; resetFusedMap() begins a new map";
  }
  return "";
}

bool lms3dFusedMapMaker::IsTooFar(const LMS3D::Vector3& position) const
{
  const LMS3D::Vector3& origin = this->State.Header.origin;
  const double distance =
    std::hypot(position.x - origin.x, position.y - origin.y, position.z - origin.z);
  return !this->State.Regions.empty() &&
    RoundingOfFloats * distance > MaximumRounding * this->Options.MaximumError;
}

double lms3dFusedMapMaker::EstimateBytes(const lms3dScanSettings& settings, vtkPolyData* map) const
{
  double area = lms3dGetArea(map);
  auto regions = static_cast<double>(map->GetNumberOfPolys());
  for (const auto& region : this->State.Regions)
  {
    area += region->Area;
    regions += region->IsRemoved() ? 0.0 : 1.0;
  }
  const double cell = this->Options.MaximumError / 3.0;
  return BytesPerBeam * static_cast<double>(this->Beams + CountBeams(settings.Configuration)) +
    BytesPerScan * (this->Fusion->GetNumberOfScans() + 1) + BytesPerRegion * regions +
    BytesPerCell * area / (cell * cell);
}

std::string lms3dFusedMapMaker::Fuse(vtkPolyData* map, vtkPolyData* scan)
{
  lms3dAlgorithmMessages messages(this->Fusion);
  // VTK does not reset the flag after a filter was aborted.
  this->Fusion->SetAbortExecute(0);
  try
  {
    return this->Fusion->AddScan(map, scan) ? "" : messages.TakeError();
  }
  catch (const std::exception& problem)
  {
    return problem.what();
  }
}

void lms3dFusedMapMaker::PublishScan(const lms3dScanSettings& settings, std::uint64_t number,
  std::chrono::steady_clock::time_point start)
{
  this->Beams += CountBeams(settings.Configuration);
  LMS3D::FusedMapHeader& header = this->State.Header;
  if (this->State.Regions.empty())
  {
    header.origin = settings.Pose.position;
  }
  header.scans = static_cast<CORBA::ULong>(this->Fusion->GetNumberOfScans());
  header.newestScan = number;
  const lms3dFusedRegions changes =
    lms3dTakeFusedChanges(this->Fusion, this->PublishedRevision, header.origin, header.number + 1);
  header.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  this->Publish(changes);
  this->PublishedRevision = this->Fusion->GetRevision();
}

void lms3dFusedMapMaker::Publish(const lms3dFusedRegions& changes)
{
  LMS3D::FusedMapHeader& header = this->State.Header;
  ++header.number;
  lms3dReplaceFusedRegions(changes, header.number, this->State.Regions);
  header.allTriangles = std::accumulate(this->State.Regions.begin(), this->State.Regions.end(), 0U,
    [](CORBA::ULong sum, const auto& region)
    { return sum + static_cast<CORBA::ULong>(region->Triangles.size() / 3); });
  this->Store.Publish(std::make_shared<const lms3dFusedMapState>(this->State));
}

void lms3dFusedMapMaker::SetProblem(const std::string& problem)
{
  if (problem == this->Store.GetProblem())
  {
    return;
  }
  this->Store.SetProblem(problem);
  lms3dLog(lms3dLogKind::Scans,
    problem.empty() ? "scans are added to the fused map again"
                    : "not in the fused map: " + problem);
}
