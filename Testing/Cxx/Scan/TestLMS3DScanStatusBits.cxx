// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief ComputeStatus changes no return, also where MaximumRange is the range of a return, and
 * where surfaces coincide.
 */
#include "Fixtures/MeshFixtures.h"
#include "Fixtures/SceneBuilder.h"
#include "Scan/DetectionFixtures.h"

#include <vtkImageData.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace
{
struct Scene
{
  std::string Name;
  vtkSmartPointer<vtkPolyData> Surface;
  Vector Position;
};

/// Two walls of different triangles in one plane.
vtkSmartPointer<vtkPolyData> MakeCoincidentWalls()
{
  SceneBuilder walls;
  walls.AddQuad({ 4.1, -3.0, -3.0 }, { 4.1, 3.0, -3.0 }, { 3.3, 3.0, 3.0 }, { 3.3, -3.0, 3.0 });
  walls.AddQuad({ 4.1, 3.0, -3.0 }, { 3.3, 3.0, 3.0 }, { 3.3, -3.0, 3.0 }, { 4.1, -3.0, -3.0 });
  return walls.GetSurface();
}

std::vector<Scene> MakeScenes()
{
  auto far = ReadRoom();
  ScaleAndMove(far, 1.0, { 1e6, -1e6, 1e5 });
  return {
    { "room", ReadRoom(), { 0.3, -0.2, 1.0 } },
    { "far room", far, { 1e6 + 0.3, -1e6 - 0.2, 1e5 + 1.0 } },
    { "ball", MakeBall(1.0, 24), { 0.1, 0.2, -0.3 } },
    { "blocks", MakeSurface(MakeBlocks()), { 0.5, 0.5, 5.0 } },
    { "cube", MakeSurface(MakeCube(8)), { 0.0, 0.0, 0.0 } },
    { "needles", MakeSurface(MakeNeedleWall(1e5)), { 0.0, -2.0, 0.5 } },
    { "coincident", MakeCoincidentWalls(), { 0.0, 0.0, 0.0 } },
    { "open", Join(MakeFloor(3.0, -1.5), MakeFloor(2.0, 2.5)), { 0.0, 0.0, 0.0 } },
  };
}

vtkSmartPointer<vtkLMS3DScanFilter> MakeScanOf(const Scene& scene, int method)
{
  auto scan = MakeScan(scene.Surface);
  scan->SetPosition(scene.Position.data());
  scan->SetIntersectionMethod(method);
  scan->SetMaximumRange(std::numeric_limits<double>::infinity());
  // The methods beyond Fast are slow.
  const bool isSlow = method > vtkLMS3DScanFilter::FAST;
  SetGrid(scan, isSlow ? 11 : 37, isSlow ? 10 : 36);
  return scan;
}

/// Ranges of some returns, numbers beside them, and numbers without a meaning.
std::vector<double> ChooseLimits(vtkLMS3DScanFilter* scan)
{
  constexpr int Chosen = 3;
  std::vector<double> limits = { 2.0, 1e3 };
  scan->Update();
  const vtkIdType count = scan->GetOutput()->GetNumberOfPoints();
  for (int i = 0; i < Chosen && count > 0; ++i)
  {
    const double range = GetRange(scan, (2 * i + 1) * count / (2 * Chosen));
    const double infinity = std::numeric_limits<double>::infinity();
    limits.insert(limits.end(),
      { range, std::nextafter(range, 0.0), std::nextafter(range, infinity), range * (1.0 + 5e-13),
        range * (1.0 - 5e-13) });
  }
  return limits;
}

void ExpectSameReturns(vtkLMS3DScanFilter* scan, const std::string& where)
{
  scan->ComputeStatusOff();
  ASSERT_EQ(UpdateAndGetError(scan), "");
  const std::uint64_t points = Hash(scan->GetOutput());
  const std::uint64_t ranges = Hash(scan->GetRangeImage()->GetPointData()->GetArray("Range"));
  const vtkIdType returns = scan->GetOutput()->GetNumberOfPoints();
  scan->ComputeStatusOn();
  ASSERT_EQ(UpdateAndGetError(scan), "");
  ASSERT_EQ(Hash(scan->GetOutput()), points) << where;
  vtkDataArray* image = scan->GetRangeImage()->GetPointData()->GetArray("Range");
  ASSERT_EQ(Hash(image), ranges) << where;
  const std::vector<int> status = GetStatus(scan);
  vtkIdType found = 0;
  for (std::size_t beam = 0; beam < status.size(); ++beam)
  {
    const bool isReturn = !std::isnan(image->GetTuple1(static_cast<vtkIdType>(beam)));
    ASSERT_EQ(status[beam] == vtkLMS3DScanFilter::RETURN, isReturn) << where << ", " << beam;
    ASSERT_NE(status[beam], vtkLMS3DScanFilter::TOO_WEAK);
    found += isReturn ? 1 : 0;
  }
  ASSERT_EQ(found, returns);
}
} // namespace

TEST(LMS3DScanStatusBits, ReturnsAreTheSameWithAndWithoutStatus)
{
  for (const Scene& scene : MakeScenes())
  {
    for (int method = 0; method < vtkLMS3DScanFilter::GetNumberOfIntersectionMethods(); ++method)
    {
      auto scan = MakeScanOf(scene, method);
      for (double limit : ChooseLimits(scan))
      {
        const std::string where = scene.Name + ", " +
          vtkLMS3DScanFilter::GetIntersectionMethodName(method) + ", " + std::to_string(limit);
        scan->SetMinimumRange(0.0);
        scan->SetMaximumRange(limit);
        ASSERT_NO_FATAL_FAILURE(ExpectSameReturns(scan, where));
        scan->SetMinimumRange(limit);
        scan->SetMaximumRange(std::numeric_limits<double>::infinity());
        ASSERT_NO_FATAL_FAILURE(ExpectSameReturns(scan, where + " as minimum"));
      }
    }
  }
}

TEST(LMS3DScanStatusBits, ARangeThatIsTheMaximumIsAReturn)
{
  auto scan = MakeScan(ReadRoom());
  scan->SetPosition(0.3, -0.2, 1.0);
  SetGrid(scan, 37, 36);
  scan->ComputeStatusOn();
  scan->Update();
  const vtkIdType count = scan->GetOutput()->GetNumberOfPoints();
  ASSERT_EQ(count, 37 * 36);
  for (vtkIdType beam = 5; beam < count; beam += 101)
  {
    scan->SetMaximumRange(80.0);
    scan->Update();
    const double range = GetRange(scan, beam);
    scan->SetMaximumRange(range);
    scan->Update();
    EXPECT_EQ(GetStatus(scan)[beam], vtkLMS3DScanFilter::RETURN);
    EXPECT_EQ(scan->GetRangeImage()->GetPointData()->GetArray("Range")->GetTuple1(beam), range);
    scan->SetMaximumRange(std::nextafter(range, 0.0));
    scan->Update();
    EXPECT_EQ(GetStatus(scan)[beam], vtkLMS3DScanFilter::BEYOND_RANGE);
  }
}
