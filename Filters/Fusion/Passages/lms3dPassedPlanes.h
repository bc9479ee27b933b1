// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Marks where beams passed through the planes of a fused map.
 */
#ifndef lms3dPassedPlanes_h
#define lms3dPassedPlanes_h

#include "Fusion/Planes/lms3dFusedPlanes.h"
#include "Fusion/Scans/lms3dSeenRanges.h"

#include <memory>
#include <vector>

///@{
/// Uses the threads of the calling TBB arena. Marks where the beams of a scan passed. If `forgets`,
/// returns there go.
void lms3dMarkPassed(const lms3dSeenRanges& ranges, bool forgets, lms3dFusedPlanes& planes);

/// Marks where beams of earlier scans passed through new blocks.
void lms3dMarkPassedEarlier(
  const std::vector<std::unique_ptr<lms3dSeenRanges>>& earlier, lms3dFusedPlanes& planes);
///@}

#endif
