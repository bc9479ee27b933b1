// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqLMS3DPoseWidget.h"

#include "lms3dOutputOf.h"
#include "lms3dPoseControls.h"
#include "lms3dSensorPose.h"

#include <pqApplicationCore.h>
#include <pqCoreUtilities.h>
#include <pqPVApplicationCore.h>
#include <pqPipelineSource.h>
#include <pqPointPickingHelper.h>
#include <pqServerManagerModel.h>
#include <pqUndoStack.h>
#include <pqView.h>

#include <QCheckBox>
#include <QTimer>

#include <vtkCommand.h>
#include <vtkPVGeneralSettings.h>
#include <vtkSMNewWidgetRepresentationProxy.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMViewProxy.h>
#include <vtkTransform.h>

//------------------------------------------------------------------------------
pqLMS3DPoseWidget::pqLMS3DPoseWidget(
  vtkSMProxy* smproxy, vtkSMPropertyGroup* group, QWidget* parentWidget)
  : Superclass(smproxy, group, parentWidget, true)
  , Drag(this->widgetProxy()->GetWidget())
{
  this->pqLMS3DPoseWidget::placeWidget();
  lms3dStyleBox(this->widgetProxy()->GetRepresentationProxy());
  lms3dArrangePoseControls(this);
  this->pickByKeys();
  this->followPose();
  this->followTrajectory();
  this->connect(this, SIGNAL(startInteraction()), SLOT(beginDrag()));
  this->connect(this, SIGNAL(endInteraction()), SLOT(endDrag()));
}

//------------------------------------------------------------------------------
pqLMS3DPoseWidget::~pqLMS3DPoseWidget()
{
  if (this->InUndoStep)
  {
    END_UNDO_SET();
  }
}

//------------------------------------------------------------------------------
void pqLMS3DPoseWidget::placeWidget()
{
  const double half = lms3dGetHandleHalfWidth(this->proxy());
  const double bounds[6] = { -half, half, -half, half, -half, half };
  vtkSMProxy* box = this->widgetProxy();
  vtkSMPropertyHelper(box, "UseReferenceBounds").Set(1);
  vtkSMPropertyHelper(box, "ReferenceBounds").Set(bounds, 6);
  vtkSMPropertyHelper(box, "PlaceWidget").Set(bounds, 6);
  box->UpdateVTKObjects();
  this->Axes.SetLength(3 * half); // longer than the box
}

//------------------------------------------------------------------------------
void pqLMS3DPoseWidget::pickByKeys()
{
  const auto pick = [this](const QString& keys, const char* slot)
  {
    auto* helper = new pqPointPickingHelper(QKeySequence(keys), false, this);
    helper->connect(this, SIGNAL(viewChanged(pqView*)), SLOT(setView(pqView*)));
    this->connect(helper, SIGNAL(pick(double, double, double)), slot);
  };
  pick("P", SLOT(moveOver(double, double, double)));
  pick("Shift+P", SLOT(moveTo(double, double, double)));
}

//------------------------------------------------------------------------------
void pqLMS3DPoseWidget::moveOver(double x, double y, double)
{
  this->moveTo(x, y, vtkSMPropertyHelper(this->widgetProxy(), "Position").GetAsDouble(2));
}

//------------------------------------------------------------------------------
void pqLMS3DPoseWidget::moveTo(double x, double y, double z)
{
  // A hidden box does not move, and the axes of a range image are angles.
  if (!this->WidgetVisibility)
  {
    return;
  }
  const double position[3] = { x, y, z };
  vtkSMPropertyHelper(this->widgetProxy(), "Position").Set(position, 3);
  this->widgetProxy()->UpdateVTKObjects();
  Q_EMIT this->changeAvailable();
  Q_EMIT this->changeFinished();
  this->render();
}

//------------------------------------------------------------------------------
void pqLMS3DPoseWidget::beginDrag()
{
  this->endUndoStep();
  BEGIN_UNDO_SET(tr("Move Sensor"));
  this->InUndoStep = true;
}

//------------------------------------------------------------------------------
// Later, when ParaView has the last pose. With Auto Apply, the last scan is a part of the step.
void pqLMS3DPoseWidget::endDrag()
{
  QTimer::singleShot(0, this, SLOT(endUndoStep()));
}

//------------------------------------------------------------------------------
void pqLMS3DPoseWidget::endUndoStep()
{
  if (this->InUndoStep)
  {
    this->InUndoStep = false;
    auto* application = pqPVApplicationCore::instance();
    if (application && vtkPVGeneralSettings::GetInstance()->GetAutoApply())
    {
      application->triggerApply();
    }
    END_UNDO_SET();
  }
}

