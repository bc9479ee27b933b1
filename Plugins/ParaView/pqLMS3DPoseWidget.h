// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqLMS3DPoseWidget
 * @brief moves and turns the sensor, with the mouse in the view or by numbers
 *
 * Shows ParaView's box widget around the sensor, on top of the scene. The box is centred at the
 * sensor, so that turning the box does not move the sensor. Its width is 4 % of the scene's
 * diagonal. The sensor's axes are drawn in the box, in the colours of ParaView's axes: x is the
 * direction of the first turn, z the platform's axis. The group has the functions of the box
 * widget: Position (metres) and Rotation (degrees, applied in the order z, x, y).
 *
 * The mouse keeps the sensor's height and tilt unless Shift is down (lms3dPoseDrag). P moves the
 * sensor above the point under the mouse, at its height; Shift+P moves it to this point. With
 * ParaView's Auto Apply the scan follows the mouse, otherwise it follows on Apply. A drag is one
 * step of undo.
 *
 * While the scan has a trajectory, the sensor is not at Position. The box is hidden then, and the
 * axes show the pose of the present time. If the active view shows the trajectory, the axes stay
 * while other filters are selected. A view of a range image shows neither box nor axes. In XML:
 * `<PropertyGroup panel_widget="LMS3DPose">`.
 */

#ifndef pqLMS3DPoseWidget_h
#define pqLMS3DPoseWidget_h

#include "lms3dPoseDrag.h"
#include "lms3dSensorAxes.h"

#include "pqBoxPropertyWidget.h"

class vtkTransform;

class pqLMS3DPoseWidget : public pqBoxPropertyWidget
{
  Q_OBJECT
  typedef pqBoxPropertyWidget Superclass;

public:
  pqLMS3DPoseWidget(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent = nullptr);
  ~pqLMS3DPoseWidget() override;

  void hideEvent(QHideEvent* event) override;
  void setView(pqView* shown) override;

protected Q_SLOTS:
  void placeWidget() override;
  void updateWidgetVisibility() override;

private Q_SLOTS:
  void showAxes();
  void moveOver(double x, double y, double z);
  void moveTo(double x, double y, double z);
  void beginDrag();
  void endDrag();
  void endUndoStep();

private:
  Q_DISABLE_COPY(pqLMS3DPoseWidget)

  bool hasTrajectory() const;
  bool isSceneShown() const;
  bool areAxesShown() const;
  bool getPose(vtkTransform* pose) const;
  void pickByKeys();
  void followPose();
  void followTrajectory();

  lms3dSensorAxes Axes;
  lms3dPoseDrag Drag;
  bool InUndoStep = false;
};

#endif
