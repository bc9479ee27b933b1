// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What the returns of a scan have hit: normals, incidence and the scene's cell data.
 */
#include "Fixtures/MeshFixtures.h"
#include "Fixtures/SceneBuilder.h"
#include "Fixtures/SceneFixtures.h"

#include "vtkLMS3DScanFilter.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkTransform.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

namespace
{
// The arrays are in single precision.
constexpr double NormalTolerance = 1e-7;
constexpr double DegreeTolerance = 1e-5;

vtkSmartPointer<vtkLMS3DScanFilter> MakeLabelledScan(vtkDataObject* scene)
{
  auto scan = MakeScan(scene);
  scan->SurfaceAttributesOn();
  SetGrid(scan, 61, 72);
  return scan;
}

Point GetTuple(vtkLMS3DScanFilter* scan, const char* name, vtkIdType i)
{
  Point tuple;
  GetArray(scan, name)->GetTuple(i, tuple.data());
  return tuple;
}

/// The unit vector from a return to the sensor.
Vector GetWayToSensor(vtkLMS3DScanFilter* scan, vtkIdType i)
{
  Vector point, position;
  scan->GetOutput()->GetPoint(i, point.data());
  scan->GetPosition(position.data());
  return Normalize(position - point);
}

double GetDegrees(double cosine)
{
  return vtkMath::DegreesFromRadians(std::acos(std::min(1.0, cosine)));
}

void AddInts(vtkDataSet* data, const char* name, int first)
{
  vtkNew<vtkIntArray> values;
  values->SetName(name);
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    values->InsertNextValue(first + static_cast<int>(cell));
  }
  data->GetCellData()->AddArray(values);
}

/// Compares an array of the scan with that of the scene at CellId.
void ExpectValuesOfCells(vtkLMS3DScanFilter* scan, vtkDataSet* scene, const char* name)
{
  vtkDataArray* expected = scene->GetCellData()->GetArray(name);
  vtkDataArray* found = GetArray(scan, name);
  ASSERT_NE(found, nullptr) << name;
  EXPECT_EQ(found->GetDataType(), expected->GetDataType());
  ASSERT_EQ(found->GetNumberOfComponents(), expected->GetNumberOfComponents());
  ASSERT_EQ(found->GetNumberOfTuples(), scan->GetOutput()->GetNumberOfPoints());
  for (vtkIdType i = 0; i < found->GetNumberOfTuples(); ++i)
  {
    const vtkIdType cell = static_cast<vtkIdType>(GetArray(scan, "CellId")->GetTuple1(i));
    for (int component = 0; component < found->GetNumberOfComponents(); ++component)
    {
      ASSERT_EQ(found->GetComponent(i, component), expected->GetComponent(cell, component)) << name;
    }
  }
}
} // namespace

// --- Off and on ---------------------------------------------------------------------------------

TEST(LMS3DScanSurfaceAttributes, AreOffAndChangeNothingElse)
{
  auto scan = MakeScan(ReadRoom());
  scan->SetPosition(0.3, -0.2, 1.0);
  SetGrid(scan, 61, 72);
  scan->SetMaximumRange(3.0);
  EXPECT_FALSE(scan->GetSurfaceAttributes());
  scan->Update();
  vtkPointData* arrays = scan->GetOutput()->GetPointData();
  ASSERT_EQ(arrays->GetNumberOfArrays(), 5);
  EXPECT_EQ(arrays->GetNormals(), nullptr);
  const vtkMTimeType buildTime = scan->GetBuildTime();
  const std::uint64_t plain = Hash(scan->GetOutput());
  const std::uint64_t image = Hash(scan->GetRangeImage());

  scan->SurfaceAttributesOn();
  scan->Update();
  EXPECT_EQ(scan->GetBuildTime(), buildTime);
  EXPECT_EQ(Hash(scan->GetRangeImage()), image);
  EXPECT_EQ(scan->GetRangeImage()->GetPointData()->GetNumberOfArrays(), 1);
  arrays = scan->GetOutput()->GetPointData();
  EXPECT_EQ(arrays->GetScalars(), arrays->GetArray("Range"));
  EXPECT_EQ(arrays->GetNormals(), arrays->GetArray("Normals"));
  while (arrays->GetNumberOfArrays() > 5)
  {
    arrays->RemoveArray(5);
  }
  EXPECT_EQ(Hash(scan->GetOutput()), plain);

  scan->SurfaceAttributesOff();
  scan->Update();
  EXPECT_EQ(scan->GetOutput()->GetPointData()->GetNumberOfArrays(), 5);
  EXPECT_EQ(Hash(scan->GetOutput()), plain);
}

