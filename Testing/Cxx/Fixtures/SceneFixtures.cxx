// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fixtures/SceneFixtures.h"

#include "vtkLMS3DScanFilter.h"
#include "vtkVRMLImporterSource.h"

#include <vtkAlgorithm.h>
#include <vtkAppendPolyData.h>
#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDataSet.h>
#include <vtkExecutive.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSphereSource.h>
#include <vtkTriangle.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <ostream>

namespace
{
vtkSmartPointer<vtkPolyData> ReadScene(const char* file)
{
  vtkNew<vtkVRMLImporterSource> reader;
  reader->SetFileName(file);
  reader->Update();
  return reader->GetOutput();
}
} // namespace

vtkSmartPointer<vtkPolyData> MakeBall(double radius, int resolution)
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(radius);
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  return source->GetOutput();
}

double GetInradius(vtkPolyData* surface)
{
  double inradius = std::numeric_limits<double>::infinity();
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    surface->GetCellPoints(cell, corners);
    double a[3], b[3], c[3], normal[3];
    surface->GetPoint(corners->GetId(0), a);
    surface->GetPoint(corners->GetId(1), b);
    surface->GetPoint(corners->GetId(2), c);
    vtkTriangle::ComputeNormal(a, b, c, normal);
    inradius = std::min(inradius, std::abs(vtkMath::Dot(normal, a)));
  }
  return inradius;
}

vtkSmartPointer<vtkPolyData> MakePolygon(const std::vector<Point>& points)
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> coordinates;
  coordinates->SetDataTypeToDouble();
  for (const Point& point : points)
  {
    coordinates->InsertNextPoint(point.data());
  }
  std::vector<vtkIdType> ids(points.size());
  std::iota(ids.begin(), ids.end(), 0);
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  surface->SetPoints(coordinates);
  surface->SetPolys(polygons);
  return surface;
}

vtkSmartPointer<vtkPolyData> MakeFloor(double halfSize, double z)
{
  return MakePolygon({ { -halfSize, -halfSize, z }, { halfSize, -halfSize, z },
    { halfSize, halfSize, z }, { -halfSize, halfSize, z } });
}

vtkSmartPointer<vtkPolyData> Join(vtkPolyData* a, vtkPolyData* b)
{
  vtkNew<vtkAppendPolyData> append;
  append->AddInputData(a);
  append->AddInputData(b);
  append->Update();
  return append->GetOutput();
}

void ScaleAndMove(vtkPolyData* surface, double scale, const Point& offset)
{
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    Point p;
    surface->GetPoint(i, p.data());
    for (int axis = 0; axis < 3; ++axis)
    {
      p[axis] = scale * p[axis] + offset[axis];
    }
    surface->GetPoints()->SetPoint(i, p.data());
  }
  surface->GetPoints()->Modified();
}

vtkSmartPointer<vtkPolyData> ReadRoom()
{
  return ReadScene(LMS3D_DATA_DIR "/room.wrl");
}

vtkSmartPointer<vtkPolyData> ReadBuilding()
{
  return ReadScene(LMS3D_DATA_DIR "/building.wrl");
}

vtkSmartPointer<vtkPolyData> ReadTeapot()
{
  return ReadScene(LMS3D_DATA_DIR "/teapot.wrl");
}

namespace
{
// FNV-1a.
std::uint64_t Mix(std::uint64_t hash, const void* data, std::size_t size)
{
  const auto* byte = static_cast<const unsigned char*>(data);
  for (std::size_t i = 0; i < size; ++i)
  {
    hash = (hash ^ byte[i]) * 1099511628211u;
  }
  return hash;
}

constexpr std::uint64_t Start = 14695981039346656037u;
} // namespace

std::uint64_t Hash(vtkDataArray* array)
{
  return Mix(Start, array->GetVoidPointer(0),
    static_cast<std::size_t>(array->GetNumberOfValues()) * array->GetDataTypeSize());
}

