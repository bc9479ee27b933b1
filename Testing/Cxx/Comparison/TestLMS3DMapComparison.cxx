// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fixtures/SceneFixtures.h"

#include "vtkLMS3DMapComparison.h"
#include "vtkLMS3DScanFilter.h"
#include "vtkLMS3DSurfaceReconstructionFilter.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkMinimalStandardRandomSequence.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkReverseSense.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkTriangle.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr double Degree = 3.14159265358979323846 / 180.0;

// 200,000 samples, evenly spread, know the share of a part of the area to about this.
constexpr double ShareError = 1e-3;

// What the sum of so many equal numbers loses.
constexpr double SumError = 1e-13;

void AddDoubles(vtkPolyData* data, const char* name, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  data->GetFieldData()->AddArray(array);
}

/// A scan without returns, of a sensor that stands upright.
vtkSmartPointer<vtkPolyData> MakePose(const Point& sensor,
  const std::vector<double>& alphas = { -90.0, 90.0 },
  const std::vector<double>& betas = { 0.0, 120.0, 240.0 })
{
  auto pose = vtkSmartPointer<vtkPolyData>::New();
  AddDoubles(pose, "AlphaAngles", alphas);
  AddDoubles(pose, "BetaAngles", betas);
  AddDoubles(pose, "SensorToWorld",
    { 1, 0, 0, sensor[0], 0, 1, 0, sensor[1], 0, 0, 1, sensor[2], 0, 0, 0, 1 });
  return pose;
}

vtkSmartPointer<vtkPolyData> Reverse(vtkPolyData* surface)
{
  vtkNew<vtkReverseSense> reverse;
  reverse->SetInputData(surface);
  reverse->Update();
  return reverse->GetOutput();
}

struct Comparison
{
  Comparison(vtkPolyData* map, vtkDataObject* scene, const Point& sensor)
    : Comparison(map, scene, MakePose(sensor))
  {
  }

  Comparison(vtkPolyData* map, vtkDataObject* scene, vtkPolyData* scan)
  {
    this->Filter->SetInputData(map);
    this->Filter->SetSceneData(scene);
    this->Filter->SetScanData(scan);
  }

  double Get(const char* name, int component = 0)
  {
    this->Filter->Update();
    vtkDataArray* result = this->Filter->GetOutput()->GetFieldData()->GetArray(name);
    EXPECT_NE(result, nullptr) << name;
    return result ? result->GetComponent(0, component) : -1.0;
  }

  void ExpectErrors(const char* name, const std::array<double, 4>& expected, double allowed)
  {
    for (int i = 0; i < 4; ++i)
    {
      EXPECT_NEAR(this->Get(name, i), expected[i], allowed) << name << " component " << i;
    }
  }

  vtkPolyData* GetScenePoints()
  {
    this->Filter->Update();
    return vtkPolyData::SafeDownCast(this->Filter->GetOutputDataObject(1));
  }

  vtkNew<vtkLMS3DMapComparison> Filter;
};

vtkSmartPointer<vtkPolyData> Transform(vtkPolyData* surface, vtkTransform* transform)
{
  vtkNew<vtkTransformPolyDataFilter> filter;
  filter->SetInputData(surface);
  filter->SetTransform(transform);
  filter->Update();
  return filter->GetOutput();
}

/// The inside of a cube of 4 m about the origin, of which the wall towards +z may be missing.
vtkSmartPointer<vtkPolyData> MakeCube(bool hasCeiling)
{
  vtkSmartPointer<vtkPolyData> cube = hasCeiling ? MakeFloor(2.0, 2.0) : MakePolygon({});
  for (const Point& turn : { Point{ 0, 0, 0 }, Point{ 90, 0, 0 }, Point{ -90, 0, 0 },
         Point{ 0, 90, 0 }, Point{ 0, -90, 0 } })
  {
    vtkNew<vtkTransform> transform;
    transform->RotateX(turn[0]);
    transform->RotateY(turn[1]);
    cube = Join(cube, Transform(MakeFloor(2.0, -2.0), transform));
  }
  return cube;
}