TEST(LMS3DScanSurfaceAttributes, AreTheSameBitsForAnyNumberOfThreads)
{
  auto scan = MakeLabelledScan(ReadRoom());
  scan->SetPosition(0.3, -0.2, 1.0);
  scan->SetNumberOfThreads(1);
  scan->Update();
  const std::uint64_t expected = Hash(scan->GetOutput());
  for (int threads : { 2, 3, 8 })
  {
    scan->SetNumberOfThreads(threads);
    scan->Update();
    EXPECT_EQ(Hash(scan->GetOutput()), expected) << threads << " threads";
  }
}

TEST(LMS3DScanSurfaceAttributes, AreThereWithoutReturns)
{
  auto scan = MakeLabelledScan(ReadRoom());
  scan->SetPosition(0.3, -0.2, 1.0);
  scan->SetMaximumRange(0.01);
  scan->Update();
  ASSERT_EQ(scan->GetOutput()->GetNumberOfPoints(), 0);
  for (const char* name : { "Normals", "Incidence", "ShapeId", "Color" })
  {
    ASSERT_NE(GetArray(scan, name), nullptr) << name;
    EXPECT_EQ(GetArray(scan, name)->GetNumberOfTuples(), 0);
  }
}

// --- Normals and incidence ----------------------------------------------------------------------

TEST(LMS3DScanSurfaceAttributes, IncidenceOnAFloorIsTheAngleFromThePlumbLine)
{
  for (double height : { 1.5, -1.5 })
  {
    auto scan = MakeLabelledScan(MakeFloor(1000.0, -height));
    scan->SetAlphaRange(height > 0.0 ? -90.0 : 2.0, height > 0.0 ? -2.0 : 90.0);
    scan->Update();
    ASSERT_EQ(scan->GetOutput()->GetNumberOfPoints(), 61 * 72);
    for (vtkIdType i = 0; i < 61 * 72; ++i)
    {
      const double alpha = GetArray(scan, "Alpha")->GetTuple1(i);
      ASSERT_NEAR(
        GetArray(scan, "Incidence")->GetTuple1(i), 90.0 - std::abs(alpha), DegreeTolerance);
      ASSERT_EQ(GetTuple(scan, "Normals", i), (Point{ 0.0, 0.0, height > 0.0 ? 1.0 : -1.0 }));
    }
  }
}

TEST(LMS3DScanSurfaceAttributes, InABoxTheLargestComponentOfTheDirectionCounts)
{
  SceneBuilder box;
  box.AddBox({ -1.0, -1.0, -1.0 }, { 1.0, 1.0, 1.0 });
  auto scan = MakeLabelledScan(box.GetSurface());
  scan->SetOrientation(10.0, 20.0, 30.0);
  scan->Update();
  ASSERT_EQ(scan->GetOutput()->GetNumberOfPoints(), 61 * 72);
  for (vtkIdType i = 0; i < 61 * 72; ++i)
  {
    const Vector way = GetWayToSensor(scan, i);
    const auto largest = std::max_element(
      way.begin(), way.end(), [](double x, double y) { return std::abs(x) < std::abs(y); });
    ASSERT_NEAR(
      GetArray(scan, "Incidence")->GetTuple1(i), GetDegrees(std::abs(*largest)), DegreeTolerance);
    const Point normal = GetTuple(scan, "Normals", i);
    ASSERT_NEAR(normal[largest - way.begin()], *largest > 0.0 ? 1.0 : -1.0, NormalTolerance);
  }
}

TEST(LMS3DScanSurfaceAttributes, InABallIncidenceFollowsTheSineRule)
{
  // A triangle spans a degree along one axis and half a degree along the other.
  constexpr double Facet = 0.75;
  constexpr double Offset = 0.6;
  auto scan = MakeLabelledScan(MakeBall(1.0, 360));
  scan->SetPosition(Offset, 0.0, 0.0);
  scan->Update();
  ASSERT_EQ(scan->GetOutput()->GetNumberOfPoints(), 61 * 72);
  for (vtkIdType i = 0; i < 61 * 72; ++i)
  {
    const double cosine = GetWayToSensor(scan, i)[0];
    const double expected =
      vtkMath::DegreesFromRadians(std::asin(Offset * std::sqrt(1.0 - cosine * cosine)));
    ASSERT_NEAR(GetArray(scan, "Incidence")->GetTuple1(i), expected, Facet);
  }
}

