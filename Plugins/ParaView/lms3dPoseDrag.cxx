// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dPoseDrag.h"

#include <vtkAbstractWidget.h>
#include <vtkBoxRepresentation.h>
#include <vtkCommand.h>
#include <vtkEvent.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkTransform.h>
#include <vtkWidgetEvent.h>
#include <vtkWidgetEventTranslator.h>

#include <algorithm>
#include <cmath>

namespace
{
// A point under the mouse; depth 0 is the near plane, 1 the far one.
void GetPointUnder(vtkRenderer* renderer, const int mouse[2], double depth, double point[3])
{
  renderer->SetDisplayPoint(mouse[0], mouse[1], depth);
  renderer->DisplayToWorld();
  const double* world = renderer->GetWorldPoint();
  for (int i = 0; i < 3; ++i)
  {
    point[i] = world[i] / world[3];
  }
}
} // namespace

//------------------------------------------------------------------------------
lms3dPoseDrag::lms3dPoseDrag(vtkAbstractWidget* box)
  : Widget(box)
{
  if (!this->getBox())
  {
    return;
  }
  // Before ParaView, whose observers have priority 0.
  constexpr float priority = 1;
  this->Observers[0] =
    box->AddObserver(vtkCommand::StartInteractionEvent, this, &lms3dPoseDrag::start, priority);
  this->Observers[1] =
    box->AddObserver(vtkCommand::InteractionEvent, this, &lms3dPoseDrag::follow, priority);
  this->mapShift();
}

//------------------------------------------------------------------------------
lms3dPoseDrag::~lms3dPoseDrag()
{
  for (unsigned long observer : this->Observers)
  {
    if (this->Widget)
    {
      this->Widget->RemoveObserver(observer);
    }
  }
}

//------------------------------------------------------------------------------
vtkBoxRepresentation* lms3dPoseDrag::getBox() const
{
  return this->Widget ? vtkBoxRepresentation::SafeDownCast(this->Widget->GetRepresentation())
                      : nullptr;
}

//------------------------------------------------------------------------------
// By default, Shift with the left button moves the box, as Ctrl does. Here it turns the box.
void lms3dPoseDrag::mapShift()
{
  vtkWidgetEventTranslator* translator = this->Widget->GetEventTranslator();
  const auto map = [&](int modifiers, unsigned long press, unsigned long release)
  {
    translator->SetTranslation(vtkCommand::LeftButtonPressEvent, modifiers, 0, 0, nullptr, press);
    translator->SetTranslation(
      vtkCommand::LeftButtonReleaseEvent, modifiers, 0, 0, nullptr, release);
  };
  map(vtkEvent::ShiftModifier, vtkWidgetEvent::Select, vtkWidgetEvent::EndSelect);
  map(vtkEvent::ShiftModifier | vtkEvent::ControlModifier, vtkWidgetEvent::Translate,
    vtkWidgetEvent::EndTranslate);
}

//------------------------------------------------------------------------------
void lms3dPoseDrag::start()
{
  this->getBox()->GetTransform(this->Pose);
  this->Widget->GetInteractor()->GetEventPosition(this->Mouse);
}

//------------------------------------------------------------------------------
void lms3dPoseDrag::follow()
{
  vtkBoxRepresentation* box = this->getBox();
  vtkNew<vtkTransform> free;
  box->GetTransform(free);
  int mouse[2];
  this->Widget->GetInteractor()->GetEventPosition(mouse);
  if (this->Widget->GetInteractor()->GetShiftKey())
  {
    this->Pose->SetMatrix(free->GetMatrix());
  }
  else if (box->GetInteractionState() == vtkBoxRepresentation::Rotating)
  {
    this->turn(mouse[0] - this->Mouse[0]);
  }
  else
  {
    this->move(mouse, free->GetPosition());
  }
  box->SetTransform(this->Pose);
  std::copy(mouse, mouse + 2, this->Mouse);
}

//------------------------------------------------------------------------------
// To the right is counterclockwise seen from above, as the near side of the box goes to the right.
void lms3dPoseDrag::turn(int pixels)
{
  constexpr double degrees = 0.5; // for each pixel
  double position[3];
  this->Pose->GetPosition(position);
  vtkNew<vtkTransform> turned;
  turned->Translate(position);
  turned->RotateZ(degrees * pixels);
  turned->Translate(-position[0], -position[1], -position[2]);
  turned->Concatenate(this->Pose->GetMatrix());
  this->Pose->SetMatrix(turned->GetMatrix());
}

//------------------------------------------------------------------------------
void lms3dPoseDrag::move(const int mouse[2], const double freePosition[3])
{
  vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(this->Pose->GetMatrix());
  double from[3];
  double to[3];
  const bool found = this->findAtHeight(this->Mouse, from) && this->findAtHeight(mouse, to);
  for (int i = 0; i < 2; ++i)
  {
    matrix->SetElement(i, 3, found ? matrix->GetElement(i, 3) + to[i] - from[i] : freePosition[i]);
  }
  this->Pose->SetMatrix(matrix);
}

//------------------------------------------------------------------------------
// The point under the mouse in the horizontal plane through the sensor. Fails if this plane is seen
// almost from its side, and above the horizon.
bool lms3dPoseDrag::findAtHeight(const int mouse[2], double point[3]) const
{
  constexpr double smallestSlope = 0.1;
  vtkRenderer* renderer = this->Widget->GetCurrentRenderer();
  if (!renderer)
  {
    return false;
  }
  double nearPoint[3];
  double ray[3];
  GetPointUnder(renderer, mouse, 0, nearPoint);
  GetPointUnder(renderer, mouse, 1, ray);
  vtkMath::Subtract(ray, nearPoint, ray);
  if (std::abs(ray[2]) < smallestSlope * vtkMath::Norm(ray))
  {
    return false;
  }
  const double share = (this->Pose->GetMatrix()->GetElement(2, 3) - nearPoint[2]) / ray[2];
  for (int i = 0; i < 3; ++i)
  {
    point[i] = nearPoint[i] + share * ray[i];
  }
  return share > 0;
}