/// The distance by VTK's own formula, triangle by triangle.
double GetDistanceByBruteForce(vtkPolyData* surface, const double point[3])
{
  double least = std::numeric_limits<double>::infinity();
  vtkNew<vtkTriangle> triangle;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    surface->GetCellPoints(cell, corners);
    for (int i = 0; i < 3; ++i)
    {
      triangle->GetPoints()->SetPoint(i, surface->GetPoint(corners->GetId(i)));
    }
    double closest[3], parametric[3], weights[3], squared;
    int subId;
    if (triangle->EvaluatePosition(point, closest, subId, parametric, squared, weights) >= 0)
    {
      least = std::min(least, squared);
    }
  }
  return std::sqrt(least);
}

/// Triangles of up to a metre in a cube of 8 m, vertices in double.
vtkSmartPointer<vtkPolyData> MakeRandomTriangles(int count, int seed)
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(seed);
  const auto next = [&](double low, double high)
  {
    random->Next();
    return random->GetRangeValue(low, high);
  };
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polygons;
  for (int i = 0; i < count; ++i)
  {
    const Point middle = { next(-4.0, 4.0), next(-4.0, 4.0), next(-4.0, 4.0) };
    polygons->InsertNextCell(3);
    for (int corner = 0; corner < 3; ++corner)
    {
      polygons->InsertCellPoint(points->InsertNextPoint(
        middle[0] + next(-0.5, 0.5), middle[1] + next(-0.5, 0.5), middle[2] + next(-0.5, 0.5)));
    }
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(polygons);
  return surface;
}

void ExpectError(Comparison& comparison, const std::string& word)
{
  const std::string error = UpdateAndGetError(comparison.Filter);
  EXPECT_NE(error.find(word), std::string::npos) << error;
  EXPECT_EQ(comparison.Filter->GetErrorCode(), vtkErrorCode::UserError);
  for (int port = 0; port < 2; ++port)
  {
    EXPECT_EQ(
      vtkPolyData::SafeDownCast(comparison.Filter->GetOutputDataObject(port))->GetNumberOfPoints(),
      0);
  }
}
} // namespace

TEST(LMS3DMapComparison, FindsNothingWrongWithTheSceneItself)
{
  Comparison comparison(MakeCube(true), MakeCube(true), Point{ 0.3, -0.2, 0.1 });
  comparison.ExpectErrors("MapToScene", { 0.0, 0.0, 0.0, 0.0 }, 1e-15);
  comparison.ExpectErrors("SceneToMap", { 0.0, 0.0, 0.0, 0.0 }, 1e-15);
  EXPECT_EQ(comparison.Get("Correctness"), 1.0);
  EXPECT_EQ(comparison.Get("Completeness"), 1.0);
  EXPECT_EQ(comparison.Get("FScore"), 1.0);
  EXPECT_EQ(comparison.Get("AreaInFreeSpace"), 0.0);
  EXPECT_EQ(comparison.Get("MapTriangles"), 12.0);
  EXPECT_NEAR(comparison.Get("MapArea"), 96.0, 1e-9);
  EXPECT_NEAR(comparison.Get("VisibleArea"), 96.0, 1e-9);
}

TEST(LMS3DMapComparison, MeasuresAShiftedPlane)
{
  for (double height : { 0.03, -0.03 })
  {
    Comparison comparison(MakeFloor(2.0, height), MakeFloor(2.0, 0.0), Point{ 0.1, 0.2, 1.0 });
    comparison.ExpectErrors("MapToScene", { 0.03, 0.03, 0.03, 0.03 }, SumError);
    comparison.ExpectErrors("SceneToMap", { 0.03, 0.03, 0.03, 0.03 }, SumError);
    comparison.ExpectErrors("NormalError", { 0.0, 0.0, 0.0, 0.0 }, 1e-12);
    EXPECT_EQ(comparison.Get("Correctness"), 0.0);
    EXPECT_EQ(comparison.Get("Completeness"), 0.0);
    EXPECT_EQ(comparison.Get("FScore"), 0.0);
    // Above the floor the sensor has seen that there is nothing, below it has seen nothing.
    EXPECT_NEAR(comparison.Get("AreaInFreeSpace"), height > 0.0 ? 16.0 : 0.0, 1e-9);
    comparison.Filter->SetTolerance(0.031);
    EXPECT_EQ(comparison.Get("Correctness"), 1.0);
    EXPECT_EQ(comparison.Get("Completeness"), 1.0);
    EXPECT_EQ(comparison.Get("AreaInFreeSpace"), 0.0);
  }
}

