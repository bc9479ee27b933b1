// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqLMS3DResultText
 * @brief writes the results of a map comparison into the views that show it
 *
 * A view that shows the first output of LMS3D Map Comparison has a text with its correctness,
 * completeness and distances at the top left. Saved pictures contain this text. If a view shows
 * several comparisons, the text is that of the last one.
 */

#ifndef pqLMS3DResultText_h
#define pqLMS3DResultText_h

#include "lms3dAutoStart.h"

#include <QMap>

#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

class pqPipelineSource;
class pqView;

class pqLMS3DResultText : public lms3dAutoStart
{
  Q_OBJECT

public:
  void startup() override;
  void shutdown() override;

private Q_SLOTS:
  void watch(pqView* added);
  void forget(pqView* removed);
  void updateView();
  void updateViews(pqPipelineSource* updated);

private:
  void write(pqView* view);

  QMap<pqView*, vtkSmartPointer<vtkTextActor>> Texts;
};

#endif
