// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ScanTables.h"

#include "Cores.h"
#include "Kernels/lms3dPacketKernels.h"
#include "Scenes.h"

#include <cstdint>
#include <cstdio>
#include <limits>
#include <optional>

namespace
{
constexpr double Beams = 361.0 * 360.0;
constexpr double None = std::numeric_limits<double>::quiet_NaN();
constexpr double Megabyte = 1024.0 * 1024.0;

// With fewer triangles, other memory outweighs the scene.
constexpr vtkIdType MinimumTrianglesForMemory = 10000;

constexpr std::size_t NumberOfColumns = 18;

std::string FormatBytesPerTriangle(const ScanContender& contender, vtkIdType triangles)
{
  return triangles < MinimumTrianglesForMemory ? "-"
                                               : Table::Format(contender.SceneBytes / triangles, 0);
}

/// What a row is compared with, and under which conditions it was measured.
struct Conditions
{
  /// The time of raw packets, milliseconds.
  double Bound;
  /// From 0 to 1.
  double ShareOfOthers;
};

void AddRow(const BenchmarkScene& scene, const ScanContender& contender, int threads,
  const Conditions& conditions, Table& table)
{
  const vtkIdType triangles = scene.Surface->GetNumberOfPolys();
  const auto found = contender.ByThreads.find(threads);
  if (found == contender.ByThreads.end())
  {
    Table::Row row = { scene.Name, contender.Name, std::to_string(triangles),
      std::to_string(threads) };
    row.resize(NumberOfColumns, "-");
    table.AddRow(row);
    return;
  }
  const ScanTimes& times = found->second;
  const std::optional<ScanErrors>& errors = contender.Errors;
  table.AddRow({ scene.Name, contender.Name, std::to_string(triangles), std::to_string(threads),
    Table::Format(times.Build, 1), Table::Format(times.Scan, 3),
    Table::Format(Beams / times.Scan / 1000.0, 1), Table::Format(times.Scan / conditions.Bound, 2),
    FormatBytesPerTriangle(contender, triangles), Table::Format(contender.OutputBytes / Beams, 0),
    Table::Format(contender.PeakBytes / Megabyte, 0), std::to_string(contender.Hits),
    errors ? std::to_string(errors->Misses) : "-", errors ? std::to_string(errors->FalseHits) : "-",
    Table::FormatPower(errors ? errors->Median : None),
    Table::FormatPower(errors ? errors->Worst : None), lms3dGetPacketKernels().Name,
    Table::Format(100.0 * conditions.ShareOfOthers, 0) });
}

std::string FormatCount(std::int64_t count)
{
  std::string digits = std::to_string(count);
  for (int i = static_cast<int>(digits.size()) - 3; i > 0; i -= 3)
  {
    digits.insert(i, ",");
  }
  return digits;
}

// Both numbers of threads in one row, and what was wrong in another.
void AddSummary(const BenchmarkScene& scene, std::vector<ScanContender>& contenders, Table& summary)
{
  for (ScanContender& contender : contenders)
  {
    if (!contender.IsPresent())
    {
      continue;
    }
    Table::Row row = { scene.Name + ", " + FormatCount(scene.Surface->GetNumberOfPolys()),
      contender.Name };
    for (int threads : { 1, 2 })
    {
      const double scan = contender.ByThreads[threads].Scan;
      row.push_back(Table::Format(scan, 2));
      row.push_back(Table::Format(scan / contenders.front().ByThreads[threads].Scan, 2));
    }
    const std::optional<ScanErrors>& errors = contender.Errors;
    row.push_back(errors ? std::to_string(errors->Misses + errors->FalseHits) : "-");
    row.push_back(Table::FormatPower(errors ? errors->Worst : None));
    summary.AddRow(row);
  }
}

void PrintNotes(std::vector<ScanContender>& contenders, double shareOfOthers)
{
  std::string speedUps;
  for (ScanContender& contender : contenders)
  {
    if (contender.IsPresent())
    {
      speedUps += ' ' + contender.Name + ' ' + Table::Format(contender.GetSpeedUp(), 2) + ';';
    }
  }
  std::printf("2 threads against 1:%s\n\n", speedUps.c_str());
  const std::string others = DescribeOthers(shareOfOthers);
  if (!others.empty())
  {
    std::printf("%s\n\n", others.c_str());
  }
  std::fflush(stdout);
}
} // namespace

ScanTables::ScanTables()
  : Rows({ "scene", "method", "triangles", "threads", "build ms", "scan ms", "Mbeams/s", "x raw",
      "B/triangle", "B/beam", "peak MB", "hits", "misses", "false hits", "median error",
      "worst error", "kernels", "others %" })
  , Summary({ "scene, triangles", "method", "1 thread, ms", "x raw", "2 threads, ms", "x raw",
      "wrong beams", "worst error" })
{
}

void ScanTables::AddScene(
  const BenchmarkScene& scene, std::vector<ScanContender>& contenders, double shareOfOthers)
{
  for (int threads : { 1, 2 })
  {
    const double bound = contenders.front().ByThreads[threads].Scan;
    for (const ScanContender& contender : contenders)
    {
      AddRow(scene, contender, threads, { bound, shareOfOthers }, this->Rows);
    }
  }
  this->Rows.Print();
  PrintNotes(contenders, shareOfOthers);
  AddSummary(scene, contenders, this->Summary);
}

void ScanTables::PrintSummary()
{
  std::printf("In short:\n\n");
  this->Summary.Print();
}

void ScanTables::Save(const std::string& fileName) const
{
  this->Rows.Save(fileName);
}