TEST(LMS3DMapComparison, MeasuresATiltedPlane)
{
  vtkNew<vtkTransform> tilt;
  tilt->RotateY(3.0);
  Comparison comparison(
    Transform(MakeFloor(1.0, 0.0), tilt), MakeFloor(2.0, 0.0), Point{ 0.0, 0.0, 5.0 });
  const double sine = std::sin(3.0 * Degree);
  comparison.ExpectErrors("MapToScene",
    { 0.5 * sine, std::sqrt(1.0 / 3.0) * sine, 0.95 * sine, sine }, ShareError * sine);
  comparison.ExpectErrors("NormalError", { 3.0, 3.0, 3.0, 3.0 }, 1e-9);
  EXPECT_NEAR(comparison.Get("Correctness"), 0.01 / sine, ShareError);
}

TEST(LMS3DMapComparison, MeasuresALargerBall)
{
  const double facet = GetInradius(MakeBall(1.0));
  Comparison comparison(Reverse(MakeBall(2.1)), MakeBall(2.0), Point{ 0.0, 0.0, 0.0 });
  // Parallel facets, 0.1 m apart at their vertices.
  for (const char* name : { "MapToScene", "SceneToMap" })
  {
    EXPECT_GE(comparison.Get(name), 0.1 * facet - 1e-7) << name;
    EXPECT_LE(comparison.Get(name, 3), 0.1 + 1e-7) << name;
  }
  EXPECT_EQ(comparison.Get("AreaInFreeSpace"), 0.0);
  // The turn from one facet to the next across a corner.
  EXPECT_LT(comparison.Get("NormalError", 3), std::hypot(360.0 / 48.0, 180.0 / 47.0));

  Comparison smaller(MakeBall(1.9), MakeBall(2.0), Point{ 0.0, 0.0, 0.0 });
  EXPECT_NEAR(smaller.Get("AreaInFreeSpace"), smaller.Get("MapArea"), 1e-9);
}

// The distance of a point in a square with side a from its rim has the mean a / 6, the mean square
// a^2 / 24, and exceeds x in the share (1 - 2 x / a)^2 of the square.
TEST(LMS3DMapComparison, MissesAWall)
{
  Comparison comparison(MakeCube(false), MakeCube(true), Point{ 0.3, -0.2, 0.1 });
  comparison.ExpectErrors("MapToScene", { 0.0, 0.0, 0.0, 0.0 }, 1e-15);
  comparison.ExpectErrors("SceneToMap",
    { 4.0 / 36.0, std::sqrt(16.0 / 24.0 / 6.0), 2.0 * (1.0 - std::sqrt(0.3)), 2.0 }, 0.01);
  EXPECT_EQ(comparison.Get("Correctness"), 1.0);
  comparison.Filter->SetTolerance(0.5);
  EXPECT_NEAR(comparison.Get("Completeness"), (6.0 - 0.75 * 0.75) / 6.0, ShareError);
  const double completeness = comparison.Get("Completeness");
  EXPECT_DOUBLE_EQ(comparison.Get("FScore"), 2.0 * completeness / (1.0 + completeness));
}

TEST(LMS3DMapComparison, MissesWhatAHoleLeavesOut)
{
  vtkSmartPointer<vtkPolyData> map = MakePolygon({});
  for (int side = 0; side < 4; ++side)
  {
    vtkNew<vtkTransform> turn;
    turn->RotateZ(90.0 * side);
    map = Join(map,
      Transform(MakePolygon({ { -2, -2, 0 }, { 2, -2, 0 }, { 1, -1, 0 }, { -1, -1, 0 } }), turn));
  }
  Comparison comparison(map, MakeFloor(2.0, 0.0), Point{ 0.0, 0.0, 1.0 });
  comparison.ExpectErrors("SceneToMap",
    { 2.0 / 6.0 / 4.0, std::sqrt(4.0 / 24.0 / 4.0), 1.0 - std::sqrt(0.2), 1.0 }, 0.006);
  EXPECT_NEAR(comparison.Get("Completeness"), 0.75 + 0.25 * (1.0 - 0.99 * 0.99), ShareError);
}

