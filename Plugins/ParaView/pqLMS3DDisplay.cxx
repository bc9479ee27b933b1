// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqLMS3DDisplay.h"

#include "lms3dIsRestoring.h"
#include "lms3dOutputOf.h"

#include <pqApplicationCore.h>
#include <pqDataRepresentation.h>
#include <pqRenderView.h>
#include <pqServerManagerModel.h>
#include <pqUndoStack.h>

#include <QTimer>

#include <vtkDataObject.h>
#include <vtkGeometryRepresentationWithFaces.h>
#include <vtkMath.h>
#include <vtkPVRenderView.h>
#include <vtkSMPVRepresentationProxy.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMProxy.h>
#include <vtkSMTrace.h>
#include <vtkSMViewProxy.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace
{
using Color = std::array<double, 3>;

constexpr std::array<Color, 4> MapColors{ { { 0.2, 0.7, 0.3 }, { 0.9, 0.55, 0.15 },
  { 0.3, 0.55, 0.9 }, { 0.75, 0.4, 0.75 } } };

bool IsMap(vtkSMProxy* shown)
{
  return lms3dIsOutputOf(shown, "LMS3DSurfaceReconstruction", 0) ||
    lms3dIsOutputOf(shown, "LMS3DRemote", 1);
}

// A scene, or the scan of a server, for which there is no scene.
bool IsScene(vtkSMProxy* shown)
{
  return lms3dIsOutputOf(shown, "vrmlreader", 0) || lms3dIsOutputOf(shown, "LMS3DRemote", 0);
}

bool IsRangeImage(vtkSMProxy* shown)
{
  return lms3dIsOutputOf(shown, "LMS3DScan", 1);
}

std::vector<double> GetValues(vtkSMProxy* proxy, const char* property)
{
  return vtkSMPropertyHelper(proxy, property, true).GetDoubleArray();
}

// The first colour that no other map has.
Color PickMapColor(vtkSMProxy* added)
{
  std::vector<std::vector<double>> used;
  const auto* model = pqApplicationCore::instance()->getServerManagerModel();
  for (pqDataRepresentation* other : model->findItems<pqDataRepresentation*>())
  {
    vtkSMProxy* shown = other->getProxy();
    if (shown != added && IsMap(shown))
    {
      used.push_back(GetValues(shown, "DiffuseColor"));
    }
  }
  const auto isFree = [&](const Color& color)
  {
    return std::find(used.begin(), used.end(), std::vector<double>(color.begin(), color.end())) ==
      used.end();
  };
  const auto* found = std::find_if(MapColors.begin(), MapColors.end(), isFree);
  return found == MapColors.end() ? MapColors[used.size() % MapColors.size()] : *found;
}

// Lets one look into a closed room from outside.
void OpenRoom(vtkSMProxy* shown)
{
  constexpr double ambient = 0.3; // ParaView's lights leave walls dark that are seen from above.
  vtkSMPropertyHelper(shown, "Ambient", true).Set(ambient);
  vtkSMPropertyHelper(shown, "Diffuse", true).Set(1 - ambient);
  vtkSMPropertyHelper(shown, "BackfaceRepresentation", true)
    .Set(vtkGeometryRepresentationWithFaces::CULL_BACKFACE);
}

void ColorMap(vtkSMProxy* shown)
{
  const Color color = PickMapColor(shown);
  SM_SCOPED_TRACE(PropertiesModified).arg("proxy", shown);
  vtkSMPropertyHelper(shown, "ColorArrayName", true)
    .SetInputArrayToProcess(vtkDataObject::FIELD_ASSOCIATION_POINTS, "");
  vtkSMPropertyHelper(shown, "AmbientColor", true).Set(color.data(), 3);
  vtkSMPropertyHelper(shown, "DiffuseColor").Set(color.data(), 3);
  OpenRoom(shown);
  shown->UpdateVTKObjects();
}

void ColorErrors(vtkSMProxy* shown)
{
  SM_SCOPED_TRACE(PropertiesModified).arg("proxy", shown);
  if (auto* display = vtkSMPVRepresentationProxy::SafeDownCast(shown))
  {
    display->SetScalarColoring("LargestError", vtkDataObject::CELL);
    display->RescaleTransferFunctionToDataRange("LargestError", vtkDataObject::CELL);
  }
  OpenRoom(shown);
  shown->UpdateVTKObjects();
}

// Beams without a return have NaN.
void GreyMissingReturns(vtkSMProxy* shown)
{
  vtkSMProxy* colors = vtkSMPropertyHelper(shown, "LookupTable", true).GetAsProxy();
  if (colors)
  {
    const Color grey{ 0.5, 0.5, 0.5 };
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", colors);
    vtkSMPropertyHelper(colors, "NanColor", true).Set(grey.data(), 3);
    colors->UpdateVTKObjects();
  }
}

// Puts the camera in the direction `from`, seen from the point that it looks at.
void TurnCamera(vtkSMProxy* view, const Color& from, const Color& up)
{
  const std::vector<double> focus = GetValues(view, "CameraFocalPoint");
  double position[3];
  vtkMath::Add(focus.data(), from.data(), position);
  vtkSMPropertyHelper(view, "CameraPosition").Set(position, 3);
  vtkSMPropertyHelper(view, "CameraViewUp").Set(up.data(), 3);
  view->UpdateVTKObjects();
}

// Whether the camera looks down, as it does in a new view.
bool IsCameraNew(vtkSMProxy* view)
{
  const std::vector<double> position = GetValues(view, "CameraPosition");
  const std::vector<double> focus = GetValues(view, "CameraFocalPoint");
  return GetValues(view, "CameraViewUp") == std::vector<double>{ 0, 1, 0 } &&
    position[0] == focus[0] && position[1] == focus[1] && position[2] > focus[2];
}

// The elevation, along x, upwards; the platform angle, along y, to the right.
void StandUpright(pqView* view)
{
  SCOPED_UNDO_EXCLUDE(); // no step of its own
  vtkSMProxy* proxy = view->getProxy();
  vtkSMPropertyHelper(proxy, "InteractionMode").Set(vtkPVRenderView::INTERACTION_MODE_2D);
  TurnCamera(proxy, { 0, 0, -1 }, { 1, 0, 0 });
  view->resetDisplay();
  view->render();
}
} // namespace

