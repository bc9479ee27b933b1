// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Times a scan after a change of pose, and the local map, beside the raw cost of its beams.
 *
 * Each number is the best of many runs. The bound is what Embree's single-precision packets take for
 * the same beams in the same run, with no output made.
 */
#include "RawEmbreeScan.h"

#include "vtkLMS3DScanFilter.h"
#include "vtkLMS3DSurfaceReconstructionFilter.h"
#include "vtkVRMLImporterSource.h"

#include <vtkNew.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <limits>
#include <string>

namespace
{
constexpr int Runs = 50;

double GetBestMilliseconds(const std::function<void()>& work)
{
  using Clock = std::chrono::steady_clock;
  double best = std::numeric_limits<double>::infinity();
  for (int run = 0; run < Runs; ++run)
  {
    const Clock::time_point start = Clock::now();
    work();
    best = std::min(best, std::chrono::duration<double, std::milli>(Clock::now() - start).count());
  }
  return best;
}

void PrintRow(const std::string& scene, const char* work, int threads, double ms, double bound)
{
  std::printf("%-8s  %-13s  %7d  %9.3f  %13.2f\n", scene.c_str(), work, threads, ms, ms / bound);
}

void TimeScene(const std::string& name, const double sensor[3])
{
  vtkNew<vtkVRMLImporterSource> reader;
  reader->SetFileName((LMS3D_DATA_DIR "/" + name + ".wrl").c_str());
  reader->Update();
  RawEmbreeScan raw(reader->GetOutput(), sensor);
  vtkNew<vtkLMS3DScanFilter> scan;
  scan->SetInputConnection(reader->GetOutputPort());
  scan->SetPosition(sensor);
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> map;
  map->SetInputConnection(scan->GetOutputPort());

  for (int threads : { 1, 2 })
  {
    const double bound = GetBestMilliseconds([&] { raw.Cast(threads); });
    PrintRow(name, "raw packets", threads, bound, bound);
    scan->SetNumberOfThreads(threads);
    for (int method : { vtkLMS3DScanFilter::FAST, vtkLMS3DScanFilter::EXACT })
    {
      scan->SetIntersectionMethod(method);
      scan->Update();
      const double ms = GetBestMilliseconds(
        [&]
        {
          scan->Modified();
          scan->Update();
        });
      PrintRow(name, (std::string("scan, ") + scan->GetIntersectionMethodAsString()).c_str(),
        threads, ms, bound);
    }
  }
  map->Update();
  const double bound = GetBestMilliseconds([&] { raw.Cast(2); });
  const double ms = GetBestMilliseconds(
    [&]
    {
      map->Modified();
      map->Update();
    });
  PrintRow(name, "map", 2, ms, bound);
}
} // namespace

int main()
{
  std::printf(
    "A scan of 361 x 360 beams after a change of pose, all outputs made; best of %d.\n\n", Runs);
  std::printf("%-8s  %-13s  %7s  %9s  %13s\n", "scene", "work", "threads", "ms", "raw packets x");
  const double inRoom[3] = { 0.3, -0.2, 1.0 };
  TimeScene("room", inRoom);
  const double byTeapot[3] = { 0.10, -0.33, 0.30 };
  TimeScene("teapot", byTeapot);
  return 0;
}
