// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FusionJourney.h"

#include "Timer.h"
#include "VisibleScene.h"

#include "vtkLMS3DMapComparison.h"
#include "vtkLMS3DMapFusion.h"
#include "vtkLMS3DScanFilter.h"
#include "vtkLMS3DSurfaceReconstructionFilter.h"
#include "vtkVRMLImporterSource.h"

#include <vtkAppendPolyData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <stdexcept>

namespace
{
constexpr double Bound = 0.01; // metres
constexpr int Samples = 20000;
/// One pose of this number is a view by which completeness is measured.
constexpr int PosesPerView = 25;
// As getFusedMap() of LMS3DScanner.idl sends them.
constexpr double BytesPerPoint = 12.0;
constexpr double BytesPerTriangle = 12.0;
constexpr double BytesPerRegion = 12.0;

double GetBytes(vtkPolyData* map)
{
  return BytesPerPoint * static_cast<double>(map->GetNumberOfPoints()) +
    BytesPerTriangle * static_cast<double>(map->GetNumberOfCells());
}

vtkSmartPointer<vtkPolyData> Copy(vtkPolyData* data)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(data);
  return copy;
}
} // namespace

FusionJourney::FusionJourney(int threads)
{
  vtkNew<vtkVRMLImporterSource> scene;
  scene->SetFileName(LMS3D_DATA_DIR "/building.wrl");
  scene->Update();
  this->Scene = scene->GetOutput();
  vtkNew<vtkXMLPolyDataReader> journey;
  journey->SetFileName(LMS3D_DATA_DIR "/building_journey.vtp");
  journey->Update();
  if (this->Scene->GetNumberOfCells() == 0 || journey->GetOutput()->GetNumberOfPoints() == 0)
  {
    throw std::runtime_error("cannot read building.wrl and building_journey.vtp");
  }
  this->Visible = std::make_unique<VisibleScene>(this->Scene);
  this->Sensor->SetInputData(this->Scene);
  this->Sensor->SetTrajectoryData(journey->GetOutput());
  this->Mapper->SetInputConnection(this->Sensor->GetOutputPort());
  this->Mapper->SetMaximumError(Bound);
  this->Fusion->SetMaximumError(Bound);
  this->Sensor->SetNumberOfThreads(threads);
  this->Mapper->SetNumberOfThreads(threads);
  this->Fusion->SetNumberOfThreads(threads);
  this->Sensor->UpdateTimeStep(0.0); // builds the acceleration structure
}

FusionJourney::~FusionJourney() = default;

FusionTimes FusionJourney::DriveTo(int poses)
{
  const int before = static_cast<int>(this->Maps.size());
  FusionTimes times;
  for (int i = before; i < poses; ++i)
  {
    this->DriveOneStep(times);
  }
  const double count = std::max(1, poses - before);
  return { times.Scan / count, times.Map / count, times.Fusion / count, times.SlowestFusion };
}

void FusionJourney::DriveOneStep(FusionTimes& sum)
{
  const int pose = static_cast<int>(this->Maps.size());
  // The first scan is made already; a scan of a time that the filter has takes no time.
  this->Sensor->Modified();
  sum.Scan += GetMilliseconds([&] { this->Sensor->UpdateTimeStep(pose); });
  sum.Map += GetMilliseconds([&] { this->Mapper->UpdateTimeStep(pose); });
  this->RevisionBefore = this->Fusion->GetRevision();
  const double ms = GetMilliseconds(
    [&]
    {
      this->Fusion->AddScan(this->Mapper->GetOutput(), this->Sensor->GetOutput());
      this->Fusion->Update();
    });
  sum.Fusion += ms;
  sum.SlowestFusion = std::max(sum.SlowestFusion, ms);
  this->Visible->Add(this->Sensor->GetOutput());
  this->Maps.push_back(Copy(this->Mapper->GetOutput()));
  if (pose % PosesPerView == 0)
  {
    this->Views.push_back(Copy(this->Sensor->GetOutput()));
  }
}

FusionSizes FusionJourney::Measure()
{
  vtkPolyData* const map = this->Fusion->GetOutput();
  vtkNew<vtkAppendPolyData> all;
  for (const auto& local : this->Maps)
  {
    all->AddInputData(local);
  }
  all->Update();
  vtkNew<vtkPolyData> changes;
  this->Fusion->GetChanges(this->RevisionBefore, changes);
  const vtkIdType regions =
    changes->GetFieldData()->GetArray("ChangedRegions")->GetNumberOfTuples();
  return { map->GetNumberOfCells(), all->GetOutput()->GetNumberOfCells(),
    this->Visible->CountTriangles(), this->GetCompleteness(map),
    this->GetCompleteness(all->GetOutput()),
    GetBytes(changes) + BytesPerRegion * static_cast<double>(regions), GetBytes(map) };
}

double FusionJourney::GetCompleteness(vtkPolyData* map) const
{
  double sum = 0.0;
  for (const auto& view : this->Views)
  {
    vtkNew<vtkLMS3DMapComparison> comparison;
    comparison->SetInputData(map);
    comparison->SetSceneData(this->Scene);
    comparison->SetScanData(view);
    comparison->SetTolerance(Bound);
    comparison->SetNumberOfSamples(Samples);
    comparison->Update();
    sum += comparison->GetCompleteness();
  }
  return sum / static_cast<double>(this->Views.size());
}