TEST(LMS3DMapComparison, SeesBetweenTheVertices)
{
  // All vertices lie on the scene, and yet the map bridges a ditch 1 m deep.
  vtkSmartPointer<vtkPolyData> scene = MakePolygon({});
  for (const Point& piece : { Point{ -2, -1, 0 }, Point{ -1, 1, -1 }, Point{ 1, 2, 0 } })
  {
    scene = Join(scene,
      MakePolygon({ { piece[0], -2, piece[2] }, { piece[1], -2, piece[2] },
        { piece[1], 2, piece[2] }, { piece[0], 2, piece[2] } }));
  }
  Comparison comparison(MakeFloor(2.0, 0.0), scene, Point{ 0.0, 0.0, 2.0 });
  EXPECT_NEAR(comparison.Get("MapToScene", 3), 1.0, 1e-4);
  EXPECT_NEAR(comparison.Get("Correctness"), 0.5 + 0.02 / 4.0, ShareError);
  EXPECT_NEAR(comparison.Get("AreaInFreeSpace"), 8.0 - 0.08, 0.02);
  vtkPolyData* map = comparison.Filter->GetOutput();
  EXPECT_EQ(map->GetPointData()->GetArray("Error")->GetRange()[1], 0.0);
  EXPECT_NEAR(map->GetCellData()->GetArray("LargestError")->GetTuple1(0), 1.0, 1e-4);
}

TEST(LMS3DMapComparison, TellsABackFromAFront)
{
  Comparison comparison(Reverse(MakeFloor(2.0, 0.03)), MakeFloor(2.0, 0.0), Point{ 0.1, 0.2, 1.0 });
  comparison.ExpectErrors("NormalError", { 180.0, 180.0, 180.0, 180.0 }, 1e-12);
  comparison.ExpectErrors("MapToScene", { 0.03, 0.03, 0.03, 0.03 }, SumError);
}

TEST(LMS3DMapComparison, AsksOnlyForWhatTheSensorSees)
{
  const auto front = MakePolygon({ { 2, -1, -1 }, { 2, 1, -1 }, { 2, 1, 1 }, { 2, -1, 1 } });
  const auto hidden = MakePolygon({ { 4, -2, -2 }, { 4, 2, -2 }, { 4, 2, 2 }, { 4, -2, 2 } });
  const auto behind = MakePolygon({ { -3, -1, -1 }, { -3, 1, -1 }, { -3, 1, 1 }, { -3, -1, 1 } });
  const auto above = MakePolygon({ { -1, -1, 9 }, { 1, -1, 9 }, { 1, 1, 9 }, { -1, 1, 9 } });
  const auto scene = Join(Join(front, hidden), Join(behind, above));
  const std::vector<double> alphas = { -50.0, 0.0, 50.0 };
  const std::vector<double> betas = { -60.0, 0.0, 60.0 };

  Comparison narrow(front, scene, MakePose({ 0, 0, 0 }, alphas, betas));
  EXPECT_EQ(narrow.Get("Completeness"), 1.0);
  EXPECT_NEAR(narrow.Get("VisibleArea"), 4.0, 0.01);

  Comparison allAround(front, scene, Point{ 0, 0, 0 });
  EXPECT_NEAR(allAround.Get("VisibleArea"), 12.0, 0.01);
  EXPECT_NEAR(allAround.Get("Completeness"), 1.0 / 3.0, ShareError);
  allAround.Filter->SetMaximumRange(8.0);
  EXPECT_NEAR(allAround.Get("VisibleArea"), 8.0, 0.01);
  // Takes a disc with a square radius of 2.2^2 - 2^2 out of the nearer wall.
  allAround.Filter->SetMinimumRange(2.2);
  EXPECT_NEAR(allAround.Get("VisibleArea"), 8.0 - 180.0 * Degree * 0.84, 0.01);
}

