// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqLMS3DLegendUnits.h"

#include "lms3dIsRestoring.h"

#include <pqApplicationCore.h>
#include <pqDataRepresentation.h>
#include <pqScalarBarRepresentation.h>
#include <pqServerManagerModel.h>
#include <pqUndoStack.h>

#include <QTimer>

#include <vtkSMPropertyHelper.h>
#include <vtkSMProxy.h>

#include <algorithm>
#include <map>
#include <string>

namespace
{
const std::map<std::string, const char*>& GetTitles()
{
  static const std::map<std::string, const char*> titles{ { "Range", "Range (m)" },
    { "Error", "Error (m)" }, { "LargestError", "Largest Error (m)" },
    { "Alpha", "Alpha (degrees)" }, { "Beta", "Beta (degrees)" },
    { "Incidence", "Incidence (degrees)" } };
  return titles;
}

vtkSMProxy* GetColors(const pqRepresentation* shown)
{
  return vtkSMPropertyHelper(shown->getProxy(), "LookupTable", true).GetAsProxy();
}

bool ShowsLMS3D(const pqRepresentation* shown)
{
  vtkSMProxy* source = vtkSMPropertyHelper(shown->getProxy(), "Input", true).GetAsProxy();
  return source && std::string(source->GetXMLName()).rfind("LMS3D", 0) == 0;
}

void AddUnit(const pqRepresentation* legend)
{
  const vtkSMPropertyHelper title(legend->getProxy(), "Title", true);
  const char* array = title.GetAsString();
  const auto found = GetTitles().find(array ? array : "");
  const auto all =
    pqApplicationCore::instance()->getServerManagerModel()->findItems<pqDataRepresentation*>();
  const bool isUsed = std::any_of(all.begin(), all.end(),
    [&](const pqRepresentation* shown)
    { return ShowsLMS3D(shown) && GetColors(shown) == GetColors(legend); });
  if (found != GetTitles().end() && isUsed)
  {
    SCOPED_UNDO_EXCLUDE(); // no step of its own
    vtkSMPropertyHelper(legend->getProxy(), "Title", true).Set(found->second);
    legend->getProxy()->UpdateVTKObjects();
  }
}
} // namespace

//------------------------------------------------------------------------------
void pqLMS3DLegendUnits::startup()
{
  this->listen(pqApplicationCore::instance()->getServerManagerModel(),
    SIGNAL(representationAdded(pqRepresentation*)), SLOT(label(pqRepresentation*)));
}

//------------------------------------------------------------------------------
void pqLMS3DLegendUnits::label(pqRepresentation* added)
{
  if (qobject_cast<pqScalarBarRepresentation*>(added) && !lms3dIsRestoring())
  {
    // Later, because ParaView writes the title after it adds the legend.
    QTimer::singleShot(0, added, [added] { AddUnit(added); });
  }
}
