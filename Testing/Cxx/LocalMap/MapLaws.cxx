// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/MapLaws.h"

#include "LocalMap/MapJudge.h"
#include "LocalMap/MapNeighbours.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <ostream>
#include <set>
#include <sstream>

void MapVerdict::Add(const std::string& law, const std::string& words, double amount)
{
  Breach& breach = this->Breaches[law];
  if (breach.Count++ == 0 || amount > breach.Amount)
  {
    breach.Amount = amount;
    breach.Words = words;
  }
}

void MapVerdict::Allow(const std::string& law, double count)
{
  const auto breach = this->Breaches.find(law);
  if (breach != this->Breaches.end() && static_cast<double>(breach->second.Count) <= count)
  {
    this->Breaches.erase(breach);
  }
}

std::size_t MapVerdict::GetNumberOfBreaches(const std::string& law) const
{
  const auto breach = this->Breaches.find(law);
  return breach == this->Breaches.end() ? 0 : breach->second.Count;
}

std::ostream& operator<<(std::ostream& os, const MapVerdict& verdict)
{
  for (const auto& [law, breach] : verdict.Breaches)
  {
    os << '\n' << law << ", " << breach.Count << " times: " << breach.Words;
  }
  return os << "\nlargest deviation " << verdict.LargestDeviation << " m, "
            << verdict.NumberOfBoundaryEdges << " boundary edges, Euler characteristic "
            << verdict.EulerCharacteristic << '\n';
}

std::string ToWords(const Vector& point)
{
  std::ostringstream words;
  words.precision(10);
  words << '(' << point[0] << ", " << point[1] << ", " << point[2] << ')';
  return words.str();
}

MapCase::MapCase(vtkPolyData* scan, vtkPolyData* map, const MapPromise& promise)
  : Promise(promise)
  , Grid(scan)
  , Steps(this->Grid, promise.DepthStep, promise.Noise)
  , Scan(scan)
  , Map(map)
  , Speckles(GetFieldNumbers(map, "SpeckleBeamIds"))
{
  for (vtkIdType i = 0; i < map->GetNumberOfPoints(); ++i)
  {
    Vector point;
    map->GetPoint(i, point.data());
    this->Points.push_back(point - this->Grid.GetSensor());
  }
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < map->GetNumberOfCells(); ++cell)
  {
    map->GetCellPoints(cell, corners);
    this->Triangles.push_back({ corners->GetId(0), corners->GetId(1), corners->GetId(2) });
  }
}

std::unique_ptr<const MapCase> MapCase::MakeIdeal() const
{
  return this->Promise.Ideal
    ? std::make_unique<const MapCase>(this->Promise.Ideal, this->Map, this->Promise)
    : nullptr;
}

std::set<int> GetFieldNumbers(vtkPolyData* map, const char* name)
{
  std::set<int> numbers;
  vtkDataArray* array = map->GetFieldData()->GetArray(name);
  for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
  {
    numbers.insert(static_cast<int>(array->GetTuple1(i)));
  }
  return numbers;
}

namespace
{
double GetFieldValue(vtkPolyData* map, const char* name, MapVerdict& verdict)
{
  vtkDataArray* array = map->GetFieldData()->GetArray(name);
  if (!array || array->GetNumberOfValues() != 1)
  {
    verdict.Add("field data", std::string("there is no ") + name + " of one value");
    return NAN;
  }
  return array->GetTuple1(0);
}

void JudgePatches(const MapCase& map, MapVerdict& verdict)
{
  vtkDataArray* patches = map.Map->GetCellData()->GetArray("PatchId");
  if (!patches || patches->GetDataType() != VTK_INT)
  {
    verdict.Add("field data", "there is no PatchId of int32");
    return;
  }
  // Triangles between patches have a PatchId below 0.
  std::set<double> ids;
  for (vtkIdType i = 0; i < patches->GetNumberOfTuples(); ++i)
  {
    if (patches->GetTuple1(i) >= 0.0)
    {
      ids.insert(patches->GetTuple1(i));
    }
  }
  const double number = GetFieldValue(map.Map, "NumberOfPatches", verdict);
  if (number != static_cast<double>(ids.size()) || (!ids.empty() && *ids.rbegin() != number - 1.0))
  {
    verdict.Add("field data",
      "NumberOfPatches is " + std::to_string(number) + ", but PatchId has " +
        std::to_string(ids.size()));
  }
}

void JudgeCounts(const MapCase& map, MapVerdict& verdict)
{
  const double all = GetFieldValue(map.Map, "NumberOfReturns", verdict);
  const std::string kind = "NumberOfReturnsOn";
  double sum = 0.0;
  for (int i = 0; i < map.Map->GetFieldData()->GetNumberOfArrays(); ++i)
  {
    const std::string name = map.Map->GetFieldData()->GetArrayName(i);
    sum +=
      name.substr(0, kind.size()) == kind ? GetFieldValue(map.Map, name.c_str(), verdict) : 0.0;
  }
  if (all != static_cast<double>(map.Grid.GetPoints().size()) || sum != all)
  {
    verdict.Add("field data",
      std::to_string(map.Grid.GetPoints().size()) + " returns, NumberOfReturns is " +
        std::to_string(all) + ", and its kinds are " + std::to_string(sum));
  }
}
} // namespace

void JudgeFieldData(const MapCase& map, MapVerdict& verdict)
{
  if (map.IsPlain())
  {
    return;
  }
  JudgePatches(map, verdict);
  JudgeCounts(map, verdict);
  // A beam may hit a triangle that is not the nearest to its return; its distance is accepted.
  const double deviation = GetFieldValue(map.Map, "LargestDeviation", verdict);
  double largest = 0.0;
  for (const Vector& point : map.Grid.GetPoints())
  {
    largest = std::max(largest, GetLength(point));
  }
  const double rounding = 1e-9 + 1e-6 * deviation + 1e-15 * largest;
  if (!(deviation >= verdict.LargestDeviation - rounding &&
        deviation <= verdict.LargestDeviationOnBeams + rounding))
  {
    std::ostringstream words;
    words << "LargestDeviation is " << deviation << " instead of " << verdict.LargestDeviation
          << " to " << verdict.LargestDeviationOnBeams;
    verdict.Add("field data", words.str());
  }
}

MapVerdict JudgeMap(vtkPolyData* scan, vtkPolyData* map, const MapPromise& promise)
{
  MapVerdict verdict;
  if (scan->GetNumberOfPoints() == 0)
  {
    if (map->GetNumberOfPoints() > 0 || map->GetNumberOfCells() > 0)
    {
      verdict.Add("beam", "a scan without returns has a map");
    }
    return verdict;
  }
  const MapCase subject(scan, map, promise);
  JudgeShape(subject, verdict);
  JudgeEdges(subject, verdict);
  const TriangleTree surface(subject.Points, subject.Triangles);
  const std::unique_ptr<const MapCase> ideal = subject.MakeIdeal();
  const MapNeighbours neighbours(subject, ideal.get());
  JudgeDistances(subject, surface, verdict);
  JudgeBeams(subject, neighbours, surface, verdict);
  JudgeGaps(subject, surface, verdict);
  JudgeDepthSteps(subject, neighbours, surface, verdict);
  JudgeFieldData(subject, verdict);
  return verdict;
}
