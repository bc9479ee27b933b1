// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ScanContender.h"

#include "Memory.h"
#include "Scenes.h"
#include "Timer.h"

namespace
{
// Milliseconds.
constexpr double LongScan = 100.0;

constexpr int AllThreads = 2;
} // namespace

ScanContender ScanContender::MakeRaw(const BenchmarkScene& scene)
{
  ScanContender raw;
  raw.Name = "raw packets";
  const MemoryMeter meter;
  raw.Raw = std::make_unique<RawEmbreeScan>(
    scene.Surface, scene.Sensor.data(), ScanMaximumRange, AllThreads);
  raw.SceneBytes = meter.GetGrowth();
  raw.PeakBytes = meter.GetPeak();
  raw.Hits = raw.Raw->CountHits();
  return raw;
}

ScanContender ScanContender::MakeMethod(
  const BenchmarkScene& scene, int method, const ScanTruth& truth)
{
  ScanContender contender;
  contender.Name = ScanSubject::GetName(method);
  contender.Method = method;
  contender.Subject = std::make_unique<ScanSubject>(scene, method);
  contender.IsSlow = contender.Subject->GetScanMilliseconds(0.0, AllThreads) > LongScan;
  contender.Hits = contender.Subject->GetHits();
  contender.SceneBytes = contender.Subject->GetSceneBytes();
  contender.OutputBytes = contender.Subject->GetOutputBytes();
  contender.PeakBytes = contender.Subject->GetPeakBytes();
  contender.Errors = contender.Subject->GetErrors(truth);
  return contender;
}

double ScanContender::GetScanMilliseconds(double budget, int threads)
{
  return this->Raw ? GetBestMilliseconds(budget, [&] { this->Raw->Cast(threads); })
                   : this->Subject->GetScanMilliseconds(budget, threads);
}

double ScanContender::GetBuildMilliseconds(const BenchmarkScene& scene, int threads) const
{
  if (!this->Raw)
  {
    return ScanSubject::GetBuildMilliseconds(scene, this->Method, threads);
  }
  return GetMilliseconds([&]
    { const RawEmbreeScan raw(scene.Surface, scene.Sensor.data(), ScanMaximumRange, threads); });
}
