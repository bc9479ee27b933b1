// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks.h"

#include "Fixtures/ScanDamage.h"
#include "MapContender.h"
#include "Scenes.h"
#include "Table.h"

#include "vtkLMS3DMapComparison.h"
#include "vtkLMS3DScanFilter.h"

#include <vtkFieldData.h>
#include <vtkNew.h>

#include <cstddef>
#include <string>
#include <vector>

namespace
{
using Shapes = ScanDamage::Shapes;

struct DamageCase
{
  const char* Name;
  /// Metres.
  double Bound;
  ScanDamage Errors;
};

// Shares of all beams, and metres. With noise, the bound is four standard deviations.
const std::vector<DamageCase> Cases = {
  { "none", 0.01, {} },
  { "noise of 5 mm", 0.02, { 0.0, Shapes::SingleBeams, 0.0, 0.005, 0.0 } },
  { "noise of 20 mm", 0.08, { 0.0, Shapes::SingleBeams, 0.0, 0.02, 0.0 } },
  { "steps of 1 mm", 0.01, { 0.0, Shapes::SingleBeams, 0.0, 0.0, 0.001 } },
  { "steps of 1 cm", 0.02, { 0.0, Shapes::SingleBeams, 0.0, 0.0, 0.01 } },
  { "1 % lost", 0.01, { 0.01 } },
  { "5 % lost", 0.01, { 0.05 } },
  { "20 % lost", 0.01, { 0.2 } },
  { "5 % lost in stripes", 0.01, { 0.05, Shapes::Stripes } },
  { "5 % lost in blobs", 0.01, { 0.05, Shapes::Blobs } },
  { "0.1 % strays", 0.01, { 0.0, Shapes::SingleBeams, 0.001 } },
  { "1 % strays", 0.01, { 0.0, Shapes::SingleBeams, 0.01 } },
  { "all", 0.04, { 0.05, Shapes::SingleBeams, 0.001, 0.005, 0.01 } },
};

// Returns; the largest group that is a speckle.
constexpr int SpeckleSize = 4;
constexpr MapGaps Open = { 0, 0 };
constexpr MapGaps Closed = { -1, SpeckleSize };

const Table::Row Columns = { "errors", "bound mm", "returns", "open ms", "open triangles", "ms",
  "triangles", "x ideal", "to scene mean mm", "to map mean mm", "free space m2" };

constexpr double Millimetres = 1000.0;

/// What a scan without errors becomes with them.
struct DamagedMaps
{
  vtkSmartPointer<vtkPolyData> Scan;
  MapContender WithGaps;
  MapContender WithoutGaps;
};

DamagedMaps MakeMaps(vtkPolyData* ideal, const DamageCase& damage, double depthStep, double budget)
{
  const vtkSmartPointer<vtkPolyData> scan = Damage(ideal, damage.Errors);
  return { scan, MakeLocalMap(scan, damage.Bound, depthStep, budget, Open),
    MakeLocalMap(scan, damage.Bound, depthStep, budget, Closed) };
}

vtkSmartPointer<vtkPolyData> ScanWithStatus(const BenchmarkScene& scene)
{
  vtkNew<vtkLMS3DScanFilter> scan;
  scan->SetInputData(scene.Surface);
  scan->SetPosition(scene.Sensor[0], scene.Sensor[1], scene.Sensor[2]);
  scan->ComputeStatusOn();
  scan->Update();
  return scan->GetOutput();
}

// Compares with the scan without errors, which shows what is visible.
void AddRow(const BenchmarkScene& scene, vtkPolyData* ideal, const DamageCase& damage,
  const DamagedMaps& maps, vtkIdType trianglesOfIdeal, Table& table)
{
  vtkNew<vtkLMS3DMapComparison> comparison;
  comparison->SetInputData(maps.WithoutGaps.Map);
  comparison->SetSceneData(scene.Surface);
  comparison->SetScanData(ideal);
  comparison->Update();
  const auto format = [&](const char* name, double factor, int decimals)
  {
    vtkFieldData* results = comparison->GetOutput()->GetFieldData();
    return Table::Format(factor * results->GetArray(name)->GetComponent(0, 0), decimals);
  };
  const vtkIdType triangles = maps.WithoutGaps.Map->GetNumberOfCells();
  table.AddRow({ damage.Name, Table::Format(Millimetres * damage.Bound, 0),
    std::to_string(maps.Scan->GetNumberOfPoints()), Table::Format(maps.WithGaps.Milliseconds, 2),
    std::to_string(maps.WithGaps.Map->GetNumberOfCells()),
    Table::Format(maps.WithoutGaps.Milliseconds, 2), std::to_string(triangles),
    Table::Format(static_cast<double>(triangles) / static_cast<double>(trianglesOfIdeal), 2),
    format("MapToScene", Millimetres, 2), format("SceneToMap", Millimetres, 2),
    format("AreaInFreeSpace", 1.0, 3) });
}
} // namespace

void CompareDamagedScans(const std::string& csvFile, double budget)
{
  const BenchmarkScene scene = MakeScene("room");
  const vtkSmartPointer<vtkPolyData> ideal = ScanWithStatus(scene);
  Table table(Columns);
  vtkIdType trianglesOfIdeal = 0;
  for (const DamageCase& damage : Cases)
  {
    const DamagedMaps maps = MakeMaps(ideal, damage, scene.DepthStep, budget);
    if (trianglesOfIdeal == 0)
    {
      trianglesOfIdeal = maps.WithoutGaps.Map->GetNumberOfCells();
    }
    AddRow(scene, ideal, damage, maps, trianglesOfIdeal, table);
  }
  table.Print();
  if (!csvFile.empty())
  {
    table.Save(csvFile);
  }
}
