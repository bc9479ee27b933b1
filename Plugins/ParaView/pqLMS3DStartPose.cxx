// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqLMS3DStartPose.h"

#include "lms3dSensorPose.h"

#include <pqApplicationCore.h>
#include <pqObjectBuilder.h>
#include <pqPipelineSource.h>

#include <vtkBoundingBox.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMProxy.h>
#include <vtkSMTrace.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace
{
bool IsAtOrigin(vtkSMProxy* scan)
{
  return vtkSMPropertyHelper(scan, "Position").GetDoubleArray() == std::vector<double>(3, 0.0);
}
} // namespace

//------------------------------------------------------------------------------
void pqLMS3DStartPose::startup()
{
  this->listen(pqApplicationCore::instance()->getObjectBuilder(),
    SIGNAL(filterCreated(pqPipelineSource*)), SLOT(place(pqPipelineSource*)));
}

//------------------------------------------------------------------------------
void pqLMS3DStartPose::place(pqPipelineSource* created)
{
  constexpr double height = 1.0; // metres above the floor
  constexpr double steps = 1e6; // in a metre, so that the panel shows short numbers
  vtkSMProxy* scan = created->getProxy();
  if (std::strcmp(scan->GetXMLName(), "LMS3DScan") != 0 || !IsAtOrigin(scan))
  {
    return;
  }
  const vtkBoundingBox scene = lms3dGetSceneBounds(scan);
  if (!scene.IsValid())
  {
    return; // Apply was not pressed for the scene.
  }
  double position[3];
  scene.GetCenter(position);
  position[2] = std::min(position[2], scene.GetBound(4) + height);
  for (double& coordinate : position)
  {
    coordinate = std::round(coordinate * steps) / steps;
  }
  SM_SCOPED_TRACE(PropertiesModified).arg("proxy", scan);
  vtkSMPropertyHelper(scan, "Position").Set(position, 3);
  scan->UpdateVTKObjects();
}
