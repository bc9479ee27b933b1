// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Reads, sets and turns the camera of a render view.
 */

#ifndef lms3dCamera_h
#define lms3dCamera_h

#include <array>

class pqView;

/// The camera of a render view, with the view's interaction mode and centre of rotation.
struct lms3dCamera
{
  using Vector = std::array<double, 3>;

  Vector Position;
  Vector FocalPoint;
  Vector ViewUp;
  Vector CenterOfRotation;
  double ParallelScale;
  int InteractionMode; // a mode that vtkPVRenderView defines
};

lms3dCamera lms3dGetCamera(pqView* view);
void lms3dSetCamera(pqView* view, const lms3dCamera& camera);

/// Puts the camera in the direction `from`, seen from the point that it looks at.
void lms3dTurnCamera(pqView* view, const lms3dCamera::Vector& from, const lms3dCamera::Vector& up);

#endif
