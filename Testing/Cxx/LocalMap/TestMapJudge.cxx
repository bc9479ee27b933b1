// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Breaks each law of maps on purpose and checks that the judge finds the breach.
 */
#include "LocalMap/MapJudgeFixture.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace
{
/// The number of a triangle that is far from borders, like its neighbours.
constexpr std::size_t Inside = 501;
} // namespace

TEST_F(MapJudge, LikesALawfulMap)
{
  const MapVerdict verdict = this->Judge();
  EXPECT_TRUE(verdict.IsLawful()) << verdict;
  ExpectClosed(verdict);
  EXPECT_LT(verdict.LargestDeviation, 1e-12);
}

TEST_F(MapJudge, SeesAVertexBehindItsReturn)
{
  this->MovePoint(this->Triangles[Inside][0], 1.02);
  this->ExpectBreach("bound");
}

TEST_F(MapJudge, SeesAVertexInFrontOfItsReturn)
{
  this->MovePoint(this->Triangles[Inside][0], 0.98);
  this->ExpectBreach("bound");
  this->ExpectBreach("free space");
}

TEST_F(MapJudge, LetsAVertexMoveWithinTheBound)
{
  this->MovePoint(this->Triangles[Inside][0], 0.996);
  const MapVerdict verdict = this->Judge();
  EXPECT_EQ(verdict.GetNumberOfBreaches("bound"), 0) << verdict;
  EXPECT_EQ(verdict.GetNumberOfBreaches("free space"), 0) << verdict;
  // The judge reports the distance, and that the field data of the map does not contain it.
  EXPECT_GT(verdict.LargestDeviation, 0.004);
  EXPECT_GT(verdict.GetNumberOfBreaches("field data"), 0) << verdict;
}

TEST_F(MapJudge, SeesAHole)
{
  this->Triangles.erase(this->Triangles.begin() + Inside);
  this->ExpectBreach("crack");
  this->ExpectBreach("boundary");
  EXPECT_EQ(this->Judge().NumberOfBoundaryEdges, 3);
  EXPECT_EQ(this->Judge().EulerCharacteristic, 1);
}

TEST_F(MapJudge, SeesABeamThatMissesTheSurface)
{
  const vtkIdType vertex = this->Triangles[Inside][0];
  this->Triangles.erase(
    std::remove_if(this->Triangles.begin(), this->Triangles.end(),
      [&](const Triangle& triangle)
      { return std::find(triangle.begin(), triangle.end(), vertex) != triangle.end(); }),
    this->Triangles.end());
  this->ExpectBreach("beam");
  this->ExpectBreach("bound");
  this->ExpectBreach("point");
}

TEST_F(MapJudge, SeesATriangleThatFacesAway)
{
  std::swap(this->Triangles[Inside][0], this->Triangles[Inside][1]);
  this->ExpectBreach("facing");
  this->ExpectBreach("edge");
}

TEST_F(MapJudge, SeesAnEdgeOfThreeTriangles)
{
  const auto [a, b, c] = this->Triangles[Inside];
  this->Triangles.push_back({ a, b, this->AddPoint(0.999 * this->GetPoint(c)) });
  this->ExpectBreach("edge");
}

TEST_F(MapJudge, SeesATJunction)
{
  // One of two neighbours is halved at the edge that they share.
  const auto [a, b, c] = this->Triangles[Inside];
  const vtkIdType middle = this->AddPoint(0.5 * (this->GetPoint(a) + this->GetPoint(b)));
  this->Triangles[Inside] = { a, middle, c };
  this->Triangles.push_back({ middle, b, c });
  this->ExpectBreach("T-junction");
  this->ExpectBreach("boundary");
}

TEST_F(MapJudge, LetsAFacetStandAtAPoleForReturnsBesideItsVertex)
{
  this->AddFacet(0.0, 0.95);
  this->ExpectBreach("boundary");
  // The return of one turn at the pole is where the facet is.
  this->MoveReturn(0, 0.95);
  const MapVerdict verdict = this->Judge();
  EXPECT_EQ(verdict.GetNumberOfBreaches("boundary"), 0) << verdict;
  EXPECT_EQ(verdict.GetNumberOfBreaches("bound"), 0) << verdict;
}

TEST_F(MapJudge, SeesAFacetAtAPoleThatNoReturnNeeds)
{
  this->AddFacet(0.0, 0.95);
  this->MoveReturn(0, 1.05);
  this->ExpectBreach("boundary");
  this->ExpectBreach("bound");
}

