// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqLMS3DPoseWidget
 * @brief moves and turns the sensor, with the mouse in the view or by numbers
 *
 * Shows ParaView's box widget around the sensor. The box is centred at the sensor, so that turning the
 * box does not move the sensor. Its width is 4 % of the scene's diagonal. The sensor's axes are drawn
 * in the box: x red, the direction of the first turn, y green, z blue, the platform's axis. The group
 * has the functions of the box widget: Position (metres) and Rotation (degrees, applied in the order
 * z, x, y).
 *
 * With ParaView's Auto Apply the scan follows the mouse, otherwise it follows on Apply. The box is
 * hidden while the scan has a trajectory, because the sensor is not at Position then.
 * In XML: `<PropertyGroup panel_widget="LMS3DPose">`.
 */

#ifndef pqLMS3DPoseWidget_h
#define pqLMS3DPoseWidget_h

#include "pqBoxPropertyWidget.h"

#include <vtkNew.h>
#include <vtkWeakPointer.h>

class QCheckBox;
class vtkAxesActor;
class vtkRenderer;

class pqLMS3DPoseWidget : public pqBoxPropertyWidget
{
  Q_OBJECT
  typedef pqBoxPropertyWidget Superclass;

public:
  pqLMS3DPoseWidget(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent = nullptr);
  ~pqLMS3DPoseWidget() override;

  void hideEvent(QHideEvent* event) override;

protected Q_SLOTS:
  void placeWidget() override;
  void updateWidgetVisibility() override;

private Q_SLOTS:
  void showFrame(bool visible);
  void moveFrame();

private:
  Q_DISABLE_COPY(pqLMS3DPoseWidget)

  QCheckBox* getShowBox() const;
  bool hasTrajectory() const;
  void hideBoundsControls();
  void followPose();
  void followTrajectory();
  void removeFrame();

  vtkNew<vtkAxesActor> Frame;
  vtkWeakPointer<vtkRenderer> Renderer;
};

#endif
