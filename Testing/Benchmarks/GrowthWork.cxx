// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "GrowthWork.h"

#include "Memory.h"
#include "Pipeline/lms3dThreads.h"
#include "Scan/lms3dBuiltScene.h"
#include "Scenes.h"
#include "Timer.h"

#include "vtkLMS3DScanFilter.h"
#include "vtkLMS3DSurfaceReconstructionFilter.h"

#include <vtkNew.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>

namespace
{
constexpr double MapBound = 0.01; // metres

constexpr double Megabyte = 1e6;

/// Milliseconds, and bytes: held for what was made, and the most that was taken at any time.
struct Cost
{
  double Milliseconds;
  double Held;
  double Peak;
};

std::vector<double> GetNumbers(const GrowthSetting& setting, const Cost& cost)
{
  return { setting.GetBeams(), cost.Milliseconds, cost.Held / Megabyte, cost.Peak / Megabyte };
}

// The first run takes the memory, which costs time of its own; the best of the others counts.
Cost Measure(double budget, const std::function<void()>& prepare, const std::function<void()>& work)
{
  const MemoryMeter meter;
  prepare();
  work();
  Cost cost = { std::numeric_limits<double>::infinity(), meter.GetGrowth(), meter.GetPeak() };
  for (double spent = 0.0; spent < budget;)
  {
    prepare();
    const double ms = GetMilliseconds(work);
    cost.Milliseconds = std::min(cost.Milliseconds, ms);
    spent += ms;
  }
  return cost;
}

Cost MeasureUpdate(vtkAlgorithm* filter, double budget)
{
  return Measure(
    budget, [&] { filter->Modified(); }, [&] { filter->Update(); });
}

/// A filter that has built what its method needs, and has cast one beam.
vtkSmartPointer<vtkLMS3DScanFilter> MakeScan(const GrowthSetting& setting, int method)
{
  auto filter = vtkSmartPointer<vtkLMS3DScanFilter>::New();
  const std::array<double, 3>& sensor = setting.Scene.Sensor;
  filter->SetInputData(setting.Scene.Surface);
  filter->SetPosition(sensor[0], sensor[1], sensor[2]);
  filter->SetIntersectionMethod(method);
  filter->SetNumberOfThreads(setting.Threads);
  filter->SetAlphaResolution(1);
  filter->SetBetaResolution(1);
  filter->Update();
  return filter;
}

// What a first filter takes for libraries and threads is not the scene's.
void Load(int method, int threads)
{
  const BenchmarkScene scene = MakeTerrain(2);
  const auto scan = MakeScan({ "", scene, 1, 1, threads }, method);
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> map;
  map->SetInputConnection(scan->GetOutputPort());
  map->SetNumberOfThreads(threads);
  map->Update();
}

// As the filter does it before its first beam.
std::vector<double> MeasureBuild(
  const GrowthSetting& setting, int method, const GrowthLimits& limits)
{
  Load(method, setting.Threads);
  lms3dThreads threads;
  std::unique_ptr<lms3dBuiltScene> built;
  const auto discard = [&] { built = std::make_unique<lms3dBuiltScene>(); };
  const auto goOn = [](double) { return true; };
  const auto build = [&]
  { threads.Run(setting.Threads, [&] { built->Update(setting.Scene.Surface, method, goOn); }); };
  return GetNumbers(setting, Measure(limits.Budget, discard, build));
}

std::vector<double> MeasureScan(GrowthSetting setting, int method, const GrowthLimits& limits)
{
  Load(method, setting.Threads);
  const auto filter = MakeScan(setting, method);
  filter->SetAlphaResolution(setting.Alphas);
  filter->SetBetaResolution(setting.Betas);
  if (setting.MayThin())
  {
    const ThinnedGrid chosen = ThinnedGrid::Choose(limits.LongScan,
      [&](const ThinnedGrid& grid)
      {
        grid.Apply(filter);
        filter->Modified();
        filter->Update();
      });
    chosen.Apply(filter);
    setting.Alphas = chosen.GetAlphaResolution();
    setting.Betas = chosen.GetBetaResolution();
  }
  return GetNumbers(setting, MeasureUpdate(filter, limits.Budget));
}

std::vector<double> MeasureMap(
  const GrowthSetting& setting, double bound, const GrowthLimits& limits)
{
  Load(vtkLMS3DScanFilter::EXACT, setting.Threads);
  const auto scan = MakeScan(setting, vtkLMS3DScanFilter::EXACT);
  scan->SetAlphaResolution(setting.Alphas);
  scan->SetBetaResolution(setting.Betas);
  scan->Update();
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> map;
  map->SetInputData(scan->GetOutput());
  map->SetMaximumError(bound);
  map->SetDepthStep(setting.Scene.DepthStep);
  map->SetNumberOfThreads(setting.Threads);
  return GetNumbers(setting, MeasureUpdate(map, limits.Budget));
}

std::vector<GrowthWork> GetWorksOfMethods(const std::string& name,
  const std::function<std::vector<double>(const GrowthSetting&, int, const GrowthLimits&)>& measure)
{
  std::vector<GrowthWork> works;
  works.reserve(vtkLMS3DScanFilter::GetNumberOfIntersectionMethods());
  for (int method = 0; method < vtkLMS3DScanFilter::GetNumberOfIntersectionMethods(); ++method)
  {
    works.push_back({ name, vtkLMS3DScanFilter::GetIntersectionMethodName(method),
      [measure, method](const GrowthSetting& setting, const GrowthLimits& limits)
      { return measure(setting, method, limits); } });
  }
  return works;
}
} // namespace

std::vector<GrowthWork> GetGrowthBuilds()
{
  return GetWorksOfMethods("build", MeasureBuild);
}

std::vector<GrowthWork> GetGrowthScans()
{
  return GetWorksOfMethods("scan", MeasureScan);
}

std::vector<GrowthWork> GetGrowthMaps()
{
  std::vector<GrowthWork> works;
  for (double bound : { 0.0, MapBound })
  {
    works.push_back({ "map", bound == 0.0 ? "plain grid" : "map within 10 mm",
      [bound](const GrowthSetting& setting, const GrowthLimits& limits)
      { return MeasureMap(setting, bound, limits); } });
  }
  return works;
}