TEST(LMS3DMapComparison, CallsOnlyThatEmptyWhichTheSensorSawToBe)
{
  const auto scene = MakePolygon({ { 2, -1, -1 }, { 2, 1, -1 }, { 2, 1, 1 }, { 2, -1, 1 } });
  const auto phantom = MakePolygon({ { -3, -1, -1 }, { -3, 1, -1 }, { -3, 1, 1 }, { -3, -1, 1 } });
  Comparison narrow(
    Join(scene, phantom), scene, MakePose({ 0, 0, 0 }, { -50.0, 50.0 }, { -60.0, 0.0, 60.0 }));
  EXPECT_EQ(narrow.Get("AreaInFreeSpace"), 0.0);
  // A beam without a return has met nothing up to the maximum range.
  Comparison allAround(Join(scene, phantom), scene, Point{ 0, 0, 0 });
  EXPECT_NEAR(allAround.Get("AreaInFreeSpace"), 4.0, 1e-4);
  allAround.Filter->SetMaximumRange(2.9);
  EXPECT_EQ(allAround.Get("AreaInFreeSpace"), 0.0);
}

TEST(LMS3DMapComparison, TurnsTheViewWithTheSensor)
{
  const auto wall = MakePolygon({ { 2, -1, -1 }, { 2, 1, -1 }, { 2, 1, 1 }, { 2, -1, 1 } });
  // Turned by 90 degrees to the left; the wall is 90 degrees to its right, and beta turns right.
  vtkSmartPointer<vtkPolyData> pose = MakePose({ 0, 0, 0 }, { -50.0, 50.0 }, { 30.0, 90.0, 150.0 });
  AddDoubles(pose, "SensorToWorld", { 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 });
  Comparison right(wall, wall, pose);
  EXPECT_NEAR(right.Get("VisibleArea"), 4.0, 1e-9);
  AddDoubles(pose, "BetaAngles", { 210.0, 270.0, 330.0 });
  Comparison left(wall, wall, pose);
  ExpectError(left, "sees nothing");
}

TEST(LMS3DMapComparison, AgreesWithBruteForceAtAnyPlaceAndSize)
{
  for (const Point& placed :
    { Point{ 1.0, 0.0, 0.0 }, Point{ 1e-4, 0.0, 0.0 }, Point{ 1e3, 1e6, -1e6 } })
  {
    vtkNew<vtkTransform> transform;
    transform->Translate(placed[1], placed[2], placed[1]);
    transform->Scale(placed[0], placed[0], placed[0]);
    const auto scene = Transform(MakeRandomTriangles(300, 1), transform);
    const auto map = Transform(MakeRandomTriangles(300, 2), transform);
    Comparison comparison(map, scene, Point{ placed[1], placed[2], placed[1] });
    comparison.Filter->SetMaximumRange(1e9);
    comparison.Filter->SetNumberOfSamples(1000);
    comparison.Filter->Update();
    vtkDataArray* errors = comparison.Filter->GetOutput()->GetPointData()->GetArray("Error");
    const double rounding = 1e-12 * (8.0 * placed[0] + 1e3 * std::abs(placed[1]));
    for (vtkIdType i = 0; i < map->GetNumberOfPoints(); ++i)
    {
      ASSERT_NEAR(errors->GetTuple1(i), GetDistanceByBruteForce(scene, map->GetPoint(i)), rounding);
    }
    vtkPolyData* seen = comparison.GetScenePoints();
    ASSERT_GT(seen->GetNumberOfPoints(), 500);
    for (vtkIdType i = 0; i < seen->GetNumberOfPoints(); ++i)
    {
      ASSERT_NEAR(seen->GetPointData()->GetArray("Error")->GetTuple1(i),
        GetDistanceByBruteForce(map, seen->GetPoint(i)), rounding);
    }
  }
}

