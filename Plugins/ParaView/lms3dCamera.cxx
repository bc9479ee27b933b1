// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dCamera.h"

#include <pqView.h>

#include <vtkSMPropertyHelper.h>
#include <vtkSMRenderViewProxy.h>

namespace
{
lms3dCamera::Vector GetVector(vtkSMProxy* view, const char* property)
{
  lms3dCamera::Vector values{};
  vtkSMPropertyHelper(view, property).Get(values.data(), 3);
  return values;
}

// Scripts and the mouse change the camera, and the properties of the view follow later.
void UpdateProperties(vtkSMProxy* view)
{
  if (auto* rendered = vtkSMRenderViewProxy::SafeDownCast(view))
  {
    rendered->SynchronizeCameraProperties();
  }
}
} // namespace

//------------------------------------------------------------------------------
lms3dCamera lms3dGetCamera(pqView* view)
{
  vtkSMProxy* proxy = view->getProxy();
  UpdateProperties(proxy);
  return { GetVector(proxy, "CameraPosition"), GetVector(proxy, "CameraFocalPoint"),
    GetVector(proxy, "CameraViewUp"), GetVector(proxy, "CenterOfRotation"),
    vtkSMPropertyHelper(proxy, "CameraParallelScale").GetAsDouble(),
    vtkSMPropertyHelper(proxy, "InteractionMode").GetAsInt() };
}

//------------------------------------------------------------------------------
void lms3dSetCamera(pqView* view, const lms3dCamera& camera)
{
  vtkSMProxy* proxy = view->getProxy();
  UpdateProperties(proxy);
  vtkSMPropertyHelper(proxy, "InteractionMode").Set(camera.InteractionMode);
  vtkSMPropertyHelper(proxy, "CameraPosition").Set(camera.Position.data(), 3);
  vtkSMPropertyHelper(proxy, "CameraFocalPoint").Set(camera.FocalPoint.data(), 3);
  vtkSMPropertyHelper(proxy, "CameraViewUp").Set(camera.ViewUp.data(), 3);
  vtkSMPropertyHelper(proxy, "CenterOfRotation").Set(camera.CenterOfRotation.data(), 3);
  vtkSMPropertyHelper(proxy, "CameraParallelScale").Set(camera.ParallelScale);
  proxy->UpdateVTKObjects();
}

//------------------------------------------------------------------------------
void lms3dTurnCamera(pqView* view, const lms3dCamera::Vector& from, const lms3dCamera::Vector& up)
{
  lms3dCamera camera = lms3dGetCamera(view);
  for (int i = 0; i < 3; ++i)
  {
    camera.Position[i] = camera.FocalPoint[i] + from[i];
  }
  camera.ViewUp = up;
  lms3dSetCamera(view, camera);
}
