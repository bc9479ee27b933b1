// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqLMS3DStartScans
 * @brief gives a new map fusion the scans of its maps
 *
 * If all maps of a fusion that the user makes in the window come from LMS3D Surface Reconstruction,
 * Scan starts with the inputs of these filters. Otherwise it starts empty. Scripts and states keep
 * their scans.
 */

#ifndef pqLMS3DStartScans_h
#define pqLMS3DStartScans_h

#include "lms3dAutoStart.h"

class pqPipelineSource;

class pqLMS3DStartScans : public lms3dAutoStart
{
  Q_OBJECT

public:
  void startup() override;

private Q_SLOTS:
  void addScans(pqPipelineSource* created);
};

#endif