//------------------------------------------------------------------------------
pqLMS3DDisplay::pqLMS3DDisplay(QObject* parentObject)
  : Superclass(parentObject)
{
}

//------------------------------------------------------------------------------
void pqLMS3DDisplay::startup()
{
  auto* model = pqApplicationCore::instance()->getServerManagerModel();
  this->connect(
    model, SIGNAL(representationAdded(pqRepresentation*)), SLOT(color(pqRepresentation*)));
  this->connect(model, SIGNAL(viewAdded(pqView*)), SLOT(watch(pqView*)));
  for (pqView* view : model->findItems<pqView*>())
  {
    this->watch(view);
  }
}

//------------------------------------------------------------------------------
void pqLMS3DDisplay::shutdown()
{
  QObject::disconnect(
    pqApplicationCore::instance()->getServerManagerModel(), nullptr, this, nullptr);
}

//------------------------------------------------------------------------------
void pqLMS3DDisplay::color(pqRepresentation* added)
{
  vtkSMProxy* shown = added->getProxy();
  if (lms3dIsRestoring() || !shown->GetProperty("DiffuseColor"))
  {
    return; // also for a view without surfaces, such as the spreadsheet
  }
  if (IsMap(shown))
  {
    ColorMap(shown);
  }
  else if (lms3dIsOutputOf(shown, "LMS3DMapComparison", 0))
  {
    ColorErrors(shown);
  }
}

//------------------------------------------------------------------------------
void pqLMS3DDisplay::watch(pqView* added)
{
  if (qobject_cast<pqRenderView*>(added))
  {
    this->connect(
      added, SIGNAL(representationAdded(pqRepresentation*)), SLOT(aim(pqRepresentation*)));
  }
}

//------------------------------------------------------------------------------
void pqLMS3DDisplay::aim(pqRepresentation* shown)
{
  auto* view = qobject_cast<pqView*>(this->sender());
  if (!view || lms3dIsRestoring())
  {
    return;
  }
  if (IsRangeImage(shown->getProxy()))
  {
    GreyMissingReturns(shown->getProxy());
    // Later, because ParaView sets the camera, too.
    QTimer::singleShot(0, view,
      [view]
      {
        if (view->getNumberOfVisibleDataRepresentations() == 1)
        {
          StandUpright(view);
        }
      });
  }
  else if (IsScene(shown->getProxy()) && view->getNumberOfRepresentations() == 1 &&
    IsCameraNew(view->getProxy()))
  {
    TurnCamera(view->getProxy(), { -0.45, -0.98, 1.45 }, { 0, 0, 1 });
  }
}
