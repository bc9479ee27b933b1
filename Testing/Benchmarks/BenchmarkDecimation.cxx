// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks.h"

#include "EqualDecimation.h"
#include "MapContender.h"
#include "MapErrors.h"
#include "Scenes.h"
#include "Table.h"

#include "vtkLMS3DScanFilter.h"

#include <vtkNew.h>

#include <optional>
#include <string>

namespace
{
// Metres.
constexpr double Noise = 0.005;
constexpr double Millimetres = 1000.0;
// Each map is made once.
constexpr double NoBudget = 0.0;

const Table::Row Columns = { "scene", "noise mm", "bound mm", "triangles",
  "decimated within the bound", "mean mm", "mean mm, decimated to as many", "farthest return mm",
  "farthest return mm, decimated to as many" };

// What decimation needs for the same largest error takes many decimations.
std::string FindEqualTriangles(
  const BenchmarkScene& scene, vtkPolyData* scan, const MapContender& grid, double bound)
{
  const std::optional<vtkIdType> equal = EqualDecimation(scene, scan, grid).FindTriangles(bound);
  return equal ? std::to_string(*equal) : "all";
}

void AddRow(
  const BenchmarkScene& scene, vtkPolyData* scan, double noise, bool isQuick, Table& table)
{
  const double bound = GetFairBound(noise);
  const MapContender grid = MakeLocalMap(scan, 0.0, scene.DepthStep, NoBudget);
  const MapContender map = MakeLocalMap(scan, bound, scene.DepthStep, NoBudget);
  const vtkIdType triangles = map.Map->GetNumberOfCells();
  const MapErrors errors(scene, scan, map.Map);
  const MapErrors decimated(scene, scan, DecimateByQuadrics(grid, triangles, NoBudget).Map);
  table.AddRow(
    { scene.Name, Table::Format(Millimetres * noise, 0), Table::Format(Millimetres * bound, 0),
      std::to_string(triangles), isQuick ? "-" : FindEqualTriangles(scene, scan, grid, bound),
      Table::Format(Millimetres * errors.GetMeanOfBoth(), 2),
      Table::Format(Millimetres * decimated.GetMeanOfBoth(), 2),
      errors.Format("LargestReturnDistance", Millimetres, 1),
      decimated.Format("LargestReturnDistance", Millimetres, 1) });
}
} // namespace

void RunDecimationBenchmark(const BenchmarkOptions& options)
{
  Table table{ Columns };
  for (const std::string& name : options.Scenes)
  {
    const BenchmarkScene scene = MakeScene(name);
    vtkNew<vtkLMS3DScanFilter> scan;
    scan->SetInputData(scene.Surface);
    scan->SetPosition(scene.Sensor[0], scene.Sensor[1], scene.Sensor[2]);
    scan->Update();
    AddRow(scene, scan->GetOutput(), 0.0, options.IsQuick, table);
    AddRow(scene, AddRangeNoise(scan->GetOutput(), Noise), Noise, options.IsQuick, table);
    table.Print();
  }
  if (!options.CSVFile.empty())
  {
    table.Save(options.CSVFile);
  }
}
