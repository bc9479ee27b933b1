// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqLMS3DDeviceWidget.h"

#include "vtkLMS3DScanFilter.h"

#include <pqCoreUtilities.h>
#include <pqPropertiesPanel.h>
#include <pqProxyWidget.h>

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>

#include <vtkCommand.h>
#include <vtkSMProperty.h>
#include <vtkSMPropertyGroup.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMPropertyIterator.h>
#include <vtkSMProxy.h>
#include <vtkSmartPointer.h>

#include <cmath>
#include <cstring>
#include <map>
#include <string>

namespace
{
// The properties of a proxy that a device sets, with their values.
std::map<std::string, double> GetValues(vtkSMProxy* proxy, int device)
{
  std::map<std::string, double> values;
  const auto properties =
    vtkSmartPointer<vtkSMPropertyIterator>::Take(proxy->NewPropertyIterator());
  for (properties->Begin(); !properties->IsAtEnd(); properties->Next())
  {
    const double value = vtkLMS3DScanFilter::GetDeviceValue(device, properties->GetKey());
    if (!std::isnan(value))
    {
      values[properties->GetKey()] = value;
    }
  }
  return values;
}

// The values that the panel shows, which Apply has not taken yet.
double GetShown(vtkSMProxy* proxy, const std::string& name)
{
  vtkSMPropertyHelper helper(proxy, name.c_str());
  helper.SetUseUnchecked(true);
  return helper.GetAsDouble();
}

void SetShown(vtkSMProxy* proxy, const std::string& name, double value)
{
  vtkSMPropertyHelper helper(proxy, name.c_str());
  helper.SetUseUnchecked(true);
  helper.Set(value);
}
} // namespace

//------------------------------------------------------------------------------
pqLMS3DDeviceWidget::pqLMS3DDeviceWidget(
  vtkSMProxy* smproxy, vtkSMPropertyGroup* group, QWidget* parentWidget)
  : Superclass(smproxy, group, parentWidget)
  , Choice(new QComboBox(this))
{
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setHorizontalSpacing(pqPropertiesPanel::suggestedHorizontalSpacing());
  layout->setVerticalSpacing(pqPropertiesPanel::suggestedVerticalSpacing());
  layout->setColumnStretch(1, 1);
  this->addChoice(layout);
  for (unsigned int i = 0; i < group->GetNumberOfProperties(); ++i)
  {
    this->addRow(group->GetProperty(i), layout);
  }
  this->followValues();
  this->showDevice();
}

//------------------------------------------------------------------------------
void pqLMS3DDeviceWidget::addChoice(QGridLayout* layout)
{
  this->Choice->setObjectName("device");
  for (int i = 0; i < vtkLMS3DScanFilter::GetNumberOfDevices(); ++i)
  {
    this->Choice->addItem(vtkLMS3DScanFilter::GetDeviceName(i));
  }
  this->Choice->setToolTip(tr(
    "Sets all properties of this filter that describe a device; of LMS3D Scan also Maximum "
    "Range. You can change each of them. Custom: the values belong to no device. Default: Ideal."));
  layout->addWidget(this->Choice, 0, 0, 1, 2);
  this->connect(this->Choice, SIGNAL(currentIndexChanged(int)), SLOT(setDevice(int)));
}

//------------------------------------------------------------------------------
void pqLMS3DDeviceWidget::addRow(vtkSMProperty* shown, QGridLayout* layout)
{
  pqPropertyWidget* field = pqProxyWidget::createWidgetForProperty(shown, this->proxy(), this);
  if (!field)
  {
    return;
  }
  const QString name = this->proxy()->GetPropertyName(shown);
  const QString help = pqProxyWidget::documentationText(shown);
  field->setObjectName(name);
  field->setToolTip(help);
  auto* label = new QLabel(shown->GetXMLLabel(), this);
  label->setToolTip(help);
  const int row = layout->rowCount();
  layout->addWidget(label, row, 0);
  layout->addWidget(field, row, 1);
  this->connect(field, SIGNAL(changeAvailable()), SIGNAL(changeAvailable()));
  this->connect(field, SIGNAL(changeFinished()), SIGNAL(changeFinished()));
  const char* visibility = shown->GetPanelVisibility();
  this->Rows.append({ label, field, visibility && std::strcmp(visibility, "advanced") == 0 });
}

//------------------------------------------------------------------------------
void pqLMS3DDeviceWidget::followValues()
{
  for (const auto& [name, value] : GetValues(this->proxy(), vtkLMS3DScanFilter::IDEAL))
  {
    for (const auto event :
      { vtkCommand::ModifiedEvent, vtkCommand::UncheckedPropertyModifiedEvent })
    {
      pqCoreUtilities::connect(
        this->proxy()->GetProperty(name.c_str()), event, this, SLOT(showDevice()));
    }
  }
}

//------------------------------------------------------------------------------
void pqLMS3DDeviceWidget::apply()
{
  for (const Row& row : this->Rows)
  {
    row.Field->apply();
  }
  this->Superclass::apply();
}

//------------------------------------------------------------------------------
void pqLMS3DDeviceWidget::reset()
{
  for (const Row& row : this->Rows)
  {
    row.Field->reset();
  }
  this->Superclass::reset();
  this->showDevice();
}

//------------------------------------------------------------------------------
void pqLMS3DDeviceWidget::updateWidget(bool isAdvancedShown)
{
  for (const Row& row : this->Rows)
  {
    const bool isShown = isAdvancedShown || !row.IsAdvanced;
    row.Label->setVisible(isShown);
    row.Field->setVisible(isShown);
  }
}

//------------------------------------------------------------------------------
void pqLMS3DDeviceWidget::setDevice(int device)
{
  for (const auto& [name, value] : GetValues(this->proxy(), device))
  {
    SetShown(this->proxy(), name, value);
  }
  this->showDevice();
  Q_EMIT this->changeAvailable();
  Q_EMIT this->changeFinished();
}

//------------------------------------------------------------------------------
bool pqLMS3DDeviceWidget::hasValuesOf(int device) const
{
  for (const auto& [name, value] : GetValues(this->proxy(), device))
  {
    if (GetShown(this->proxy(), name) != value)
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// "Custom" is in the list only while it holds, since it cannot be chosen.
void pqLMS3DDeviceWidget::showDevice()
{
  const QSignalBlocker blocker(this->Choice);
  const int devices = vtkLMS3DScanFilter::GetNumberOfDevices();
  int device = 0;
  while (device < devices && !this->hasValuesOf(device))
  {
    ++device;
  }
  if (device == devices && this->Choice->count() == devices)
  {
    this->Choice->addItem(tr("Custom"));
  }
  else if (this->Choice->count() > devices && device != devices)
  {
    this->Choice->removeItem(devices);
  }
  this->Choice->setCurrentIndex(device);
}