TEST(LMS3DScanSurfaceAttributes, NormalsHaveLengthOneAndFaceTheSensorForAnyOrderOfCorners)
{
  auto room = ReadRoom();
  vtkNew<vtkPolyData> reversed;
  reversed->DeepCopy(room);
  for (vtkIdType cell = 0; cell < reversed->GetNumberOfCells(); ++cell)
  {
    reversed->ReverseCell(cell);
  }
  for (int method = 0; method < vtkLMS3DScanFilter::GetNumberOfIntersectionMethods(); ++method)
  {
    auto scan = MakeLabelledScan(room);
    auto other = MakeLabelledScan(reversed);
    for (vtkLMS3DScanFilter* filter : { scan.Get(), other.Get() })
    {
      filter->SetIntersectionMethod(method);
      filter->SetPosition(0.3, -0.2, 1.0);
      filter->Update();
    }
    ASSERT_EQ(scan->GetOutput()->GetNumberOfPoints(), 61 * 72);
    ASSERT_EQ(other->GetOutput()->GetNumberOfPoints(), 61 * 72);
    for (vtkIdType i = 0; i < 61 * 72; ++i)
    {
      const Point normal = GetTuple(scan, "Normals", i);
      ASSERT_LT(GetLength(normal - GetTuple(other, "Normals", i)), NormalTolerance);
      ASSERT_NEAR(GetLength(normal), 1.0, NormalTolerance);
      const double cosine = vtkMath::Dot(normal.data(), GetWayToSensor(scan, i).data());
      ASSERT_GT(cosine, 0.0);
      const double incidence = GetArray(scan, "Incidence")->GetTuple1(i);
      ASSERT_NEAR(std::cos(vtkMath::RadiansFromDegrees(incidence)), cosine, 4 * NormalTolerance);
    }
  }
}

TEST(LMS3DScanSurfaceAttributes, NormalsAreOnTheSideOfTheSensorWithoutRounding)
{
#ifdef __SIZEOF_INT128__
  __extension__ using Integer = __int128;
  // The sensor's coordinates are multiples of this. The corners' are whole numbers.
  constexpr double Unit = 0x1p-43;
  Random random(1);
  int returns = 0;
  for (int trial = 0; trial < 200; ++trial)
  {
    Vector corner[3];
    for (Vector& point : corner)
    {
      std::generate(
        point.begin(), point.end(), [&random] { return std::round(random.Get(-500.0, 500.0)); });
    }
    const Vector p = corner[1] - corner[0];
    const Vector q = corner[2] - corner[0];
    Vector normal;
    vtkMath::Cross(p.data(), q.data(), normal.data());
    Vector position = corner[0] + random.Get(0.2, 0.4) * p + random.Get(0.2, 0.4) * q;
    Integer side = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      position[axis] = std::round(position[axis] / Unit) * Unit;
      side += static_cast<Integer>(normal[axis]) *
        (static_cast<Integer>(position[axis] / Unit) -
          static_cast<Integer>(corner[0][axis] / Unit));
    }
    auto scan = MakeLabelledScan(MakePolygon({ corner[0], corner[1], corner[2] }));
    SetGrid(scan, 7, 8);
    scan->SetPosition(position.data());
    scan->Update();
    for (vtkIdType i = 0; i < scan->GetOutput()->GetNumberOfPoints(); ++i, ++returns)
    {
      const Point found = GetTuple(scan, "Normals", i);
      ASSERT_EQ(vtkMath::Dot(found.data(), normal.data()) > 0.0, side > 0) << trial;
    }
  }
  EXPECT_GT(returns, 200);
#endif
}