TEST(LMS3DMapComparison, FindsWhatIsFarAway)
{
  const auto map = MakePolygon({ { 5000, 0, 0 }, { 5000.001, 0, 0 }, { 5000, 0.001, 0 } });
  Comparison comparison(map, MakeFloor(1.0, 0.0), Point{ 0.0, 0.0, 1.0 });
  EXPECT_NEAR(comparison.Get("MapToScene", 3), 4999.001, 1e-6);
  EXPECT_NEAR(comparison.Get("SceneToMap", 3), std::hypot(5001.0, 1.0), 0.05);
}

TEST(LMS3DMapComparison, HasTheSameBitsForAnyNumberOfThreads)
{
  vtkNew<vtkLMS3DScanFilter> scan;
  scan->SetInputData(ReadRoom());
  scan->SetPosition(0.3, -0.2, 1.0);
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> map;
  map->SetInputConnection(scan->GetOutputPort());
  map->Update();
  Comparison comparison(map->GetOutput(), ReadRoom(), scan->GetOutput());
  std::vector<std::vector<std::uint64_t>> runs;
  for (int threads : { 1, 2, 7 })
  {
    comparison.Filter->SetNumberOfThreads(threads);
    vtkPolyData* points = comparison.GetScenePoints();
    vtkPolyData* output = comparison.Filter->GetOutput();
    runs.push_back({ Hash(points), Hash(output->GetPointData()->GetArray("Error")),
      Hash(output->GetCellData()->GetArray("LargestError")) });
    for (const char* name : { "MapToScene", "SceneToMap", "NormalError", "Correctness",
           "Completeness", "AreaInFreeSpace", "LargestReturnDistance" })
    {
      runs.back().push_back(Hash(output->GetFieldData()->GetArray(name)));
    }
  }
  EXPECT_EQ(runs[0], runs[1]);
  EXPECT_EQ(runs[0], runs[2]);
}

TEST(LMS3DMapComparison, TakesPoseAndReturnsFromTheScan)
{
  vtkNew<vtkLMS3DScanFilter> scan;
  scan->SetInputData(MakeBall(2.0));
  scan->SetAlphaResolution(19);
  scan->SetBetaResolution(36);
  scan->Update();
  const vtkIdType returns = scan->GetOutput()->GetNumberOfPoints();
  Comparison comparison(MakeBall(2.1), MakeBall(2.0), scan->GetOutput());
  comparison.Filter->SetTolerance(0.2);
  EXPECT_EQ(comparison.Get("ReturnsWithinTolerance"), 1.0);
  EXPECT_GT(comparison.Get("LargestReturnDistance"), 0.099);
  EXPECT_LT(comparison.Get("LargestReturnDistance"), 0.1 + 1e-7);

  vtkNew<vtkPolyData> moved;
  moved->DeepCopy(scan->GetOutput());
  moved->GetPoints()->SetPoint(5, 0.0, 0.0, 0.0);
  Comparison withOutlier(MakeBall(2.1), MakeBall(2.0), moved);
  withOutlier.Filter->SetTolerance(0.2);
  EXPECT_DOUBLE_EQ(withOutlier.Get("ReturnsWithinTolerance"), 1.0 - 1.0 / returns);
  EXPECT_GT(withOutlier.Get("LargestReturnDistance"), 2.0);
}

TEST(LMS3DMapComparison, TakesThePoseFromTheMap)
{
  vtkNew<vtkLMS3DScanFilter> scan;
  scan->SetInputData(MakeBall(2.0));
  scan->SetPosition(0.5, 0.0, 0.0);
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> map;
  map->SetInputConnection(scan->GetOutputPort());
  vtkNew<vtkLMS3DMapComparison> filter;
  filter->SetInputConnection(map->GetOutputPort());
  filter->SetSceneData(MakeBall(2.0));
  EXPECT_EQ(UpdateAndGetError(filter), "");
  vtkFieldData* results = filter->GetOutput()->GetFieldData();
  EXPECT_EQ(results->GetArray("ReturnsWithinTolerance"), nullptr);
  EXPECT_EQ(results->GetArray("Completeness")->GetTuple1(0), 1.0);
  EXPECT_LT(results->GetArray("NormalError")->GetComponent(0, 0), 3.0);
}

