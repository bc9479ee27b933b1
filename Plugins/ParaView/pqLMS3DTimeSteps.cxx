// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqLMS3DTimeSteps.h"

#include <pqApplicationCore.h>
#include <pqPipelineSource.h>
#include <pqServerManagerModel.h>

#include <vtkSMAnimationSceneProxy.h>
#include <vtkSMParaViewPipelineController.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMSourceProxy.h>
#include <vtkSMTrace.h>

#include <cstring>
#include <vector>

namespace
{
std::vector<double> GetTimes(vtkSMProxy* scan)
{
  return vtkSMPropertyHelper(scan, "TimestepValues").GetDoubleArray();
}

// Sets the times of the animation, as ParaView does for a new reader.
void UpdateAnimation(vtkSMProxy* scan)
{
  vtkNew<vtkSMParaViewPipelineController> controller;
  vtkSMProxy* scene = controller->GetAnimationScene(scan->GetSession());
  SM_SCOPED_TRACE(CallMethod).arg(scene).arg("UpdateAnimationUsingDataTimeSteps");
  vtkSMAnimationSceneProxy::UpdateAnimationUsingDataTimeSteps(scene);
}
} // namespace

//------------------------------------------------------------------------------
void pqLMS3DTimeSteps::startup()
{
  this->listen(pqApplicationCore::instance()->getServerManagerModel(),
    SIGNAL(dataUpdated(pqPipelineSource*)), SLOT(updateTimeSteps(pqPipelineSource*)));
}

//------------------------------------------------------------------------------
void pqLMS3DTimeSteps::updateTimeSteps(pqPipelineSource* updated)
{
  auto* scan = vtkSMSourceProxy::SafeDownCast(updated->getProxy());
  if (!scan || std::strcmp(scan->GetXMLName(), "LMS3DScan") != 0)
  {
    return;
  }
  const std::vector<double> before = GetTimes(scan);
  scan->UpdatePipelineInformation();
  if (GetTimes(scan) != before)
  {
    SM_SCOPED_TRACE(CallMethod).arg(scan).arg("UpdatePipelineInformation");
    UpdateAnimation(scan);
  }
}
