// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqLMS3DTimeSteps
 * @brief updates ParaView's animation when a scan gets a trajectory or when the trajectory changes
 *
 * ParaView requests the time steps of a filter only when the filter is new. A trajectory is
 * connected later, in the properties of the scan. Without this class the animation would not
 * include its times.
 */

#ifndef pqLMS3DTimeSteps_h
#define pqLMS3DTimeSteps_h

#include "lms3dAutoStart.h"

class pqPipelineSource;

class pqLMS3DTimeSteps : public lms3dAutoStart
{
  Q_OBJECT

public:
  void startup() override;

private Q_SLOTS:
  void updateTimeSteps(pqPipelineSource* updated);
};

#endif
