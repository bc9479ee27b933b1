// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DirectFusedMap.h"

#include "ServerProcess.h"
#include "vtkLMS3DMapFusion.h"
#include "vtkLMS3DScanFilter.h"
#include "vtkLMS3DSurfaceReconstructionFilter.h"
#include "vtkVRMLImporterSource.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cstddef>

std::vector<FusedTriangle> GetFusedTriangles(vtkPolyData* map, const LMS3D::Vector3* origin)
{
  std::vector<FusedTriangle> triangles;
  if (map->GetNumberOfCells() == 0)
  {
    return triangles;
  }
  const std::array<double, 3> start =
    origin ? std::array<double, 3>{ origin->x, origin->y, origin->z } : std::array<double, 3>{};
  vtkDataArray* const ids = map->GetCellData()->GetArray("RegionId");
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < map->GetNumberOfCells(); ++cell)
  {
    map->GetCellPoints(cell, corners);
    FusedTriangle triangle{ ids->GetTuple1(cell) };
    for (std::size_t i = 0; i < 9; ++i)
    {
      const double value = map->GetPoint(corners->GetId(static_cast<vtkIdType>(i / 3)))[i % 3];
      triangle[1 + i] = origin ? start[i % 3] + static_cast<float>(value - start[i % 3]) : value;
    }
    triangles.push_back(triangle);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

std::vector<FusedTriangle> MakeFusedTriangles(const std::string& scene,
  const LMS3D::Configuration& configuration, const std::vector<LMS3D::Pose>& poses)
{
  vtkNew<vtkVRMLImporterSource> reader;
  reader->SetFileName((std::string(LMS3D_DATA_DIR) + "/" + scene).c_str());
  vtkNew<vtkLMS3DScanFilter> scanner;
  scanner->SetInputConnection(reader->GetOutputPort());
  scanner->SetNumberOfThreads(FilterThreads);
  scanner->SetAlphaRange(configuration.alpha.start, configuration.alpha.stop);
  scanner->SetAlphaResolution(static_cast<int>(configuration.alpha.count));
  scanner->SetBetaRange(configuration.beta.start, configuration.beta.stop);
  scanner->SetBetaResolution(static_cast<int>(configuration.beta.count));
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> mapper;
  mapper->SetInputConnection(scanner->GetOutputPort());
  mapper->SetNumberOfThreads(FilterThreads);
  mapper->SetMaximumError(configuration.mapError);
  vtkNew<vtkLMS3DMapFusion> fusion;
  fusion->SetNumberOfThreads(FilterThreads);
  fusion->SetMaximumError(configuration.mapError);
  for (const LMS3D::Pose& pose : poses)
  {
    const LMS3D::Vector3& position = pose.position;
    scanner->SetPosition(position.x, position.y, position.z);
    mapper->Update();
    fusion->AddScan(mapper->GetOutput(), scanner->GetOutput());
  }
  fusion->Update();
  return GetFusedTriangles(fusion->GetOutput(), &poses.front().position);
}
