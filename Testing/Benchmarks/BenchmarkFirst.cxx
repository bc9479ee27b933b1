// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks.h"

#include "RawEmbreeBuild.h"
#include "ScanSubject.h"
#include "Scenes.h"
#include "Table.h"

#include "vtkLMS3DScanFilter.h"

#include <algorithm>
#include <functional>
#include <limits>

namespace
{
struct Contender
{
  std::string Name;
  std::function<double(int)> GetMilliseconds;
  double Best = std::numeric_limits<double>::infinity();
};

std::vector<Contender> MakeContenders(const BenchmarkScene& scene, const RawEmbreeBuild& raw)
{
  const auto first = [&scene](int method)
  {
    return [&scene, method](int threads)
    { return ScanSubject::GetFirstMilliseconds(scene, method, threads); };
  };
  return {
    { "boxes at low quality", [&](int n) { return raw.GetMilliseconds(RawEmbreeBuild::LOW, n); } },
    { "boxes at medium quality",
      [&](int n) { return raw.GetMilliseconds(RawEmbreeBuild::MEDIUM, n); } },
    { "first update with Fast", first(vtkLMS3DScanFilter::FAST) },
    { "first update with Exact", first(vtkLMS3DScanFilter::EXACT) },
  };
}

void TimeScene(const std::string& name, const BenchmarkOptions& options, Table& table)
{
  const BenchmarkScene scene = MakeScene(name);
  const RawEmbreeBuild raw(scene.Surface);
  const int runs = options.IsQuick || scene.Surface->GetNumberOfPolys() > 1000000 ? 3 : 15;
  for (int threads : { 1, 2 })
  {
    std::vector<Contender> contenders = MakeContenders(scene, raw);
    for (int run = 0; run < runs; ++run)
    {
      for (Contender& contender : contenders)
      {
        contender.Best = std::min(contender.Best, contender.GetMilliseconds(threads));
      }
    }
    for (const Contender& contender : contenders)
    {
      table.AddRow({ name, contender.Name, std::to_string(threads),
        Table::Format(contender.Best, 2), Table::Format(contender.Best / contenders[0].Best, 2),
        Table::Format(contender.Best / contenders[1].Best, 2) });
    }
  }
  table.Print();
}
} // namespace

void RunFirstBenchmark(const BenchmarkOptions& options)
{
  Table table({ "scene", "work", "threads", "ms", "x boxes low", "x boxes medium" });
  for (const std::string& name : options.Scenes)
  {
    TimeScene(name, options, table);
  }
  if (!options.CSVFile.empty())
  {
    table.Save(options.CSVFile);
  }
}
