// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqLMS3DResultText.h"

#include "lms3dOutputOf.h"

#include <pqApplicationCore.h>
#include <pqPipelineSource.h>
#include <pqRenderView.h>
#include <pqRepresentation.h>
#include <pqServerManagerModel.h>

#include <vtkCoordinate.h>
#include <vtkDataObject.h>
#include <vtkPVArrayInformation.h>
#include <vtkPVDataInformation.h>
#include <vtkPVRenderView.h>
#include <vtkRenderer.h>
#include <vtkSMSourceProxy.h>
#include <vtkSMViewProxy.h>
#include <vtkTextProperty.h>

#include <cstring>
#include <string>

namespace
{
const char* const Comparison = "LMS3DMapComparison";

QString GetPercent(const vtkPVDataInformation* results, const char* name)
{
  const vtkPVArrayInformation* share = results->GetArrayInformation(name, vtkDataObject::FIELD);
  return share ? QString::number(100 * share->GetComponentRange(0)[0], 'f', 1) + " %" : QString();
}

// Mean, 95 % and maximum of distances, in two lines that a narrow view shows whole.
QString GetDistances(const vtkPVDataInformation* results, const char* name)
{
  const vtkPVArrayInformation* errors = results->GetArrayInformation(name, vtkDataObject::FIELD);
  if (!errors || errors->GetNumberOfComponents() != 4)
  {
    return QString();
  }
  const auto millimetres = [&](int component)
  { return QString::number(1000 * errors->GetComponentRange(component)[0], 'f', 1) + " mm"; };
  return "mean " + millimetres(0) + ",\n  95 % " + millimetres(2) + ", maximum " + millimetres(3);
}

// Empty if the comparison has no results.
QString DescribeResults(vtkSMProxy* comparison)
{
  const vtkPVDataInformation* results =
    vtkSMSourceProxy::SafeDownCast(comparison)->GetDataInformation(0);
  const QString correctness = GetPercent(results, "Correctness");
  if (correctness.isEmpty())
  {
    return QString();
  }
  const double tolerance = vtkSMPropertyHelper(comparison, "Tolerance").GetAsDouble();
  return "Within " + QString::number(1000 * tolerance) + " mm: map " + correctness +
    ",\n  visible scene " + GetPercent(results, "Completeness") +
    "\nMap to scene: " + GetDistances(results, "MapToScene") +
    "\nScene to map: " + GetDistances(results, "SceneToMap");
}

QString DescribeView(pqView* view)
{
  QString text;
  for (pqRepresentation* shown : view->getRepresentations())
  {
    if (shown->isVisible() && lms3dIsOutputOf(shown->getProxy(), Comparison, 0))
    {
      text = DescribeResults(vtkSMPropertyHelper(shown->getProxy(), "Input").GetAsProxy());
    }
  }
  return text;
}

vtkRenderer* GetRenderer(pqView* view)
{
  auto* shown = vtkPVRenderView::SafeDownCast(view->getViewProxy()->GetClientSideObject());
  return shown ? shown->GetNonCompositedRenderer() : nullptr;
}

vtkSmartPointer<vtkTextActor> MakeText()
{
  auto text = vtkSmartPointer<vtkTextActor>::New();
  text->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  text->SetPosition(0.02, 0.97);
  text->GetTextProperty()->SetVerticalJustificationToTop();
  text->GetTextProperty()->SetFontSize(16);
  text->GetTextProperty()->ShadowOn();
  text->PickableOff();
  return text;
}
} // namespace

//------------------------------------------------------------------------------
void pqLMS3DResultText::startup()
{
  auto* model = pqApplicationCore::instance()->getServerManagerModel();
  this->listen(model, SIGNAL(viewAdded(pqView*)), SLOT(watch(pqView*)));
  this->listen(model, SIGNAL(preViewRemoved(pqView*)), SLOT(forget(pqView*)));
  this->listen(model, SIGNAL(dataUpdated(pqPipelineSource*)), SLOT(updateViews(pqPipelineSource*)));
  for (pqView* view : model->findItems<pqView*>())
  {
    this->watch(view);
  }
}

//------------------------------------------------------------------------------
void pqLMS3DResultText::shutdown()
{
  this->lms3dAutoStart::shutdown();
  this->Texts.clear();
}

//------------------------------------------------------------------------------
void pqLMS3DResultText::watch(pqView* added)
{
  if (qobject_cast<pqRenderView*>(added))
  {
    for (const char* change : { SIGNAL(representationVisibilityChanged(pqRepresentation*, bool)),
           SIGNAL(representationAdded(pqRepresentation*)),
           SIGNAL(representationRemoved(pqRepresentation*)) })
    {
      this->listen(added, change, SLOT(updateView()));
    }
  }
}

//------------------------------------------------------------------------------
void pqLMS3DResultText::forget(pqView* removed)
{
  this->Texts.remove(removed);
}

//------------------------------------------------------------------------------
void pqLMS3DResultText::updateView()
{
  if (auto* view = qobject_cast<pqView*>(this->sender()))
  {
    this->write(view);
  }
}

//------------------------------------------------------------------------------
void pqLMS3DResultText::updateViews(pqPipelineSource* updated)
{
  if (std::strcmp(updated->getProxy()->GetXMLName(), Comparison) != 0)
  {
    return;
  }
  const auto* model = pqApplicationCore::instance()->getServerManagerModel();
  for (pqRenderView* view : model->findItems<pqRenderView*>())
  {
    this->write(view);
  }
}

//------------------------------------------------------------------------------
void pqLMS3DResultText::write(pqView* view)
{
  const QString words = DescribeView(view);
  if (words.isEmpty() && !this->Texts.contains(view))
  {
    return; // a view without comparison
  }
  vtkSmartPointer<vtkTextActor>& text = this->Texts[view];
  vtkRenderer* renderer = GetRenderer(view);
  if (!text && renderer)
  {
    text = MakeText();
    renderer->AddActor(text);
  }
  if (text)
  {
    text->SetInput(words.toUtf8().constData());
    text->SetVisibility(!words.isEmpty());
    view->render();
  }
}
