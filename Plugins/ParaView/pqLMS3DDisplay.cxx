// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqLMS3DDisplay.h"

#include "lms3dCamera.h"
#include "lms3dIsRestoring.h"
#include "lms3dOutputOf.h"
#include "lms3dRangeImageView.h"

#include <pqApplicationCore.h>
#include <pqDataRepresentation.h>
#include <pqRenderView.h>
#include <pqServerManagerModel.h>

#include <vtkDataObject.h>
#include <vtkGeometryRepresentationWithFaces.h>
#include <vtkSMPVRepresentationProxy.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMProxy.h>
#include <vtkSMTrace.h>

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
    lms3dIsOutputOf(shown, "LMS3DMapFusion", 0) || lms3dIsOutputOf(shown, "LMS3DRemote", 1);
}

// A scene, or the scan of a server, for which there is no scene.
bool IsScene(vtkSMProxy* shown)
{
  return lms3dIsOutputOf(shown, "vrmlreader", 0) || lms3dIsOutputOf(shown, "LMS3DRemote", 0);
}

Color GetColor(vtkSMProxy* shown)
{
  Color color{};
  vtkSMPropertyHelper(shown, "DiffuseColor").Get(color.data(), 3);
  return color;
}

bool ShowsSame(vtkSMProxy* one, vtkSMProxy* other)
{
  return lms3dGetSourceOf(one) == lms3dGetSourceOf(other) &&
    vtkSMPropertyHelper(one, "Input").GetOutputPort() ==
    vtkSMPropertyHelper(other, "Input").GetOutputPort();
}

// The colour that the same map has in another view, or else the first that no other map has.
Color PickMapColor(vtkSMProxy* added)
{
  std::vector<Color> used;
  const auto* model = pqApplicationCore::instance()->getServerManagerModel();
  for (pqDataRepresentation* other : model->findItems<pqDataRepresentation*>())
  {
    vtkSMProxy* shown = other->getProxy();
    if (shown == added || !IsMap(shown) || !shown->GetProperty("DiffuseColor"))
    {
      continue;
    }
    used.push_back(GetColor(shown));
    if (ShowsSame(shown, added))
    {
      return used.back();
    }
  }
  const auto isFree = [&](const Color& color)
  { return std::find(used.begin(), used.end(), color) == used.end(); };
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

// Whether the camera looks down, as it does in a new view.
bool IsCameraNew(pqView* view)
{
  const lms3dCamera camera = lms3dGetCamera(view);
  return camera.ViewUp == lms3dCamera::Vector{ 0, 1, 0 } &&
    camera.Position[0] == camera.FocalPoint[0] && camera.Position[1] == camera.FocalPoint[1] &&
    camera.Position[2] > camera.FocalPoint[2];
}
} // namespace

//------------------------------------------------------------------------------
void pqLMS3DDisplay::startup()
{
  auto* model = pqApplicationCore::instance()->getServerManagerModel();
  this->listen(
    model, SIGNAL(representationAdded(pqRepresentation*)), SLOT(color(pqRepresentation*)));
  this->listen(model, SIGNAL(viewAdded(pqView*)), SLOT(watch(pqView*)));
  for (pqView* view : model->findItems<pqView*>())
  {
    this->watch(view);
  }
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
  if (auto* view = qobject_cast<pqRenderView*>(added))
  {
    new lms3dRangeImageView(view); // The view owns it.
    this->listen(
      view, SIGNAL(representationAdded(pqRepresentation*)), SLOT(aim(pqRepresentation*)));
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
  if (lms3dIsRangeImage(shown->getProxy()))
  {
    GreyMissingReturns(shown->getProxy());
  }
  else if (IsScene(shown->getProxy()) && view->getNumberOfRepresentations() == 1 &&
    IsCameraNew(view))
  {
    lms3dTurnCamera(view, { -0.45, -0.98, 1.45 }, { 0, 0, 1 });
  }
}
