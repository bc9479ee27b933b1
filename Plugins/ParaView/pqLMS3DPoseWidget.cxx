// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqLMS3DPoseWidget.h"

#include <pqCoreUtilities.h>
#include <pqView.h>

#include <QCheckBox>

#include <vtkAxesActor.h>
#include <vtkBoundingBox.h>
#include <vtkCommand.h>
#include <vtkPVDataInformation.h>
#include <vtkPVRenderView.h>
#include <vtkRenderer.h>
#include <vtkSMNewWidgetRepresentationProxy.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMSourceProxy.h>
#include <vtkSMViewProxy.h>
#include <vtkTransform.h>

namespace
{
// Half the width of the box, metres: large enough to be dragged in a hall, small enough not to hide a
// room.
double GetHalfWidth(vtkSMProxy* scan)
{
  constexpr double share = 0.02; // of the scene's diagonal
  constexpr double withoutScene = 0.25;
  const vtkSMPropertyHelper input(scan, "Input", true);
  auto* scene = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  if (!scene)
  {
    return withoutScene;
  }
  const vtkBoundingBox bounds(scene->GetDataInformation(input.GetOutputPort())->GetBounds());
  return bounds.IsValid() && bounds.GetDiagonalLength() > 0 ? share * bounds.GetDiagonalLength()
                                                            : withoutScene;
}
} // namespace

//------------------------------------------------------------------------------
pqLMS3DPoseWidget::pqLMS3DPoseWidget(
  vtkSMProxy* smproxy, vtkSMPropertyGroup* group, QWidget* parentWidget)
  : Superclass(smproxy, group, parentWidget, true)
{
  this->Frame->AxisLabelsOff();
  this->Frame->PickableOff();
  this->pqLMS3DPoseWidget::placeWidget();
  this->hideBoundsControls();
  this->followPose();
  this->connect(this, SIGNAL(widgetVisibilityUpdated(bool)), SLOT(showFrame(bool)));
  this->followTrajectory();
}

//------------------------------------------------------------------------------
pqLMS3DPoseWidget::~pqLMS3DPoseWidget()
{
  this->removeFrame();
}

//------------------------------------------------------------------------------
void pqLMS3DPoseWidget::placeWidget()
{
  const double half = GetHalfWidth(this->proxy());
  const double bounds[6] = { -half, half, -half, half, -half, half };
  vtkSMProxy* box = this->widgetProxy();
  vtkSMPropertyHelper(box, "UseReferenceBounds").Set(1);
  vtkSMPropertyHelper(box, "ReferenceBounds").Set(bounds, 6);
  vtkSMPropertyHelper(box, "PlaceWidget").Set(bounds, 6);
  box->UpdateVTKObjects();
  this->Frame->SetTotalLength(3 * half, 3 * half, 3 * half); // longer than the box
}

//------------------------------------------------------------------------------
QCheckBox* pqLMS3DPoseWidget::getShowBox() const
{
  return this->findChild<QCheckBox*>("show3DWidget");
}

//------------------------------------------------------------------------------
// Hides the controls that fit the box to the bounds of the input.
void pqLMS3DPoseWidget::hideBoundsControls()
{
  if (QCheckBox* shown = this->getShowBox())
  {
    shown->setText(tr("Show Sensor"));
  }
  for (const char* name : { "resetBounds", "visibleBoundsOnly" })
  {
    if (auto* widget = this->findChild<QWidget*>(name))
    {
      widget->hide();
    }
  }
}

//------------------------------------------------------------------------------
void pqLMS3DPoseWidget::followPose()
{
  for (const char* name : { "Position", "Rotation" })
  {
    pqCoreUtilities::connect(
      this->widgetProxy()->GetProperty(name), vtkCommand::ModifiedEvent, this, SLOT(moveFrame()));
  }
  this->moveFrame();
}

//------------------------------------------------------------------------------
void pqLMS3DPoseWidget::followTrajectory()
{
  pqCoreUtilities::connect(this->proxy()->GetProperty("Trajectory"), vtkCommand::ModifiedEvent,
    this, SLOT(updateWidgetVisibility()));
  this->pqLMS3DPoseWidget::updateWidgetVisibility();
}

//------------------------------------------------------------------------------
bool pqLMS3DPoseWidget::hasTrajectory() const
{
  return vtkSMPropertyHelper(this->proxy(), "Trajectory").GetAsProxy() != nullptr;
}

//------------------------------------------------------------------------------
// Hides the box while there is a trajectory. Keeps the user's choice for the time after it.
void pqLMS3DPoseWidget::updateWidgetVisibility()
{
  const bool wanted = this->WidgetVisibility;
  const bool possible = !this->hasTrajectory();
  this->WidgetVisibility = wanted && possible;
  this->Superclass::updateWidgetVisibility();
  this->WidgetVisibility = wanted;
  if (QCheckBox* shown = this->getShowBox())
  {
    shown->setEnabled(possible);
  }
}

//------------------------------------------------------------------------------
// Keeps the user's choice. ParaView cannot distinguish a box hidden by a trajectory from a box hidden
// by the user.
void pqLMS3DPoseWidget::hideEvent(QHideEvent* event)
{
  const bool wanted = this->WidgetVisibility;
  this->Superclass::hideEvent(event);
  this->VisibleState = wanted;
}

//------------------------------------------------------------------------------
void pqLMS3DPoseWidget::moveFrame()
{
  double position[3];
  double rotation[3];
  vtkSMPropertyHelper(this->widgetProxy(), "Position").Get(position, 3);
  vtkSMPropertyHelper(this->widgetProxy(), "Rotation").Get(rotation, 3);
  vtkNew<vtkTransform> pose;
  pose->Translate(position);
  pose->RotateZ(rotation[2]);
  pose->RotateX(rotation[0]);
  pose->RotateY(rotation[1]);
  this->Frame->SetUserTransform(pose);
}

//------------------------------------------------------------------------------
// Uses the renderer of ParaView's widgets, which draws on the client even if a server renders.
void pqLMS3DPoseWidget::showFrame(bool visible)
{
  this->removeFrame();
  if (!visible || !this->view())
  {
    return;
  }
  auto* shown = vtkPVRenderView::SafeDownCast(this->view()->getViewProxy()->GetClientSideObject());
  if (shown)
  {
    this->Renderer = shown->GetNonCompositedRenderer();
    this->Renderer->AddActor(this->Frame);
    this->render();
  }
}

//------------------------------------------------------------------------------
void pqLMS3DPoseWidget::removeFrame()
{
  if (this->Renderer)
  {
    this->Renderer->RemoveActor(this->Frame);
  }
  this->Renderer = nullptr;
}
