// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqLMS3DStartPose
 * @brief puts the sensor of a new scan into its scene
 *
 * The sensor starts at the centre of the scene, 1 m above its lowest point, or at half of the
 * scene's height if this is lower. This holds for a scan that the user makes in the window.
 * Scripts, states, and a default that the user has saved keep their position.
 */

#ifndef pqLMS3DStartPose_h
#define pqLMS3DStartPose_h

#include "lms3dAutoStart.h"

class pqPipelineSource;

class pqLMS3DStartPose : public lms3dAutoStart
{
  Q_OBJECT

public:
  void startup() override;

private Q_SLOTS:
  void place(pqPipelineSource* created);
};

#endif
