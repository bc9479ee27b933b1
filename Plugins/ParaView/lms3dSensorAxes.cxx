// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dSensorAxes.h"

#include <vtkActor.h>
#include <vtkAxesActor.h>
#include <vtkMapper.h>
#include <vtkPVAxesActor.h>
#include <vtkPVRenderView.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSMProxy.h>
#include <vtkTransform.h>

namespace
{
// In ParaView 5.13 an invisible box has no actors.
void GetAllActors(vtkProp* prop, vtkPropCollection* actors)
{
  const vtkTypeBool visibility = prop->GetVisibility();
  prop->VisibilityOn();
  prop->GetActors(actors);
  prop->SetVisibility(visibility);
}
} // namespace

//------------------------------------------------------------------------------
lms3dSensorAxes::lms3dSensorAxes()
{
  vtkNew<vtkPVAxesActor> corner;
  vtkProperty* const colored[3] = { corner->GetXAxisShaftProperty(),
    corner->GetYAxisShaftProperty(), corner->GetZAxisShaftProperty() };
  vtkProperty* const shafts[3] = { this->Axes->GetXAxisShaftProperty(),
    this->Axes->GetYAxisShaftProperty(), this->Axes->GetZAxisShaftProperty() };
  vtkProperty* const tips[3] = { this->Axes->GetXAxisTipProperty(),
    this->Axes->GetYAxisTipProperty(), this->Axes->GetZAxisTipProperty() };
  for (int i = 0; i < 3; ++i)
  {
    shafts[i]->SetColor(colored[i]->GetColor());
    shafts[i]->SetLineWidth(2);
    tips[i]->SetColor(colored[i]->GetColor());
    tips[i]->BackfaceCullingOn(); // The depth is the same everywhere.
  }
  this->Axes->AxisLabelsOff();
  this->Axes->PickableOff();
  lms3dSensorAxes::DrawOnTop(this->Axes);
}

//------------------------------------------------------------------------------
lms3dSensorAxes::~lms3dSensorAxes()
{
  this->Hide();
}

//------------------------------------------------------------------------------
void lms3dSensorAxes::SetLength(double length)
{
  this->Axes->SetTotalLength(length, length, length);
}

//------------------------------------------------------------------------------
void lms3dSensorAxes::SetPose(vtkTransform* pose)
{
  this->Axes->SetUserTransform(pose);
}

//------------------------------------------------------------------------------
void lms3dSensorAxes::ShowIn(vtkSMProxy* view)
{
  this->Hide();
  if (auto* shown = vtkPVRenderView::SafeDownCast(view->GetClientSideObject()))
  {
    this->Renderer = shown->GetNonCompositedRenderer();
    this->Renderer->AddActor(this->Axes);
  }
}

//------------------------------------------------------------------------------
void lms3dSensorAxes::Hide()
{
  if (this->Renderer)
  {
    this->Renderer->RemoveActor(this->Axes);
  }
  this->Renderer = nullptr;
}

//------------------------------------------------------------------------------
// An offset that brings everything to the near plane.
void lms3dSensorAxes::DrawOnTop(vtkProp* prop)
{
  constexpr double offset = -100000;
  vtkNew<vtkPropCollection> parts;
  GetAllActors(prop, parts);
  parts->InitTraversal();
  while (vtkProp* part = parts->GetNextProp())
  {
    auto* actor = vtkActor::SafeDownCast(part);
    if (actor && actor->GetMapper())
    {
      actor->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(0, offset);
      actor->GetMapper()->SetRelativeCoincidentTopologyLineOffsetParameters(0, offset);
    }
  }
}
