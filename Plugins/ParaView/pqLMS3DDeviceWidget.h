// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqLMS3DDeviceWidget
 * @brief a choice of devices, above the properties that describe a device
 *
 * The choice sets all properties of its filter that vtkLMS3DScanFilter::GetDeviceValue has a value
 * for, also those outside of this group. They change as if the user had typed the values: Apply
 * takes them and Reset takes them back, Undo, states and traces hold them. The choice itself is not
 * stored. It shows the device that has the present values, or "Custom" if there is none.
 *
 * Below are the usual widgets of the group's properties. Advanced ones are hidden as in other
 * groups. In XML: `<PropertyGroup panel_widget="LMS3DDevice">`.
 */

#ifndef pqLMS3DDeviceWidget_h
#define pqLMS3DDeviceWidget_h

#include "pqPropertyGroupWidget.h"

#include <QList>

class QComboBox;
class QGridLayout;
class QLabel;

class pqLMS3DDeviceWidget : public pqPropertyGroupWidget
{
  Q_OBJECT
  typedef pqPropertyGroupWidget Superclass;

public:
  pqLMS3DDeviceWidget(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent = nullptr);

  void apply() override;
  void reset() override;
  void updateWidget(bool isAdvancedShown) override;

private Q_SLOTS:
  void setDevice(int device);
  void showDevice();

private:
  Q_DISABLE_COPY(pqLMS3DDeviceWidget)

  struct Row
  {
    QLabel* Label;
    pqPropertyWidget* Field;
    bool IsAdvanced;
  };

  void addChoice(QGridLayout* layout);
  void addRow(vtkSMProperty* shown, QGridLayout* layout);
  void followValues();
  bool hasValuesOf(int device) const;

  QComboBox* Choice;
  QList<Row> Rows;
};

#endif
