// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dPoseControls.h"

#include "lms3dSensorAxes.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>

#include <vtkBoxRepresentation.h>
#include <vtkSMProxy.h>

namespace
{
void HideBoundsControls(const QWidget* panel)
{
  for (const char* name : { "resetBounds", "visibleBoundsOnly" })
  {
    if (auto* control = panel->findChild<QWidget*>(name))
    {
      control->hide();
    }
  }
}

QGridLayout* FindLayout(const QWidget* panel, QWidget* control)
{
  for (auto* layout : panel->findChildren<QGridLayout*>())
  {
    if (layout->indexOf(control) >= 0)
    {
      return layout;
    }
  }
  return nullptr;
}

void PlaceField(QGridLayout* layout, QLineEdit* field, int row, int column)
{
  layout->removeWidget(field);
  layout->addWidget(field, row, column);
  constexpr int frame = 14; // pixels
  field->setFixedWidth(field->fontMetrics().horizontalAdvance("-0.123456") + frame);
  QObject::connect(field, &QLineEdit::textChanged, field,
    [field]
    {
      if (!field->hasFocus())
      {
        field->home(false);
      }
    });
}

// One row for the label, the next for the fields.
void PlaceRow(
  const QWidget* panel, const QString& prefix, const char* label, const QString& text, int row)
{
  auto* title = panel->findChild<QLabel*>(label);
  QGridLayout* layout = title ? FindLayout(panel, title) : nullptr;
  if (!layout)
  {
    return;
  }
  title->setText(text);
  layout->removeWidget(title);
  layout->addWidget(title, row, 0, 1, 3);
  layout->setColumnStretch(3, 1); // the room that the fields leave
  const char* const axes[3] = { "X", "Y", "Z" };
  for (int i = 0; i < 3; ++i)
  {
    if (auto* field = panel->findChild<QLineEdit*>(prefix + axes[i]))
    {
      PlaceField(layout, field, row + 1, i);
    }
  }
}
} // namespace

//------------------------------------------------------------------------------
void lms3dArrangePoseControls(QWidget* panel)
{
  if (auto* shown = panel->findChild<QCheckBox*>("show3DWidget"))
  {
    shown->setText(QObject::tr("Show Sensor"));
  }
  HideBoundsControls(panel);
  // The rows above 10 are ParaView's.
  PlaceRow(panel, "translate", "labelTranslate", QObject::tr("Position (m)"), 10);
  PlaceRow(panel, "rotate", "labelRotate", QObject::tr("Orientation (degrees)"), 12);
}

//------------------------------------------------------------------------------
void lms3dStyleBox(vtkSMProxy* representation)
{
  if (auto* box = vtkBoxRepresentation::SafeDownCast(representation->GetClientSideObject()))
  {
    box->HandlesOff();
    box->OutlineCursorWiresOff(); // lines from face to face
    lms3dSensorAxes::DrawOnTop(box);
  }
}
