// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqLMS3DMapColor.h"

#include <pqApplicationCore.h>
#include <pqRepresentation.h>
#include <pqServerManagerModel.h>
#include <pqUndoStack.h>

#include <vtkDataObject.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMProxy.h>
#include <vtkSMTrace.h>

#include <cstring>

namespace
{
// Reads the proxies, because the Qt classes do not have the input yet.
bool IsMap(vtkSMProxy* shown)
{
  vtkSMProxy* source = vtkSMPropertyHelper(shown, "Input", true).GetAsProxy();
  return source && !std::strcmp(source->GetXMLName(), "LMS3DSurfaceReconstruction");
}

// A representation from a state, undo or redo has its colours already.
bool IsRestoring()
{
  pqApplicationCore* core = pqApplicationCore::instance();
  const pqUndoStack* stack = core->getUndoStack();
  return core->isLoadingState() || (stack && (stack->getInUndo() || stack->getInRedo()));
}
} // namespace

//------------------------------------------------------------------------------
pqLMS3DMapColor::pqLMS3DMapColor(QObject* parentObject)
  : Superclass(parentObject)
{
}

//------------------------------------------------------------------------------
void pqLMS3DMapColor::startup()
{
  this->connect(pqApplicationCore::instance()->getServerManagerModel(),
    SIGNAL(representationAdded(pqRepresentation*)), SLOT(color(pqRepresentation*)));
}

//------------------------------------------------------------------------------
void pqLMS3DMapColor::shutdown()
{
  QObject::disconnect(
    pqApplicationCore::instance()->getServerManagerModel(), nullptr, this, nullptr);
}

//------------------------------------------------------------------------------
void pqLMS3DMapColor::color(pqRepresentation* added)
{
  vtkSMProxy* shown = added->getProxy();
  if (IsRestoring() || !IsMap(shown))
  {
    return;
  }
  if (!shown->GetProperty("DiffuseColor"))
  {
    return; // a view without surfaces, such as the spreadsheet
  }
  const double green[3] = { 0.2, 0.7, 0.3 };
  SM_SCOPED_TRACE(PropertiesModified).arg("proxy", shown);
  vtkSMPropertyHelper(shown, "ColorArrayName", true)
    .SetInputArrayToProcess(vtkDataObject::FIELD_ASSOCIATION_POINTS, "");
  vtkSMPropertyHelper(shown, "AmbientColor", true).Set(green, 3);
  vtkSMPropertyHelper(shown, "DiffuseColor").Set(green, 3);
  shown->UpdateVTKObjects();
}
