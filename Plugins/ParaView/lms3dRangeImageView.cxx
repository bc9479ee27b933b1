// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dRangeImageView.h"

#include "lms3dOutputOf.h"

#include <pqApplicationCore.h>
#include <pqCoreUtilities.h>
#include <pqRenderView.h>
#include <pqRepresentation.h>
#include <pqUndoStack.h>

#include <QTimer>

#include <vtkCommand.h>
#include <vtkPVRenderView.h>
#include <vtkSMProperty.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMProxy.h>

#include <cmath>

namespace
{
// The elevation, along x, upwards; the platform angle, along y, to the right.
constexpr lms3dCamera::Vector Below{ 0, 0, -1 };
constexpr lms3dCamera::Vector Upwards{ 1, 0, 0 };

bool AreEqual(const lms3dCamera& one, const lms3dCamera& other)
{
  return one.Position == other.Position && one.FocalPoint == other.FocalPoint &&
    one.ViewUp == other.ViewUp;
}

// Whether the camera is the one of standUpright(), which the user may have moved in the image's
// plane.
bool IsUpright(const lms3dCamera& camera)
{
  constexpr double tolerance = 1e-6;
  const lms3dCamera::Vector& focus = camera.FocalPoint;
  const double distance = focus[2] - camera.Position[2];
  return camera.InteractionMode == vtkPVRenderView::INTERACTION_MODE_2D && distance > 0 &&
    std::hypot(camera.Position[0] - focus[0], camera.Position[1] - focus[1]) <
    tolerance * distance &&
    camera.ViewUp[0] > 1 - tolerance;
}
} // namespace

//------------------------------------------------------------------------------
lms3dRangeImageView::lms3dRangeImageView(pqRenderView* view)
  : Superclass(view)
  , View(view)
{
  this->connect(
    view, SIGNAL(representationAdded(pqRepresentation*)), SLOT(watch(pqRepresentation*)));
  this->connect(view, SIGNAL(representationRemoved(pqRepresentation*)), SLOT(update()));
  pqCoreUtilities::connect(
    view->getProxy(), vtkCommand::ResetCameraEvent, this, SLOT(noteCamera()));
}

//------------------------------------------------------------------------------
// Listens to the property, because the signal of the view comes after ParaView has changed the
// camera.
void lms3dRangeImageView::watch(pqRepresentation* added)
{
  if (lms3dIsRangeImage(added->getProxy()))
  {
    pqCoreUtilities::connect(added->getProxy()->GetProperty("Visibility"),
      vtkCommand::ModifiedEvent, this, SLOT(update()));
    this->update();
  }
}

//------------------------------------------------------------------------------
void lms3dRangeImageView::update()
{
  const bool isShown = lms3dShows(this->View, lms3dIsRangeImage);
  if (!this->IsShown && isShown && !pqApplicationCore::instance()->isLoadingState())
  {
    this->IsShown = true;
    this->Former = this->Expected = lms3dGetCamera(this->View);
    // Later, because ParaView sets the camera, too.
    QTimer::singleShot(0, this, SLOT(standUpright()));
  }
  else if (this->IsShown && !isShown)
  {
    this->IsShown = false;
    if (IsUpright(lms3dGetCamera(this->View)))
    {
      SCOPED_UNDO_EXCLUDE(); // no step of its own
      lms3dSetCamera(this->View, this->Former);
      this->View->render();
    }
  }
}

//------------------------------------------------------------------------------
void lms3dRangeImageView::noteCamera()
{
  this->Expected = lms3dGetCamera(this->View);
}

//------------------------------------------------------------------------------
void lms3dRangeImageView::standUpright()
{
  if (!this->IsShown || this->View->getNumberOfVisibleDataRepresentations() != 1 ||
    !AreEqual(lms3dGetCamera(this->View), this->Expected))
  {
    return;
  }
  SCOPED_UNDO_EXCLUDE(); // no step of its own
  vtkSMPropertyHelper(this->View->getProxy(), "InteractionMode")
    .Set(vtkPVRenderView::INTERACTION_MODE_2D);
  lms3dTurnCamera(this->View, Below, Upwards);
  this->View->resetDisplay();
  this->View->render();
}
