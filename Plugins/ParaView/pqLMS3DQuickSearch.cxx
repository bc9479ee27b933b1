// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqLMS3DQuickSearch.h"

#include <pqCoreUtilities.h>
#include <pqPVApplicationCore.h>

#include <QAction>
#include <QTimer>
#include <QWidget>

namespace
{
const char* const Filters[] = { "LMS3DScan", "LMS3DRangeError", "LMS3DSurfaceReconstruction",
  "LMS3DMapComparison", "LMS3DMapFusion", "LMS3DRemote" };
const char* const Words = " (lidar, laser, range)";
} // namespace

//------------------------------------------------------------------------------
void pqLMS3DQuickSearch::startup()
{
  if (pqPVApplicationCore* core = pqPVApplicationCore::instance())
  {
    this->listen(core, SIGNAL(aboutToShowQuickLaunch()), SLOT(addWords()));
  }
}

//------------------------------------------------------------------------------
// Before ParaView 5.13 the search copies the texts right after this call. The menus have their own
// texts back before the user can see them. Newer searches read the filters' short help, which has
// the words.
void pqLMS3DQuickSearch::addWords()
{
  for (const char* name : Filters)
  {
    for (QAction* entry : pqCoreUtilities::mainWidget()->findChildren<QAction*>(name))
    {
      const QString text = entry->text();
      entry->setText(text + Words);
      QTimer::singleShot(0, entry, [entry, text] { entry->setText(text); });
    }
  }
}
