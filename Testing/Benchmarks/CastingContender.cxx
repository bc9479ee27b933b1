// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CastingContender.h"

#include "Scenes.h"
#include "StabilityMethod.h"
#include "StabilityRivals.h"

#include "vtkLMS3DScanFilter.h"

#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <map>
#include <memory>

namespace
{
// The whole update, with all arrays of both outputs.
CastingContender MakeMethod(const BenchmarkScene& scene, int method)
{
  const auto build = [&scene, method]() -> CastingScan
  {
    const auto filter = vtkSmartPointer<vtkLMS3DScanFilter>::New();
    filter->SetInputData(scene.Surface);
    filter->SetPosition(scene.Sensor[0], scene.Sensor[1], scene.Sensor[2]);
    filter->SetIntersectionMethod(method);
    filter->SetMaximumRange(CastingMaximumRange);
    filter->SetNumberOfThreads(1);
    filter->SetAlphaResolution(1);
    filter->SetBetaResolution(1);
    filter->Update();
    const auto cast = [filter](const ThinnedGrid& grid)
    {
      grid.Apply(filter);
      filter->Modified();
      filter->Update();
    };
    const auto getRanges = [filter](const ThinnedGrid& grid)
    {
      vtkDataArray* ranges = filter->GetRangeImage()->GetPointData()->GetScalars();
      return grid.SpreadGrid(vtkDoubleArray::SafeDownCast(ranges)->GetPointer(0));
    };
    return { cast, getRanges };
  };
  return { vtkLMS3DScanFilter::GetIntersectionMethodName(method), build };
}

// Ready-made directions in, ranges out. Each grid has shots of its own, by stride.
CastingContender MakeRival(const BenchmarkScene& scene, const StabilityMethod& method)
{
  const auto build = [&scene, method]() -> CastingScan
  {
    const StabilityCaster caster = method.Build(MakeMesh(scene.Surface));
    const auto shots = std::make_shared<std::map<int, std::vector<StabilityShot>>>();
    for (int stride : ThinnedGrid::Strides)
    {
      (*shots)[stride] = ThinnedGrid(stride).MakeShots(scene);
    }
    const auto ranges = std::make_shared<std::vector<double>>();
    return { [caster, shots, ranges](const ThinnedGrid& grid)
      { *ranges = caster(shots->at(grid.GetStride())); },
      [ranges](const ThinnedGrid& grid) { return grid.SpreadShots(*ranges); } };
  };
  return { method.Name, build };
}
} // namespace

std::vector<CastingContender> MakeCastingContenders(const BenchmarkScene& scene)
{
  const int methods = vtkLMS3DScanFilter::GetNumberOfIntersectionMethods();
  std::vector<CastingContender> contenders;
  contenders.reserve(methods);
  for (int method = 0; method < methods; ++method)
  {
    contenders.push_back(MakeMethod(scene, method));
  }
  for (const auto& rivals : { GetEmbreeMethods(), GetLocatorMethods() })
  {
    for (const StabilityMethod& rival : rivals)
    {
      contenders.push_back(MakeRival(scene, rival));
    }
  }
  return contenders;
}