TEST_F(MapJudge, SeesAFacetBesideAPole)
{
  this->MoveReturn(0, 0.95);
  this->AddFacet(0.02, 0.95);
  this->ExpectBreach("boundary");
  this->ExpectBreach("bound");
}

TEST_F(MapJudge, SeesATriangleWithoutArea)
{
  const auto [a, b, c] = this->Triangles[Inside];
  const vtkIdType middle = this->AddPoint(0.5 * (this->GetPoint(a) + this->GetPoint(b)));
  this->Triangles.push_back({ a, middle, b });
  this->ExpectBreach("area");
  this->Triangles.back() = { a, a, b };
  this->ExpectBreach("area");
}

TEST_F(MapJudge, SeesPointsThatAreNone)
{
  this->AddPoint({ 0.0, 0.0, 2.0 });
  this->ExpectBreach("point");
}

TEST_F(MapJudge, SeesPointsThatAreNotFinite)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  this->Map->GetPoints()->SetPoint(this->Triangles[Inside][0], nan, 0.0, 0.0);
  this->ExpectBreach("point");
}

TEST_F(MapJudge, SeesWrongArrays)
{
  this->Map->GetPointData()->GetArray("Range")->SetTuple1(7, 2.001);
  this->ExpectBreach("range");
  this->Map->GetPointData()->GetNormals()->SetTuple3(7, 0.5, 0.0, 0.0);
  this->ExpectBreach("normal");
  const Vector away = Normalize(this->GetPoint(7));
  this->Map->GetPointData()->GetNormals()->SetTuple(7, away.data());
  this->ExpectBreach("normal");
}

TEST_F(MapJudge, SeesWrongNormalsOfTriangles)
{
  vtkSmartPointer<vtkPolyData> map = MakeMap(this->Scan, 0.01);
  EXPECT_TRUE(JudgeMap(this->Scan, map, { 0.01 }).IsLawful());
  vtkNew<vtkPolyData> wrong;
  wrong->DeepCopy(map);
  wrong->GetCellData()->GetNormals()->SetTuple3(3, 0.0, 0.6, 0.8);
  EXPECT_EQ(JudgeMap(this->Scan, wrong, { 0.01 }).GetNumberOfBreaches("normal"), 1u);
  wrong->GetCellData()->SetNormals(nullptr);
  wrong->GetCellData()->RemoveArray("Normals");
  EXPECT_EQ(JudgeMap(this->Scan, wrong, { 0.01 }).GetNumberOfBreaches("normal"), 1u);
}

TEST_F(MapJudge, SeesWrongFieldData)
{
  this->AddValue<vtkIntArray>("NumberOfPatches", 2);
  this->ExpectBreach("field data");
  this->TakeGrid();
  this->AddValue<vtkIntArray>("NumberOfReturnsOnPatches", 7);
  this->ExpectBreach("field data");
  this->TakeGrid();
  this->AddValue<vtkDoubleArray>("LargestDeviation", 0.001);
  this->ExpectBreach("field data");
}

TEST_F(MapJudge, SeesSurfaceWhereABeamMissed)
{
  this->Scan = Keep(this->Scan, [](vtkIdType number) { return number != 15 * 31 + 15; });
  this->ExpectBreach("miss");
}

TEST_F(MapJudge, SeesSurfaceBesideTheScan)
{
  this->Scan = Keep(this->Scan, [](vtkIdType number) { return number < 10 * 31; });
  this->ExpectBreach("overhang");
}

TEST_F(MapJudge, SeesABridge)
{
  // A hatch of six by six beams, half a metre deep. The grid has no triangles at its rim.
  const auto isHatch = [](int turn, int number)
  { return turn >= 12 && turn < 18 && number >= 12 && number < 18; };
  this->Scan = MakeScan(MakeAngles(-45.0, 45.0, 31), MakeAngles(0.0, 90.0, 31),
    [&](int turn, int number) { return isHatch(turn, number) ? 2.5 : 2.0; });
  this->Scene.Surface = nullptr;
  this->TakeGrid();
  const MapVerdict verdict = this->Judge();
  EXPECT_TRUE(verdict.IsLawful()) << verdict;

  const auto getVertex = [](int turn, int number) { return vtkIdType(turn) * 31 + number; };
  this->Triangles.push_back({ getVertex(11, 14), getVertex(12, 14), getVertex(11, 15) });
  this->ExpectBreach("bridge");
}
