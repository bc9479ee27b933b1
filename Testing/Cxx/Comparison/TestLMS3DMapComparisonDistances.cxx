// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The distances of vtkLMS3DMapComparison against VTK's, triangle by triangle, and far away.
 */
#include "Comparison/ComparisonFixtures.h"

#include "Geometry/lms3dAngle.h"

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkMinimalStandardRandomSequence.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTransform.h>
#include <vtkTriangle.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
/// Computes the distance by VTK, triangle by triangle.
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

/// Triangles of up to a metre in a cube of 8 m, with vertices in double.
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
} // namespace

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
  EXPECT_NEAR(comparison.Update()->GetMapToSceneMaximum(), 4999.001, 1e-6);
  EXPECT_NEAR(comparison.Update()->GetSceneToMapMaximum(), std::hypot(5001.0, 1.0), 0.05);
}
