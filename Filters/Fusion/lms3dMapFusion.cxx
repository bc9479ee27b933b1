// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dMapFusion.h"

#include "Device/lms3dScanInput.h"
#include "Fusion/lms3dFusionChecks.h"
#include "Fusion/lms3dFusionOutput.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

struct lms3dMapFusion::Internals
{
  lms3dFusionSettings Settings;
  int FirstRegion;
  int FirstRevision;
  std::vector<lms3dFusedMesh> Regions;
  std::vector<lms3dVector> Positions;
};

lms3dMapFusion::lms3dMapFusion(const lms3dFusionSettings& settings, int firstRegion, int revision)
  : Internal(new Internals{ settings, firstRegion, revision, {}, {} })
{
}

lms3dMapFusion::~lms3dMapFusion() = default;

void lms3dMapFusion::Check(vtkPolyData* map, vtkPolyData* scan) const
{
  lms3dCheckFusionInput(map, scan, this->Internal->Settings.MaximumError);
}

bool lms3dMapFusion::Add(vtkPolyData* map, vtkPolyData* scan, const lms3dProgress& progress)
{
  const lms3dScanInput input(scan);
  const int number = this->GetNumberOfScans();
  lms3dFusedMesh mesh;
  mesh.Points.resize(static_cast<std::size_t>(map->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < map->GetNumberOfPoints(); ++i)
  {
    map->GetPoint(i, mesh.Points[i].data());
  }
  const auto cells = vtk::TakeSmartPointer(map->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    cells->GetCurrentCell(size, ids);
    mesh.Triangles.push_back({ static_cast<std::int32_t>(ids[0]), static_cast<std::int32_t>(ids[1]),
      static_cast<std::int32_t>(ids[2]) });
    mesh.Sightings.push_back({ number, 1, number });
  }
  this->Internal->Regions.push_back(mesh);
  this->Internal->Positions.push_back(
    scan->GetNumberOfPoints() > 0 ? input.GetSensorPosition() : lms3dVector{});
  return progress(1.0);
}

int lms3dMapFusion::GetNumberOfScans() const
{
  return static_cast<int>(this->Internal->Positions.size());
}

int lms3dMapFusion::GetRevision() const
{
  return this->Internal->FirstRevision + this->GetNumberOfScans();
}

int lms3dMapFusion::GetEndOfRegions() const
{
  return this->Internal->FirstRegion + static_cast<int>(this->Internal->Regions.size());
}

const lms3dFusionSettings& lms3dMapFusion::GetSettings() const
{
  return this->Internal->Settings;
}

void lms3dMapFusion::Fill(int sinceRevision, vtkPolyData* output) const
{
  std::vector<lms3dNumberedMesh> regions;
  const int count = static_cast<int>(this->Internal->Regions.size());
  for (int i = 0; i < count; ++i)
  {
    const int revision = this->Internal->FirstRevision + i + 1;
    if (revision > sinceRevision)
    {
      regions.push_back({ &this->Internal->Regions[i], this->Internal->FirstRegion + i, revision });
    }
  }
  lms3dFillFusionOutput(regions, output);
  lms3dAddFusionField("NumberOfScans", { this->GetNumberOfScans() }, output);
  lms3dAddFusionField("Revision", { this->GetRevision() }, output);
  lms3dAddSensorPositions(this->Internal->Positions, output);
}

std::vector<int> lms3dMapFusion::GetChangedRegions(int sinceRevision) const
{
  std::vector<int> changed;
  const int count = static_cast<int>(this->Internal->Regions.size());
  for (int i = 0; i < count; ++i)
  {
    if (this->Internal->FirstRevision + i + 1 > sinceRevision)
    {
      changed.push_back(this->Internal->FirstRegion + i);
    }
  }
  return changed;
}
