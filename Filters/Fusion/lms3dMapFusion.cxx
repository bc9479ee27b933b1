// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dMapFusion.h"

#include "Fusion/lms3dFusionChecks.h"
#include "Fusion/lms3dFusionOutput.h"
#include "Fusion/lms3dGrowingMap.h"

#include <vtkPolyData.h>

struct lms3dMapFusion::Internals
{
  const lms3dFusionSettings Settings;
  const int FirstRegion;
  const int FirstRevision;
  lms3dGrowingMap Map;
};

lms3dMapFusion::lms3dMapFusion(const lms3dFusionSettings& settings, int firstRegion, int revision)
  : Internal(new Internals{ settings, firstRegion, revision, lms3dGrowingMap(settings) })
{
}

lms3dMapFusion::~lms3dMapFusion() = default;

void lms3dMapFusion::Check(vtkPolyData* map, vtkPolyData* scan) const
{
  lms3dCheckFusionInput(map, scan, this->Internal->Settings.MaximumError);
}

bool lms3dMapFusion::Add(vtkPolyData* map, vtkPolyData* scan, const lms3dProgress& progress)
{
  return this->Internal->Map.Add(map, scan, progress);
}

int lms3dMapFusion::GetNumberOfScans() const
{
  return this->Internal->Map.GetNumberOfScans();
}

int lms3dMapFusion::GetRevision() const
{
  return this->Internal->FirstRevision + this->GetNumberOfScans();
}

int lms3dMapFusion::GetEndOfRegions() const
{
  return this->Internal->FirstRegion + static_cast<int>(this->Internal->Map.GetRegions().size());
}

const lms3dFusionSettings& lms3dMapFusion::GetSettings() const
{
  return this->Internal->Settings;
}

void lms3dMapFusion::Fill(int sinceRevision, vtkPolyData* output) const
{
  std::vector<lms3dNumberedMesh> regions;
  int region = this->Internal->FirstRegion;
  for (const lms3dFusedTile* tile : this->Internal->Map.GetRegions())
  {
    const int revision = this->Internal->FirstRevision + tile->Revision;
    if (revision > sinceRevision)
    {
      regions.push_back({ &tile->Mesh, region, revision });
    }
    ++region;
  }
  lms3dFillFusionOutput(regions, output);
  lms3dAddFusionField("NumberOfScans", { this->GetNumberOfScans() }, output);
  lms3dAddFusionField("Revision", { this->GetRevision() }, output);
  lms3dAddSensorPositions(this->Internal->Map.GetPositions(), output);
}

std::vector<int> lms3dMapFusion::GetChangedRegions(int sinceRevision) const
{
  std::vector<int> changed;
  int region = this->Internal->FirstRegion;
  for (const lms3dFusedTile* tile : this->Internal->Map.GetRegions())
  {
    if (this->Internal->FirstRevision + tile->Revision > sinceRevision)
    {
      changed.push_back(region);
    }
    ++region;
  }
  return changed;
}