//------------------------------------------------------------------------------
void pqLMS3DPoseWidget::followPose()
{
  for (const char* name : { "Position", "Rotation" })
  {
    pqCoreUtilities::connect(
      this->widgetProxy()->GetProperty(name), vtkCommand::ModifiedEvent, this, SLOT(showAxes()));
  }
  this->showAxes();
}

//------------------------------------------------------------------------------
void pqLMS3DPoseWidget::followTrajectory()
{
  if (vtkSMProperty* trajectory = this->proxy()->GetProperty("Trajectory"))
  {
    pqCoreUtilities::connect(
      trajectory, vtkCommand::ModifiedEvent, this, SLOT(updateWidgetVisibility()));
  }
  auto* model = pqApplicationCore::instance()->getServerManagerModel();
  if (auto* scan = model->findItem<pqPipelineSource*>(this->proxy()))
  {
    this->connect(scan, SIGNAL(dataUpdated(pqPipelineSource*)), SLOT(showAxes()));
  }
  this->pqLMS3DPoseWidget::updateWidgetVisibility();
}

//------------------------------------------------------------------------------
bool pqLMS3DPoseWidget::hasTrajectory() const
{
  return lms3dGetTrajectory(this->proxy()) != nullptr;
}

//------------------------------------------------------------------------------
// Not if the view shows a range image, because its axes are angles.
bool pqLMS3DPoseWidget::isSceneShown() const
{
  return this->view() && !lms3dShows(this->view(), lms3dIsRangeImage);
}

//------------------------------------------------------------------------------
void pqLMS3DPoseWidget::setView(pqView* shown)
{
  if (this->view())
  {
    QObject::disconnect(this->view(), nullptr, this, SLOT(updateWidgetVisibility()));
  }
  this->Superclass::setView(shown);
  if (this->view())
  {
    this->connect(this->view(), SIGNAL(representationVisibilityChanged(pqRepresentation*, bool)),
      SLOT(updateWidgetVisibility()));
  }
}

//------------------------------------------------------------------------------
// Hides the box while there is a trajectory. Keeps the user's choice for the time after it.
void pqLMS3DPoseWidget::updateWidgetVisibility()
{
  const bool wanted = this->WidgetVisibility;
  this->WidgetVisibility = wanted && !this->hasTrajectory() && this->isSceneShown();
  this->Superclass::updateWidgetVisibility();
  this->WidgetVisibility = wanted;
  if (auto* shown = this->findChild<QCheckBox*>("show3DWidget"))
  {
    shown->setEnabled(!this->hasTrajectory());
  }
  this->showAxes();
}

//------------------------------------------------------------------------------
// Keeps the user's choice, which ParaView takes from the box.
void pqLMS3DPoseWidget::hideEvent(QHideEvent* event)
{
  const bool wanted = this->WidgetVisibility;
  this->Superclass::hideEvent(event);
  this->VisibleState = wanted;
  this->showAxes();
}

//------------------------------------------------------------------------------
// Also while the scan is not selected if the view shows its trajectory, so that one sees the sensor
// move.
bool pqLMS3DPoseWidget::areAxesShown() const
{
  const vtkSMProxy* trajectory = lms3dGetTrajectory(this->proxy());
  const bool isWanted = this->isVisible() ? this->WidgetVisibility : this->VisibleState;
  return this->isSceneShown() &&
    ((this->WidgetVisibility && this->isSelected()) ||
      (trajectory && isWanted &&
        lms3dShows(this->view(),
          [trajectory](vtkSMProxy* shown) { return lms3dGetSourceOf(shown) == trajectory; })));
}

//------------------------------------------------------------------------------
void pqLMS3DPoseWidget::showAxes()
{
  this->Axes.Hide();
  vtkNew<vtkTransform> pose;
  if (this->areAxesShown() && this->getPose(pose))
  {
    this->Axes.SetPose(pose);
    this->Axes.ShowIn(this->view()->getProxy());
  }
  this->render();
}

//------------------------------------------------------------------------------
bool pqLMS3DPoseWidget::getPose(vtkTransform* pose) const
{
  if (this->hasTrajectory())
  {
    return lms3dGetPoseOfScan(this->proxy(), pose);
  }
  lms3dGetPoseOfBox(this->widgetProxy(), pose);
  return true;
}
