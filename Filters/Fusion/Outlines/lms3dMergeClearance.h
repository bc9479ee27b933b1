// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Whether a merge of corners stays apart from all other edges.
 */
#ifndef lms3dMergeClearance_h
#define lms3dMergeClearance_h

#include "Fusion/Outlines/lms3dCornerMerge.h"
#include "Fusion/Outlines/lms3dOutlineCorners.h"

#include <vector>

/// Returns whether no other edge lies in the triangles between the outlines before and after a
/// merge, nor meets them. `chain` are the corners of the outline before the merge, with both
/// neighbours. `left` has all corners that have not gone.
bool lms3dIsMergeApart(const lms3dCornerMerge& merge,
  const std::vector<lms3dOutlineCorners::Corner>& chain,
  const std::vector<lms3dOutlineCorners::Corner>& left, const lms3dOutlineCorners& corners);

#endif
