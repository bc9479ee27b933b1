// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqLMS3DEmptyScans.h"

#include <pqApplicationCore.h>
#include <pqPipelineSource.h>
#include <pqServerManagerModel.h>

#include <vtkPVDataInformation.h>
#include <vtkSMSourceProxy.h>

#include <cstring>

namespace
{
// After an error the range image is empty, too.
bool HasScanned(vtkSMSourceProxy* scan)
{
  return scan->GetDataInformation(1)->GetNumberOfPoints() > 0;
}

bool HasReturns(vtkSMSourceProxy* scan)
{
  return scan->GetDataInformation(0)->GetNumberOfPoints() > 0;
}
} // namespace

//------------------------------------------------------------------------------
void pqLMS3DEmptyScans::startup()
{
  pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
  this->listen(model, SIGNAL(dataUpdated(pqPipelineSource*)), SLOT(check(pqPipelineSource*)));
  this->listen(model, SIGNAL(preSourceRemoved(pqPipelineSource*)), SLOT(forget(pqPipelineSource*)));
}

//------------------------------------------------------------------------------
void pqLMS3DEmptyScans::check(pqPipelineSource* updated)
{
  auto* scan = vtkSMSourceProxy::SafeDownCast(updated->getProxy());
  if (!scan || std::strcmp(scan->GetXMLName(), "LMS3DScan") != 0 || !HasScanned(scan))
  {
    return;
  }
  if (HasReturns(scan))
  {
    this->Empty.remove(updated);
  }
  else if (!this->Empty.contains(updated))
  {
    this->Empty.insert(updated);
    vtkWarningWithObjectMacro(scan, << updated->getSMName().toStdString()
                                    << ": no beam returned. From its position the sensor sees no "
                                       "surface between Minimum Range and "
                                       "Maximum Range. Move the sensor, or change the ranges.");
  }
}

//------------------------------------------------------------------------------
void pqLMS3DEmptyScans::forget(pqPipelineSource* removed)
{
  this->Empty.remove(removed);
}
