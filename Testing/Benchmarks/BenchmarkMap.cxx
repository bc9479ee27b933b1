// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks.h"

#include "Scenes.h"
#include "Table.h"
#include "Timer.h"

#include "vtkLMS3DScanFilter.h"
#include "vtkLMS3DSurfaceReconstructionFilter.h"

#include <vtkNew.h>

namespace
{
void TimeScene(const std::string& name, double budget, Table& table)
{
  const BenchmarkScene scene = MakeScene(name);
  vtkNew<vtkLMS3DScanFilter> scan;
  scan->SetInputData(scene.Surface);
  scan->SetPosition(scene.Sensor[0], scene.Sensor[1], scene.Sensor[2]);
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> map;
  map->SetInputConnection(scan->GetOutputPort());
  map->Update();
  const double scanTime = GetBestMilliseconds(budget,
    [&]
    {
      scan->Modified();
      scan->Update();
    });
  map->Update();
  const double mapTime = GetBestMilliseconds(budget,
    [&]
    {
      map->Modified();
      map->Update();
    });
  table.AddRow({ name, "scan", Table::Format(scanTime, 3), Table::Format(1.0, 2),
    std::to_string(scan->GetOutput()->GetNumberOfPoints()) });
  table.AddRow({ name, "map", Table::Format(mapTime, 3), Table::Format(mapTime / scanTime, 2),
    std::to_string(map->GetOutput()->GetNumberOfCells()) });
}
} // namespace

void RunMapBenchmark(const BenchmarkOptions& options)
{
  Table table({ "scene", "work", "ms", "x scan", "points or triangles" });
  for (const std::string& name : options.Scenes)
  {
    TimeScene(name, options.IsQuick ? 200.0 : 2000.0, table);
  }
  table.Print();
  if (!options.CSVFile.empty())
  {
    table.Save(options.CSVFile);
  }
}