TEST(LMS3DScanSurfaceAttributes, ANeedleHasItsNormal)
{
  // A needle 1 m long and 1e-12 m wide, in the plane z = x far from the origin.
  constexpr double Far = 1000.0;
  const Point a = { Far, -0.5, Far };
  const Point b = { Far, 0.5, Far };
  const Point c = { Far + 0x1p-40, 0.5, Far + 0x1p-40 };
  auto scan = MakeLabelledScan(MakePolygon({ a, b, c }));
  scan->SetPosition(Far, 0.5, Far + 1.0);
  scan->SetAlphaRange(-90.0, -90.0);
  SetGrid(scan, 1, 1);
  scan->Update();
  ASSERT_EQ(scan->GetOutput()->GetNumberOfPoints(), 1);
  const Point normal = GetTuple(scan, "Normals", 0);
  EXPECT_NEAR(normal[0], -std::sqrt(0.5), NormalTolerance);
  EXPECT_NEAR(normal[1], 0.0, NormalTolerance);
  EXPECT_NEAR(normal[2], std::sqrt(0.5), NormalTolerance);
  EXPECT_NEAR(GetArray(scan, "Incidence")->GetTuple1(0), 45.0, DegreeTolerance);
}

// --- Cell data ----------------------------------------------------------------------------------

TEST(LMS3DScanSurfaceAttributes, LabelsBelongToTheCellThatWasHit)
{
  auto room = ReadRoom();
  auto scan = MakeLabelledScan(room);
  scan->SetPosition(0.3, -0.2, 1.0);
  scan->Update();
  ExpectValuesOfCells(scan, room, "ShapeId");
  ExpectValuesOfCells(scan, room, "Color");
  EXPECT_GT(GetArray(scan, "ShapeId")->GetRange()[1], GetArray(scan, "ShapeId")->GetRange()[0]);
  auto* names =
    vtkStringArray::SafeDownCast(scan->GetOutput()->GetFieldData()->GetAbstractArray("ShapeNames"));
  ASSERT_NE(names, nullptr);
  EXPECT_EQ(names->GetNumberOfValues(),
    room->GetFieldData()->GetAbstractArray("ShapeNames")->GetNumberOfValues());
}

TEST(LMS3DScanSurfaceAttributes, NewLabelsAreSeenWithoutABuild)
{
  auto ball = MakeBall(1.0, 12);
  AddInts(ball, "Label", 0);
  auto scan = MakeLabelledScan(ball);
  scan->Update();
  const vtkMTimeType buildTime = scan->GetBuildTime();
  AddInts(ball, "Label", 100);
  scan->Update();
  ExpectValuesOfCells(scan, ball, "Label");
  EXPECT_GE(GetArray(scan, "Label")->GetRange()[0], 100.0);
  EXPECT_EQ(scan->GetBuildTime(), buildTime);
}

TEST(LMS3DScanSurfaceAttributes, CellsKeepTheirNumbersBesideVerticesLinesAndStrips)
{
  auto scene = Join(MakeFloor(10.0, -1.0), MakeBall(5.0, 12));
  const vtkIdType corners[4] = { 0, 1, 3, 2 };
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell(1, corners);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(2, corners);
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell(4, corners);
  scene->SetVerts(vertices);
  scene->SetLines(lines);
  scene->SetStrips(strips);
  AddInts(scene, "Label", 7);
  auto scan = MakeLabelledScan(scene);
  scan->Update();
  ExpectValuesOfCells(scan, scene, "Label");
  EXPECT_EQ(GetArray(scan, "Label")->GetRange()[0], 9.0);
}

TEST(LMS3DScanSurfaceAttributes, AVolumeGivesTheDataOfItsCells)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(5, 5, 5);
  image->SetOrigin(-2.0, -2.0, -2.0);
  AddInts(image, "Label", 0);
  auto scan = MakeLabelledScan(image);
  scan->SetPosition(0.3, 0.2, 4.0);
  scan->Update();
  EXPECT_GT(scan->GetOutput()->GetNumberOfPoints(), 100);
  ExpectValuesOfCells(scan, image, "Label");
}