std::uint64_t Hash(vtkDataSet* data)
{
  std::vector<std::uint64_t> hashes = { static_cast<std::uint64_t>(data->GetNumberOfPoints()) };
  if (vtkPolyData* surface = vtkPolyData::SafeDownCast(data))
  {
    hashes.push_back(Hash(surface->GetPoints()->GetData()));
    hashes.push_back(Hash(surface->GetVerts()->GetConnectivityArray()));
    hashes.push_back(Hash(surface->GetPolys()->GetConnectivityArray()));
  }
  for (int i = 0; i < data->GetPointData()->GetNumberOfArrays(); ++i)
  {
    hashes.push_back(Hash(data->GetPointData()->GetArray(i)));
  }
  return Mix(Start, hashes.data(), hashes.size() * sizeof(std::uint64_t));
}

vtkSmartPointer<vtkLMS3DScanFilter> MakeScan(vtkDataObject* scene)
{
  auto scan = vtkSmartPointer<vtkLMS3DScanFilter>::New();
  scan->SetInputDataObject(scene);
  return scan;
}

void SetGrid(vtkLMS3DScanFilter* scan, int beams, int turns)
{
  scan->SetAlphaResolution(beams);
  scan->SetBetaResolution(turns);
}

vtkDataArray* GetArray(vtkLMS3DScanFilter* scan, const char* name)
{
  return scan->GetOutput()->GetPointData()->GetArray(name);
}

double GetRange(vtkLMS3DScanFilter* scan, vtkIdType i)
{
  return GetArray(scan, "Range")->GetTuple1(i);
}

void PrintTo(const ScanChange& change, std::ostream* os)
{
  *os << change.Name;
}

// Constant, so that tables of other files that take them are made after them.
constexpr ScanChange ToSameSize = { "SameSize",
  [](vtkLMS3DScanFilter* scan) { scan->SetPosition(0.2, 0.1, 0.0); } };
constexpr ScanChange ToLarger = { "Larger",
  [](vtkLMS3DScanFilter* scan) { scan->SetAlphaResolution(181); } };
constexpr ScanChange ToSmaller = { "Smaller",
  [](vtkLMS3DScanFilter* scan) { scan->SetAlphaResolution(5); } };
constexpr ScanChange ToNoReturns = { "NoReturns",
  [](vtkLMS3DScanFilter* scan) { scan->SetMaximumRange(0.1); } };

Point GetPaperDirection(double alpha, double beta)
{
  const double a = vtkMath::RadiansFromDegrees(alpha);
  const double b = vtkMath::RadiansFromDegrees(beta);
  return { std::cos(a) * std::cos(b), -std::cos(a) * std::sin(b), std::sin(a) };
}

std::string UpdateAndGetError(vtkAlgorithm* algorithm)
{
  // The executive repeats each failure in words of its own.
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkTest::ErrorObserver> executiveObserver;
  const unsigned long tag = algorithm->AddObserver(vtkCommand::ErrorEvent, observer);
  const unsigned long executiveTag =
    algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, executiveObserver);
  algorithm->Update();
  algorithm->RemoveObserver(tag);
  algorithm->GetExecutive()->RemoveObserver(executiveTag);
  return observer->GetErrorMessage();
}

std::string UpdateAndGetWarning(vtkAlgorithm* algorithm)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  const unsigned long tag = algorithm->AddObserver(vtkCommand::WarningEvent, observer);
  EXPECT_EQ(UpdateAndGetError(algorithm), "");
  algorithm->RemoveObserver(tag);
  return observer->GetWarningMessage();
}

int UpdateAllAndCountErrors(vtkAlgorithm* algorithm)
{
  int count = 0;
  vtkNew<vtkCallbackCommand> counter;
  counter->SetClientData(&count);
  counter->SetCallback(
    [](vtkObject*, unsigned long, void* errors, void*) { ++*static_cast<int*>(errors); });
  const unsigned long tag = algorithm->AddObserver(vtkCommand::ErrorEvent, counter);
  const unsigned long executiveTag =
    algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, counter);
  for (double time : { 0.0, 0.0, 1.0 })
  {
    for (int port = 0; port < algorithm->GetNumberOfOutputPorts(); ++port)
    {
      algorithm->UpdateTimeStep(time, -1, 1, 0, nullptr);
      algorithm->Update(port);
    }
  }
  algorithm->RemoveObserver(tag);
  algorithm->GetExecutive()->RemoveObserver(executiveTag);
  return count;
}
