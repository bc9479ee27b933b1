// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ScanSubject.h"

#include "Memory.h"
#include "Scenes.h"
#include "Timer.h"

#include "vtkLMS3DScanFilter.h"

#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <algorithm>

namespace
{
constexpr double Nudge = 1e-6;

void Connect(const BenchmarkScene& scene, int method, vtkLMS3DScanFilter* filter)
{
  filter->SetInputData(scene.Surface);
  filter->SetPosition(scene.Sensor[0], scene.Sensor[1], scene.Sensor[2]);
  filter->SetIntersectionMethod(method);
}
} // namespace

ScanSubject::ScanSubject(const BenchmarkScene& scene, int method)
{
  Connect(scene, method, this->Filter);
  const MemoryMeter meter;
  const int alphas = this->Filter->GetAlphaResolution();
  const int betas = this->Filter->GetBetaResolution();
  this->Filter->SetAlphaResolution(1);
  this->Filter->SetBetaResolution(1);
  this->Filter->Update();
  this->SceneBytes = meter.GetGrowth();

  this->Filter->SetAlphaResolution(alphas);
  this->Filter->SetBetaResolution(betas);
  this->Filter->Update();
  this->OutputBytes = meter.GetGrowth() - this->SceneBytes;
  this->PeakBytes = meter.GetPeak();
  this->Hits = static_cast<int>(this->Filter->GetOutput()->GetNumberOfPoints());
}

ScanSubject::~ScanSubject() = default;

double ScanSubject::GetScanMilliseconds(double budget, int threads)
{
  double place[3];
  this->Filter->GetPosition(place);
  const double x = place[0];
  this->Filter->SetNumberOfThreads(threads);
  const double best = GetBestMilliseconds(budget,
    [&]
    {
      place[0] = place[0] == x ? x + Nudge : x;
      this->Filter->SetPosition(place);
      this->Filter->Update();
    });
  place[0] = x;
  this->Filter->SetPosition(place);
  return best;
}

double ScanSubject::GetBuildMilliseconds(const BenchmarkScene& scene, int method, int threads)
{
  vtkNew<vtkLMS3DScanFilter> filter;
  Connect(scene, method, filter);
  filter->SetNumberOfThreads(threads);
  filter->SetAlphaResolution(1);
  filter->SetBetaResolution(1);
  return GetMilliseconds([&] { filter->Update(); });
}

double ScanSubject::GetFirstMilliseconds(const BenchmarkScene& scene, int method, int threads)
{
  vtkNew<vtkLMS3DScanFilter> filter;
  Connect(scene, method, filter);
  filter->SetNumberOfThreads(threads);
  return GetMilliseconds([&] { filter->Update(); });
}

ScanErrors ScanSubject::GetErrors(const ScanTruth& truth)
{
  this->Filter->Update();
  vtkDataArray* ranges = this->Filter->GetRangeImage()->GetPointData()->GetScalars();
  return truth.GetErrors(vtkDoubleArray::SafeDownCast(ranges)->GetPointer(0));
}

bool ScanSubject::IsBruteForce(int method)
{
  return method == vtkLMS3DScanFilter::ANGLE_SUM || method == vtkLMS3DScanFilter::MOLLER_TRUMBORE;
}

std::string ScanSubject::GetName(int method)
{
  return vtkLMS3DScanFilter::GetIntersectionMethodName(method);
}

std::vector<std::string> ScanSubject::GetNames()
{
  std::vector<std::string> names(vtkLMS3DScanFilter::GetNumberOfIntersectionMethods());
  for (std::size_t method = 0; method < names.size(); ++method)
  {
    names[method] = GetName(static_cast<int>(method));
  }
  return names;
}
