// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/FusionFixtures.h"

#include "vtkLMS3DRangeErrorFilter.h"
#include "vtkLMS3DScanFilter.h"
#include "vtkLMS3DSurfaceReconstructionFilter.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

TriangleTree MakeTree(vtkPolyData* map, const Point& origin)
{
  std::vector<Vector> points(static_cast<std::size_t>(map->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < map->GetNumberOfPoints(); ++i)
  {
    map->GetPoint(i, points[i].data());
    for (int axis = 0; axis < 3; ++axis)
    {
      points[i][axis] -= origin[axis];
    }
  }
  std::vector<TriangleTree::Triangle> triangles;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < map->GetNumberOfPolys(); ++i)
  {
    map->GetPolys()->GetCellAtId(i, ids);
    triangles.push_back({ ids->GetId(0), ids->GetId(1), ids->GetId(2) });
  }
  return { points, triangles };
}

MappedScan MakeMappedScan(vtkPolyData* scene, const Point& position, bool isCoarse, double noise)
{
  vtkNew<vtkLMS3DScanFilter> scanner;
  scanner->SetInputData(scene);
  scanner->SetPosition(position[0], position[1], position[2]);
  scanner->SetAlphaResolution(isCoarse ? 91 : 361);
  scanner->SetBetaResolution(isCoarse ? 90 : 360);
  vtkNew<vtkLMS3DRangeErrorFilter> errors;
  errors->SetInputConnection(scanner->GetOutputPort());
  errors->SetRangeNoise(noise);
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> mapper;
  mapper->SetInputConnection(noise > 0.0 ? errors->GetOutputPort() : scanner->GetOutputPort());
  mapper->Update();
  MappedScan result;
  result.Scan = vtkSmartPointer<vtkPolyData>::New();
  result.Scan->DeepCopy(mapper->GetInput());
  result.Map = vtkSmartPointer<vtkPolyData>::New();
  result.Map->DeepCopy(mapper->GetOutput());
  return result;
}

std::vector<MappedScan> ScanRoom(bool isCoarse, double noise)
{
  const vtkSmartPointer<vtkPolyData> room = ReadRoom();
  std::vector<MappedScan> scans;
  for (const Point& position : std::vector<Point>{ { -2.0, -1.2, 1.0 }, { 2.0, -1.0, 1.4 },
         { 0.0, 0.3, 1.0 }, { -2.0, 1.2, 1.5 }, { 2.3, 1.2, 0.8 } })
  {
    scans.push_back(MakeMappedScan(room, position, isCoarse, noise));
  }
  return scans;
}

std::vector<MappedScan> ScanRoomAnywhere(int count)
{
  const vtkSmartPointer<vtkPolyData> room = ReadRoom();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  std::vector<MappedScan> scans;
  for (int i = 0; i < count; ++i)
  {
    const double x = 2.3 * share(random);
    const double y = 1.3 * share(random);
    scans.push_back(MakeMappedScan(room, { x, y, 1.2 + 0.4 * share(random) }));
  }
  return scans;
}

void Move(const Point& error, MappedScan& scan)
{
  vtkDataArray* const pose = scan.Scan->GetFieldData()->GetArray("SensorToWorld");
  for (int axis = 0; axis < 3; ++axis)
  {
    pose->SetTuple1(4 * axis + 3, pose->GetTuple1(4 * axis + 3) + error[axis]);
  }
  ScaleAndMove(scan.Scan, 1.0, error);
  ScaleAndMove(scan.Map, 1.0, error);
}

void AddAll(const std::vector<MappedScan>& scans, vtkLMS3DMapFusion* fusion)
{
  for (const MappedScan& scan : scans)
  {
    EXPECT_TRUE(fusion->AddScan(scan.Map, scan.Scan));
  }
}

vtkIdType CountTriangles(const std::vector<MappedScan>& scans)
{
  vtkIdType count = 0;
  for (const MappedScan& scan : scans)
  {
    count += scan.Map->GetNumberOfPolys();
  }
  return count;
}

FusionVerdict JudgeFusion(vtkPolyData* fused, const MappedScan& scan, double maximumError)
{
  vtkDataArray* const pose = scan.Scan->GetFieldData()->GetArray("SensorToWorld");
  const Point sensor = { pose->GetTuple1(3), pose->GetTuple1(7), pose->GetTuple1(11) };
  const TriangleTree local = MakeTree(scan.Map, sensor);
  const TriangleTree tree = MakeTree(fused, sensor);
  vtkDataArray* const ranges = scan.Scan->GetPointData()->GetArray("Range");
  FusionVerdict verdict;
  std::vector<TriangleTree::Hit> hits;
  for (vtkIdType i = 0; i < scan.Scan->GetNumberOfPoints(); ++i)
  {
    Vector point;
    scan.Scan->GetPoint(i, point.data());
    point = lms3dSubtract(point, sensor);
    if (local.GetDistance(point, 2.0 * maximumError) > maximumError)
    {
      continue;
    }
    ++verdict.Returns;
    const double distance = tree.GetDistance(point, 1.0);
    verdict.LargestDistance = std::max(verdict.LargestDistance, distance);
    verdict.Beyond += distance > maximumError ? 1 : 0;
    hits.clear();
    tree.Cast(lms3dNormalize(point), 0.0, hits);
    const auto nearest = std::min_element(hits.begin(), hits.end(),
      [](const TriangleTree::Hit& a, const TriangleTree::Hit& b) { return a.Range < b.Range; });
    const double range = ranges->GetTuple1(i);
    if (nearest == hits.end() || nearest->Range > range + maximumError)
    {
      ++verdict.Missed;
    }
    else if (nearest->Range < range - maximumError)
    {
      ++verdict.Blocked;
    }
  }
  return verdict;
}

FusionVerdict JudgeFusion(
  vtkPolyData* fused, const std::vector<MappedScan>& scans, double maximumError)
{
  FusionVerdict sum;
  for (const MappedScan& scan : scans)
  {
    const FusionVerdict verdict = JudgeFusion(fused, scan, maximumError);
    sum.Returns += verdict.Returns;
    sum.Beyond += verdict.Beyond;
    sum.LargestDistance = std::max(sum.LargestDistance, verdict.LargestDistance);
    sum.Blocked += verdict.Blocked;
    sum.Missed += verdict.Missed;
  }
  return sum;
}
