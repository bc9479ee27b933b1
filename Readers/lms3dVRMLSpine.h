// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The frames along the spine of an Extrusion (ISO/IEC 14772-1, 6.18.3).
 */
#ifndef lms3dVRMLSpine_h
#define lms3dVRMLSpine_h

#include "Geometry/lms3dVector.h"

#include <vector>

/// The spine-aligned cross-section plane of a point.
struct lms3dSpineFrame
{
  lms3dVector X;
  lms3dVector Y;
  lms3dVector Z;
};

/// One for each point of a spine of at least two points.
std::vector<lms3dSpineFrame> lms3dMakeSpineFrames(const std::vector<lms3dVector>& spine);

#endif
