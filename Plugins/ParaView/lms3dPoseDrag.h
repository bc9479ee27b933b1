// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class lms3dPoseDrag
 * @brief keeps a sensor that the mouse drags at its height and its tilt
 *
 * Works on VTK's box widget before ParaView reads the pose of the box. Left button: turns the
 * sensor about the vertical axis, by half a degree for each pixel to the right. Middle button, or
 * left button with Ctrl: moves the sensor in the horizontal plane, under the mouse. While Shift is
 * down, the box widget's own motion holds: a turn about any axis, and a move in the plane of the
 * view.
 */

#ifndef lms3dPoseDrag_h
#define lms3dPoseDrag_h

#include <vtkNew.h>
#include <vtkWeakPointer.h>

class vtkAbstractWidget;
class vtkBoxRepresentation;
class vtkTransform;

class lms3dPoseDrag
{
public:
  /// `box` is a vtkBoxWidget2 with a vtkBoxRepresentation. Another widget is left as it is.
  explicit lms3dPoseDrag(vtkAbstractWidget* box);
  ~lms3dPoseDrag();
  lms3dPoseDrag(const lms3dPoseDrag&) = delete;
  lms3dPoseDrag& operator=(const lms3dPoseDrag&) = delete;

private:
  void mapShift();
  void start();
  void follow();
  void turn(int pixels);
  void move(const int mouse[2], const double freePosition[3]);
  bool findAtHeight(const int mouse[2], double point[3]) const;
  vtkBoxRepresentation* getBox() const;

  vtkWeakPointer<vtkAbstractWidget> Widget;
  unsigned long Observers[2] = {};
  vtkNew<vtkTransform> Pose;
  int Mouse[2] = {};
};

#endif
