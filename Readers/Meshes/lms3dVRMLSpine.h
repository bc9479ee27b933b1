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

/// The axes of the spine-aligned cross-section plane at a point of the spine. Y is along the spine.
/// All have length 1, or 0 if the spine has no extent.
struct lms3dSpineFrame
{
  lms3dVector X;
  lms3dVector Y;
  lms3dVector Z;
};

/// Returns one frame for each point. Requires at least two points, all finite.
std::vector<lms3dSpineFrame> lms3dMakeSpineFrames(const std::vector<lms3dVector>& spine);

#endif
