// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class lms3dSensorAxes
 * @brief draws the axes of the sensor in a view
 *
 * The axes have the colours of ParaView's axes in the corner of the view. They are drawn on top of
 * the scene, so that a ceiling does not hide them. They belong to the widgets of the view, which
 * the client draws even if a server renders.
 */

#ifndef lms3dSensorAxes_h
#define lms3dSensorAxes_h

#include <vtkNew.h>
#include <vtkWeakPointer.h>

class vtkAxesActor;
class vtkProp;
class vtkRenderer;
class vtkSMProxy;
class vtkTransform;

class lms3dSensorAxes
{
public:
  lms3dSensorAxes();
  ~lms3dSensorAxes();
  lms3dSensorAxes(const lms3dSensorAxes&) = delete;
  lms3dSensorAxes& operator=(const lms3dSensorAxes&) = delete;

  /// `length` in metres.
  void SetLength(double length);
  void SetPose(vtkTransform* pose);
  /// Does nothing for a view without renderer.
  void ShowIn(vtkSMProxy* view);
  void Hide();

  /// Draws all surfaces and lines of `prop` on top of the scene.
  static void DrawOnTop(vtkProp* prop);

private:
  vtkNew<vtkAxesActor> Axes;
  vtkWeakPointer<vtkRenderer> Renderer;
};

#endif
