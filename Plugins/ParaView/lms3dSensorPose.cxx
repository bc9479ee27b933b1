// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dSensorPose.h"

#include <vtkAlgorithm.h>
#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkPVDataInformation.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMSourceProxy.h>
#include <vtkTransform.h>
#include <vtkVariant.h>

//------------------------------------------------------------------------------
vtkBoundingBox lms3dGetSceneBounds(vtkSMProxy* scan)
{
  const vtkSMPropertyHelper input(scan, "Input", true);
  auto* scene = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  return scene ? vtkBoundingBox(scene->GetDataInformation(input.GetOutputPort())->GetBounds())
               : vtkBoundingBox();
}

//------------------------------------------------------------------------------
vtkSMProxy* lms3dGetTrajectory(vtkSMProxy* sensor)
{
  vtkSMProperty* trajectory = sensor->GetProperty("Trajectory");
  return trajectory ? vtkSMPropertyHelper(trajectory).GetAsProxy() : nullptr;
}

//------------------------------------------------------------------------------
double lms3dGetHandleHalfWidth(vtkSMProxy* scan)
{
  constexpr double share = 0.02; // of the scene's diagonal
  constexpr double withoutScene = 0.25;
  const vtkBoundingBox bounds = lms3dGetSceneBounds(scan);
  return bounds.IsValid() && bounds.GetDiagonalLength() > 0 ? share * bounds.GetDiagonalLength()
                                                            : withoutScene;
}

//------------------------------------------------------------------------------
void lms3dGetPoseOfBox(vtkSMProxy* box, vtkTransform* pose)
{
  double position[3];
  double rotation[3];
  vtkSMPropertyHelper(box, "Position").Get(position, 3);
  vtkSMPropertyHelper(box, "Rotation").Get(rotation, 3);
  pose->Translate(position);
  pose->RotateZ(rotation[2]);
  pose->RotateX(rotation[0]);
  pose->RotateY(rotation[1]);
}

//------------------------------------------------------------------------------
bool lms3dGetPoseOfScan(vtkSMProxy* scan, vtkTransform* pose)
{
  auto* filter = vtkAlgorithm::SafeDownCast(scan->GetClientSideObject());
  vtkDataObject* returns = filter ? filter->GetOutputDataObject(0) : nullptr;
  vtkDataArray* matrix = returns ? returns->GetFieldData()->GetArray("SensorToWorld") : nullptr;
  constexpr int size = 16;
  if (!matrix || matrix->GetNumberOfValues() != size)
  {
    return false;
  }
  double elements[size];
  for (int i = 0; i < size; ++i)
  {
    elements[i] = matrix->GetVariantValue(i).ToDouble();
  }
  pose->SetMatrix(elements);
  return true;
}
