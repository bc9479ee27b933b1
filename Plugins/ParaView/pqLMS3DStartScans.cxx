// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqLMS3DStartScans.h"

#include <pqApplicationCore.h>
#include <pqObjectBuilder.h>
#include <pqPipelineSource.h>

#include <vtkSMPropertyHelper.h>
#include <vtkSMProxy.h>
#include <vtkSMTrace.h>

#include <cstring>
#include <vector>

namespace
{
struct OutputPort
{
  vtkSMProxy* Source;
  unsigned int Port;
};

// Empty if one of the maps comes from another filter.
std::vector<OutputPort> GetScansOfMaps(vtkSMProxy* fusion)
{
  std::vector<OutputPort> scans;
  const vtkSMPropertyHelper maps(fusion, "Map");
  for (unsigned int i = 0; i < maps.GetNumberOfElements(); ++i)
  {
    vtkSMProxy* map = maps.GetAsProxy(i);
    if (!map || std::strcmp(map->GetXMLName(), "LMS3DSurfaceReconstruction") != 0)
    {
      return {};
    }
    const vtkSMPropertyHelper scan(map, "Input");
    scans.push_back({ scan.GetAsProxy(), scan.GetOutputPort() });
  }
  return scans;
}
} // namespace

//------------------------------------------------------------------------------
void pqLMS3DStartScans::startup()
{
  this->listen(pqApplicationCore::instance()->getObjectBuilder(),
    SIGNAL(filterCreated(pqPipelineSource*)), SLOT(addScans(pqPipelineSource*)));
}

//------------------------------------------------------------------------------
void pqLMS3DStartScans::addScans(pqPipelineSource* created)
{
  vtkSMProxy* fusion = created->getProxy();
  if (std::strcmp(fusion->GetXMLName(), "LMS3DMapFusion") != 0)
  {
    return;
  }
  SM_SCOPED_TRACE(PropertiesModified).arg("proxy", fusion);
  vtkSMPropertyHelper scans(fusion, "Scan");
  for (const OutputPort& scan : GetScansOfMaps(fusion))
  {
    scans.Add(scan.Source, scan.Port);
  }
  fusion->UpdateVTKObjects();
}
