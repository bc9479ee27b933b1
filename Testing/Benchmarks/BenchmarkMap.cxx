// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks.h"

#include "MapCauses.h"
#include "MapContender.h"
#include "MapErrors.h"
#include "Scenes.h"
#include "Table.h"
#include "Timer.h"

#include "vtkLMS3DScanFilter.h"

#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <map>
#include <set>
#include <vector>

namespace
{
// Metres.
constexpr std::array<double, 6> Bounds = { 0.0, 0.001, 0.005, 0.01, 0.02, 0.05 };
constexpr double Noise = 0.005;
constexpr double NoBound = std::numeric_limits<double>::quiet_NaN();

// The bounds of the maps to which the best rival is compared. With noise of 5 mm the map within 5
// mm is the grid.
std::array<double, 3> GetBoundsOfQuadrics(double noise)
{
  return { noise > 0.0 ? 0.01 : 0.001, GetFairBound(noise), 0.05 };
}

/// Milliseconds that each work is repeated for.
double GetBudget(const BenchmarkOptions& options)
{
  return options.IsQuick ? 200.0 : 2000.0;
}

/// The maps of one scan, by their bounds.
using Maps = std::map<double, MapContender>;

struct Subject
{
  const BenchmarkScene& Scene;
  vtkSmartPointer<vtkPolyData> Scan;
  double ScanMilliseconds;
  /// The standard deviation of the ranges, metres.
  double Noise;
  /// Triangles of the scene that the scan has hit.
  std::size_t HitTriangles;
};

std::size_t CountHitTriangles(vtkPolyData* scan)
{
  auto* cells = vtkIdTypeArray::SafeDownCast(scan->GetPointData()->GetArray("CellId"));
  return std::set<vtkIdType>(cells->Begin(), cells->End()).size();
}

const Table::Row Columns = { "scene", "map", "noise mm", "bound mm", "ms", "x scan", "triangles",
  "to scene mean mm", "to scene 95% mm", "to scene max mm", "to map mean mm", "to map 95% mm",
  "both mean mm", "correct %", "complete %", "F %", "normals deg", "free space m2",
  "returns within 10 mm %", "farthest return mm", "scene triangles", "hit triangles" };

constexpr double Millimetres = 1000.0;
constexpr double Percent = 100.0;
constexpr int Percentile95 = 2;
constexpr int Maximum = 3;

// The bound of a rival is that of the map whose number of triangles it gets.
void AddRow(const Subject& subject, const MapContender& contender, double bound, Table& table)
{
  const MapErrors errors(subject.Scene, subject.Scan, contender.Map);
  table.AddRow({ subject.Scene.Name, contender.Name, Table::Format(Millimetres * subject.Noise, 0),
    Table::Format(Millimetres * bound, 0), Table::Format(contender.Milliseconds, 2),
    Table::Format(contender.Milliseconds / subject.ScanMilliseconds, 2),
    std::to_string(contender.Map->GetNumberOfCells()), errors.Format("MapToScene", Millimetres, 2),
    errors.Format("MapToScene", Millimetres, 1, Percentile95),
    errors.Format("MapToScene", Millimetres, 0, Maximum),
    errors.Format("SceneToMap", Millimetres, 2),
    errors.Format("SceneToMap", Millimetres, 1, Percentile95),
    Table::Format(Millimetres * errors.GetMeanOfBoth(), 2),
    errors.Format("Correctness", Percent, 2), errors.Format("Completeness", Percent, 2),
    errors.Format("FScore", Percent, 2), errors.Format("NormalError", 1.0, 1),
    errors.Format("AreaInFreeSpace", 1.0, 3), errors.Format("ReturnsWithinTolerance", Percent, 2),
    errors.Format("LargestReturnDistance", Millimetres, 2),
    std::to_string(subject.Scene.Surface->GetNumberOfPolys()),
    std::to_string(subject.HitTriangles) });
}

const Table::Row ColumnsOfCauses = { "scene", "noise mm", "bound mm", "triangles", "strips",
  "inside", "borders", "creases", "corners", "patches and holes", "small patches",
  "on small patches" };

void AddRowOfCauses(const Subject& subject, const MapContender& map, double bound, Table& causes)
{
  const MapCauses count = CountMapCauses(map.Map);
  causes.AddRow({ subject.Scene.Name, Table::Format(Millimetres * subject.Noise, 0),
    Table::Format(Millimetres * bound, 0), std::to_string(map.Map->GetNumberOfCells()),
    std::to_string(count.Strips), std::to_string(count.Inside), std::to_string(count.Borders),
    std::to_string(count.Creases), std::to_string(count.Corners), std::to_string(count.Patches),
    std::to_string(count.SmallPatches), std::to_string(count.OnSmallPatches) });
}

void CompareDecimations(
  const Subject& subject, const Maps& maps, const BenchmarkOptions& options, Table& table)
{
  const MapContender& grid = maps.at(0.0);
  const double fairBound = GetFairBound(subject.Noise);
  for (double bound : GetBoundsOfQuadrics(subject.Noise))
  {
    if (bound == fairBound || !options.IsQuick)
    {
      const vtkIdType triangles = maps.at(bound).Map->GetNumberOfCells();
      AddRow(subject, DecimateByQuadrics(grid, triangles, GetBudget(options)), bound, table);
    }
  }
  const vtkIdType triangles = maps.at(fairBound).Map->GetNumberOfCells();
  AddRow(subject, DecimatePro(grid, triangles, GetBudget(options)), fairBound, table);
}

/// What the benchmark prints.
struct Tables
{
  Table Maps{ Columns };
  Table Causes{ ColumnsOfCauses };
};

void CompareMaps(const Subject& subject, const BenchmarkOptions& options, Tables& tables)
{
  Table& table = tables.Maps;
  Maps maps;
  for (double bound : Bounds)
  {
    maps[bound] = MakeLocalMap(subject.Scan, bound, subject.Scene.DepthStep, GetBudget(options));
    AddRow(subject, maps[bound], bound, table);
    if (bound > 0.0)
    {
      AddRowOfCauses(subject, maps[bound], bound, tables.Causes);
    }
  }
  CompareDecimations(subject, maps, options, table);
  if (!options.IsQuick)
  {
    AddRow(subject, ReconstructFromPoints(subject.Scan, GetBudget(options)), NoBound, table);
  }
  table.Print();
}

void CompareOnScene(const std::string& name, const BenchmarkOptions& options, Tables& tables)
{
  const BenchmarkScene scene = MakeScene(name);
  vtkNew<vtkLMS3DScanFilter> scan;
  scan->SetInputData(scene.Surface);
  scan->SetPosition(scene.Sensor[0], scene.Sensor[1], scene.Sensor[2]);
  scan->SetNumberOfThreads(1);
  scan->Update();
  const double ms = GetBestMilliseconds(GetBudget(options),
    [&]
    {
      scan->Modified();
      scan->Update();
    });
  const std::size_t hit = CountHitTriangles(scan->GetOutput());
  CompareMaps({ scene, scan->GetOutput(), ms, 0.0, hit }, options, tables);
  CompareMaps({ scene, AddRangeNoise(scan->GetOutput(), Noise), ms, Noise, hit }, options, tables);
}
} // namespace

void RunMapBenchmark(const BenchmarkOptions& options)
{
  Tables tables;
  for (const std::string& name : options.Scenes)
  {
    CompareOnScene(name, options, tables);
  }
  tables.Causes.Print();
  if (!options.CSVFile.empty())
  {
    tables.Maps.Save(options.CSVFile);
  }
  if (std::count(options.Scenes.begin(), options.Scenes.end(), "room") > 0)
  {
    const std::filesystem::path file(options.CSVFile);
    CompareDamagedScans(
      file.empty() ? "" : file.parent_path() / (file.stem().string() + "-damage.csv"),
      GetBudget(options));
  }
}