TEST(LMS3DMapComparison, LeavesItsInputsAlone)
{
  const auto map = MakeFloor(2.0, 0.03);
  Comparison comparison(map, MakeFloor(2.0, 0.0), Point{ 0.0, 0.0, 1.0 });
  comparison.Filter->Update();
  EXPECT_EQ(map->GetPointData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(map->GetCellData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(map->GetFieldData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(comparison.Filter->GetOutput()->GetNumberOfCells(), 1);
}

TEST(LMS3DMapComparison, LeavesOutCellsThatAreNotFinite)
{
  const double bad = std::numeric_limits<double>::quiet_NaN();
  const auto map =
    Join(MakeFloor(2.0, 0.0), MakePolygon({ { bad, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }));
  Comparison comparison(map, MakeFloor(2.0, 0.0), Point{ 0.0, 0.0, 1.0 });
  vtkNew<vtkTest::ErrorObserver> observer;
  comparison.Filter->AddObserver(vtkCommand::WarningEvent, observer);
  EXPECT_EQ(comparison.Get("MapToScene", 3), 0.0);
  const std::string warning = observer->GetWarningMessage();
  EXPECT_NE(warning.find("The map: cells with a point that is not finite"), std::string::npos);
  EXPECT_NE(warning.find("left out: 1."), std::string::npos) << warning;
  vtkPolyData* output = comparison.Filter->GetOutput();
  EXPECT_TRUE(std::isnan(output->GetPointData()->GetArray("Error")->GetTuple1(4)));
  EXPECT_TRUE(std::isnan(output->GetCellData()->GetArray("LargestError")->GetTuple1(1)));
}

TEST(LMS3DMapComparison, RefusesWhatCannotBeCompared)
{
  const auto surface = MakeFloor(2.0, 0.0);
  const Point sensor = { 0.0, 0.0, 1.0 };
  vtkNew<vtkPolyData> nothing;
  Comparison noMap(nothing, surface, sensor);
  ExpectError(noMap, "The map has no triangles");
  Comparison noScene(surface, nothing, sensor);
  ExpectError(noScene, "The scene has no triangles");
  Comparison noArea(MakePolygon({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } }), surface, sensor);
  ExpectError(noArea, "The map has no triangles");
  Comparison points(MakePose(sensor), surface, sensor);
  ExpectError(points, "The map has no triangles");
  Comparison noPose(surface, surface, nothing);
  ExpectError(noPose, "SensorToWorld");
  Comparison farAway(surface, surface, Point{ 0.0, 0.0, 100.0 });
  ExpectError(farAway, "sees nothing of the scene");

  vtkSmartPointer<vtkPolyData> pose = MakePose(sensor);
  AddDoubles(pose, "AlphaAngles", { -90.0, std::numeric_limits<double>::quiet_NaN() });
  Comparison badAngles(surface, surface, pose);
  ExpectError(badAngles, "AlphaAngles is not finite");
  pose = MakePose(sensor);
  AddDoubles(pose, "SensorToWorld", { 1.0, 2.0 });
  Comparison badMatrix(surface, surface, pose);
  ExpectError(badMatrix, "matrix of 16");
}

TEST(LMS3DMapComparison, RefusesBadProperties)
{
  Comparison comparison(MakeFloor(2.0, 0.0), MakeFloor(2.0, 0.0), Point{ 0.0, 0.0, 1.0 });
  comparison.Filter->SetTolerance(std::numeric_limits<double>::quiet_NaN());
  ExpectError(comparison, "Tolerance");
  comparison.Filter->SetTolerance(0.01);
  comparison.Filter->SetMinimumRange(5.0);
  comparison.Filter->SetMaximumRange(2.0);
  ExpectError(comparison, "MinimumRange and MaximumRange are 5 and 2");
  comparison.Filter->SetMaximumRange(std::numeric_limits<double>::infinity());
  comparison.Filter->SetMinimumRange(0.0);
  EXPECT_EQ(UpdateAndGetError(comparison.Filter), "");
  EXPECT_EQ(comparison.Filter->GetErrorCode(), vtkErrorCode::NoError);
}