TEST(LMS3DScanSurfaceAttributes, StringsArePassed)
{
  auto scene = Join(MakeFloor(10.0, -1.0), MakeFloor(10.0, 1.0));
  vtkNew<vtkStringArray> names;
  names->SetName("Name");
  names->InsertNextValue("floor");
  names->InsertNextValue("ceiling");
  scene->GetCellData()->AddArray(names);
  auto scan = MakeLabelledScan(scene);
  scan->Update();
  auto* found =
    vtkStringArray::SafeDownCast(scan->GetOutput()->GetPointData()->GetAbstractArray("Name"));
  ASSERT_NE(found, nullptr);
  ASSERT_GT(found->GetNumberOfValues(), 0);
  for (vtkIdType i = 0; i < found->GetNumberOfValues(); ++i)
  {
    const bool isFloor = GetArray(scan, "CellId")->GetTuple1(i) == 0.0;
    ASSERT_EQ(found->GetValue(i), isFloor ? "floor" : "ceiling");
  }
}

TEST(LMS3DScanSurfaceAttributes, ArraysThatMeanSomethingElseOnAScanAreLeftOut)
{
  auto ball = MakeBall(1.0, 12);
  AddInts(ball, "Range", 0);
  AddInts(ball, "Normals", 0);
  AddInts(ball, "Label", 0);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(ball->GetNumberOfCells());
  ghosts->FillValue(vtkDataSetAttributes::DUPLICATECELL);
  ball->GetCellData()->AddArray(ghosts);
  // Too short.
  vtkNew<vtkIntArray> shortArray;
  shortArray->SetName("Short");
  shortArray->InsertNextValue(1);
  ball->GetCellData()->AddArray(shortArray);
  auto scan = MakeLabelledScan(ball);
  scan->Update();
  vtkPointData* arrays = scan->GetOutput()->GetPointData();
  EXPECT_EQ(arrays->GetNumberOfArrays(), 8);
  EXPECT_EQ(arrays->GetArray("Range")->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(arrays->GetArray("Normals")->GetDataType(), VTK_FLOAT);
  EXPECT_TRUE(arrays->HasArray("Label"));
}

TEST(LMS3DScanSurfaceAttributes, GlobalIdsNameTheCells)
{
  auto ball = MakeBall(1.0, 12);
  AddInts(ball, "Label", 0);
  vtkNew<vtkIntArray> ids;
  ids->SetName("Ids");
  const int last = static_cast<int>(ball->GetNumberOfCells()) - 1;
  for (int cell = 0; cell <= last; ++cell)
  {
    ids->InsertNextValue(last - cell);
  }
  ball->GetCellData()->SetGlobalIds(ids);
  auto scan = MakeLabelledScan(ball);
  scan->Update();
  ASSERT_GT(scan->GetOutput()->GetNumberOfPoints(), 0);
  for (vtkIdType i = 0; i < scan->GetOutput()->GetNumberOfPoints(); ++i)
  {
    ASSERT_EQ(GetArray(scan, "Label")->GetTuple1(i), last - GetArray(scan, "CellId")->GetTuple1(i));
  }
  EXPECT_EQ(GetArray(scan, "Ids"), nullptr);
}

TEST(LMS3DScanSurfaceAttributes, BlocksGiveTheArraysThatAllHave)
{
  auto floor = MakeFloor(10.0, -1.0);
  auto ball = MakeBall(5.0, 12);
  AddInts(floor, "Label", 0);
  AddInts(ball, "Label", 1);
  AddInts(ball, "BallOnly", 0);
  AddInts(floor, "OtherType", 0);
  vtkNew<vtkIdTypeArray> otherType;
  otherType->SetName("OtherType");
  otherType->SetNumberOfValues(ball->GetNumberOfCells());
  ball->GetCellData()->AddArray(otherType);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, floor);
  blocks->SetBlock(1, nullptr);
  blocks->SetBlock(2, vtkNew<vtkPolyData>());
  blocks->SetBlock(3, ball);
  auto scan = MakeLabelledScan(blocks);
  scan->Update();
  vtkDataArray* labels = GetArray(scan, "Label");
  ASSERT_NE(labels, nullptr);
  // Cells are numbered through.
  EXPECT_EQ(Hash(labels),
    [scan]
    {
      vtkNew<vtkIntArray> cells;
      cells->DeepCopy(GetArray(scan, "CellId"));
      return Hash(cells);
    }());
  EXPECT_EQ(labels->GetRange()[0], 0.0);
  EXPECT_GT(labels->GetRange()[1], 0.0);
  EXPECT_EQ(GetArray(scan, "BallOnly"), nullptr);
  EXPECT_EQ(GetArray(scan, "OtherType"), nullptr);
}
