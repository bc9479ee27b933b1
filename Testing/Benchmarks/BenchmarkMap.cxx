// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks.h"

#include "MapContender.h"
#include "Scenes.h"
#include "Table.h"
#include "Timer.h"

#include "vtkLMS3DMapComparison.h"
#include "vtkLMS3DScanFilter.h"

#include <vtkFieldData.h>
#include <vtkNew.h>

#include <array>
#include <vector>

namespace
{
// Metres.
constexpr std::array<double, 6> Bounds = { 0.0, 0.001, 0.005, 0.01, 0.02, 0.05 };
constexpr double Noise = 0.005;

// The bound whose number of triangles the rivals get. With noise it is four standard deviations:
// below, a surface that meets every bound has to follow the noise.
double GetBoundOfRivals(double noise)
{
  return noise > 0.0 ? 0.02 : 0.01;
}

struct Subject
{
  const BenchmarkScene& Scene;
  vtkSmartPointer<vtkPolyData> Scan;
  double ScanMilliseconds;
  /// The standard deviation of the ranges, metres.
  double Noise;
};

/// What vtkLMS3DMapComparison finds, by the names of its results.
class Errors
{
public:
  Errors(const Subject& subject, vtkPolyData* map)
  {
    this->Comparison->SetInputData(map);
    this->Comparison->SetSceneData(subject.Scene.Surface);
    this->Comparison->SetScanData(subject.Scan);
    this->Comparison->Update();
  }

  std::string Format(const char* name, double factor, int decimals, int component = 0) const
  {
    return Table::Format(factor * this->Get(name, component), decimals);
  }

  /// Half of the Chamfer distance: a map that leaves out what is hard gains in one direction, and
  /// loses in the other.
  double GetMeanOfBoth() const
  {
    return 0.5 * (this->Get("MapToScene", 0) + this->Get("SceneToMap", 0));
  }

private:
  double Get(const char* name, int component) const
  {
    vtkDataArray* result = this->Comparison->GetOutput()->GetFieldData()->GetArray(name);
    return result->GetComponent(0, component);
  }

  vtkNew<vtkLMS3DMapComparison> Comparison;
};

const Table::Row Columns = { "scene", "map", "noise mm", "bound mm", "ms", "x scan", "triangles",
  "to scene mean mm", "95 %", "max", "to map mean mm", "95 %", "both mean mm", "correct %",
  "complete %", "F %", "normals deg", "free space m2", "returns within 10 mm %",
  "farthest return mm" };

constexpr double Millimetres = 1000.0;
constexpr double Percent = 100.0;
constexpr int Percentile95 = 2;
constexpr int Maximum = 3;

void AddRow(
  const Subject& subject, const MapContender& contender, const std::string& bound, Table& table)
{
  const Errors errors(subject, contender.Map);
  table.AddRow({ subject.Scene.Name, contender.Name, Table::Format(Millimetres * subject.Noise, 0),
    bound, Table::Format(contender.Milliseconds, 2),
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
    errors.Format("LargestReturnDistance", Millimetres, 2) });
}

void CompareMaps(const Subject& subject, const BenchmarkOptions& options, Table& table)
{
  const double budget = options.IsQuick ? 200.0 : 1000.0;
  MapContender grid;
  vtkIdType triangles = 0;
  for (double bound : Bounds)
  {
    const MapContender map = MakeLocalMap(subject.Scan, bound, subject.Scene.DepthStep, budget);
    AddRow(subject, map, Table::Format(Millimetres * bound, 0), table);
    grid = bound == 0.0 ? map : grid;
    triangles = bound == GetBoundOfRivals(subject.Noise) ? map.Map->GetNumberOfCells() : triangles;
  }
  if (!options.IsQuick || subject.Noise == 0.0)
  {
    AddRow(subject, DecimateByQuadrics(grid, triangles), "-", table);
    AddRow(subject, DecimatePro(grid, triangles), "-", table);
  }
  if (!options.IsQuick)
  {
    AddRow(subject, ReconstructFromPoints(subject.Scan), "-", table);
  }
  table.Print();
}

void CompareOnScene(const std::string& name, const BenchmarkOptions& options, Table& table)
{
  const BenchmarkScene scene = MakeScene(name);
  vtkNew<vtkLMS3DScanFilter> scan;
  scan->SetInputData(scene.Surface);
  scan->SetPosition(scene.Sensor[0], scene.Sensor[1], scene.Sensor[2]);
  scan->SetNumberOfThreads(1);
  scan->Update();
  const double ms = GetBestMilliseconds(options.IsQuick ? 200.0 : 1000.0,
    [&]
    {
      scan->Modified();
      scan->Update();
    });
  CompareMaps({ scene, scan->GetOutput(), ms, 0.0 }, options, table);
  CompareMaps({ scene, AddRangeNoise(scan->GetOutput(), Noise), ms, Noise }, options, table);
}
} // namespace

void RunMapBenchmark(const BenchmarkOptions& options)
{
  Table table(Columns);
  for (const std::string& name : options.Scenes)
  {
    CompareOnScene(name, options, table);
  }
  if (!options.CSVFile.empty())
  {
    table.Save(options.CSVFile);
  }
}
