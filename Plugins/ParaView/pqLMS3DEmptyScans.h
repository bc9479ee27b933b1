// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqLMS3DEmptyScans
 * @brief warns in Output Messages if no beam of a scan returned
 *
 * Without the warning a user sees an empty view. Warns once, and again only after a scan with
 * returns, so that a sensor that is dragged through empty space does not fill the messages.
 */

#ifndef pqLMS3DEmptyScans_h
#define pqLMS3DEmptyScans_h

#include "lms3dAutoStart.h"

#include <QSet>

class pqPipelineSource;

class pqLMS3DEmptyScans : public lms3dAutoStart
{
  Q_OBJECT

public:
  void startup() override;

private Q_SLOTS:
  void check(pqPipelineSource* updated);
  void forget(pqPipelineSource* removed);

private:
  QSet<pqPipelineSource*> Empty;
};

#endif
