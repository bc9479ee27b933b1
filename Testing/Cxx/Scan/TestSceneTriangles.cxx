// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fixtures/MeshFixtures.h"
#include "Fixtures/ProgressListener.h"
#include "Fixtures/SceneFixtures.h"
#include "VRML/VRMLFixtures.h"

#include "Geometry/lms3dAngle.h"
#include "Scene/lms3dSceneTriangles.h"
#include "vtkLMS3DScanFilter.h"

#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkPoints.h>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace
{
using Triangle = std::array<Point, 3>;

std::vector<Point> MakeStar(int corners, double inner, double outer)
{
  std::vector<Point> points;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 2.0 * lms3dPi * i / corners;
    const double radius = i % 2 == 0 ? outer : inner;
    points.push_back({ radius * std::cos(angle), radius * std::sin(angle), -1.0 });
  }
  return points;
}

std::vector<Triangle> GetTriangles(const lms3dTriangleMesh& mesh)
{
  std::vector<Triangle> triangles;
  for (const auto& [a, b, c] : mesh.Triangles)
  {
    triangles.push_back({ mesh.Points[a], mesh.Points[b], mesh.Points[c] });
  }
  return triangles;
}

using SceneTriangles = VRMLScene;
} // namespace

TEST(SceneTrianglesOfPolygons, AreExactForConvexPolygonsOfAnySize)
{
  for (int sides : { 16000, 1000000 })
  {
    const lms3dSceneTriangles scene = lms3dCollectTriangles(MakePolygon(MakeStar(sides, 2.0, 2.0)));
    EXPECT_EQ(scene.CrossedCells, 0);
    EXPECT_EQ(scene.Mesh.Triangles.size(), static_cast<std::size_t>(sides) - 2);
    EXPECT_NEAR(
      GetArea(GetTriangles(scene.Mesh)), 2.0 * sides * std::sin(2.0 * lms3dPi / sides), 1e-9);
  }
}

// Rounding makes half of the corners reflex.
TEST(SceneTrianglesOfPolygons, CoverARoundPolygonInSinglePrecision)
{
  constexpr int sides = 1000000;
  vtkSmartPointer<vtkPolyData> polygon = MakePolygon(MakeStar(sides, 2.0, 2.0));
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->DeepCopy(polygon->GetPoints());
  polygon->SetPoints(points);
  const lms3dSceneTriangles scene = lms3dCollectTriangles(polygon);
  EXPECT_EQ(scene.CrossedCells, 0);
  EXPECT_NEAR(
    GetArea(GetTriangles(scene.Mesh)), 2.0 * sides * std::sin(2.0 * lms3dPi / sides), 1e-5);
}

TEST(SceneTrianglesOfPolygons, StopWithinOnePolygon)
{
  vtkSmartPointer<vtkPolyData> star = MakePolygon(MakeStar(200000, 1.0, 2.0));
  int calls = 0;
  const lms3dSceneTriangles stopped = lms3dCollectTriangles(
    star, "The scene", [&calls](double done) { return done >= 0.0 && ++calls < 2; });
  EXPECT_EQ(calls, 2);
  EXPECT_FALSE(stopped.IsComplete);
  EXPECT_TRUE(stopped.Mesh.Triangles.empty());
  EXPECT_TRUE(lms3dCollectTriangles(star).IsComplete);
}

// Half of a star's corners are reflex, so it is no fan: its triangles take a while.
TEST(SceneTrianglesOfPolygons, TheScanFilterStopsOnAbort)
{
  vtkNew<vtkLMS3DScanFilter> scan;
  scan->SetInputDataObject(MakePolygon(MakeStar(200000, 1.0, 2.0)));
  SetGrid(scan, 19, 18);
  auto abort = std::make_unique<ProgressListener>(scan,
    [&](double share)
    {
      if (share < 0.1)
      {
        scan->AbortExecuteOn();
      }
    });
  const vtkMTimeType built = scan->GetBuildTime();
  EXPECT_EQ(UpdateAndGetError(scan), "");
  EXPECT_EQ(scan->GetErrorCode(), vtkErrorCode::NoError);
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(scan->GetRangeImage()->GetNumberOfPoints(), 0);
  EXPECT_EQ(scan->GetBuildTime(), built);

  abort.reset();
  scan->AbortExecuteOff();
  EXPECT_EQ(UpdateAndGetError(scan), "");
  EXPECT_GT(scan->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_GT(scan->GetBuildTime(), built);
}

TEST(SceneTrianglesOfPolygons, KeepTheDiagonalOfAQuadrilateral)
{
  const Point a = { 0, 0, 0 };
  const Point b = { 1, 0, 0.5 };
  const Point c = { 1, 1, 0 };
  const Point d = { 0, 1, 0.5 };
  EXPECT_EQ(GetTriangles(lms3dCollectTriangles(MakePolygon({ a, b, c, d })).Mesh),
    (std::vector<Triangle>{ { d, a, b }, { d, b, c } }));
}

TEST_F(SceneTriangles, OfAPolygonThatCrossesItselfAreThoseOfTheReader)
{
  for (const std::vector<Point>& polygon :
    { std::vector<Point>{ { 0, 0, 1 }, { 1, 1, 1 }, { 1, 0, 1 }, { 0, 1, 1 } },
      { { 0, 3, 1 }, { 2, -3, 1 }, { -3, 1, 1 }, { 3, 1, 1 }, { -2, -3, 1 } },
      { { 0, 0, 1 }, { 4, 0, 1 }, { 4, 2, 1 }, { 3, 2, 1 }, { 3, -1, 1 }, { 1, -1, 1 }, { 1, 2, 1 },
        { 0, 2, 1 } } })
  {
    std::ostringstream points;
    std::ostringstream indices;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      points << polygon[i][0] << ' ' << polygon[i][1] << ' ' << polygon[i][2] << ", ";
      indices << i << ' ';
    }
    const lms3dScene read =
      this->Read("Shape { geometry IndexedFaceSet { coord Coordinate { point [ " + points.str() +
        "] } coordIndex [ " + indices.str() + "-1 ] } }");
    const lms3dSceneTriangles scene = lms3dCollectTriangles(MakePolygon(polygon));
    EXPECT_EQ(scene.CrossedCells, 1);
    EXPECT_EQ(GetMessages(read).size(), 1u);
    EXPECT_FALSE(scene.Mesh.Triangles.empty());
    EXPECT_EQ(GetTriangles(scene.Mesh), GetTriangles(read));
    EXPECT_EQ(scene.FirstCrossedCell, 0);
    EXPECT_NE(lms3dDescribeSkippedCells(scene, "The scene").find("cross themselves: 1."),
      std::string::npos);
  }
}
