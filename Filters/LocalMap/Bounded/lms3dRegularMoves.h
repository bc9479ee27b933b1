// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Decides which moves of a vertex are allowed if beams are regular.
 */
#ifndef lms3dRegularMoves_h
#define lms3dRegularMoves_h

#include "LocalMap/Bounded/lms3dBeamDemands.h"
#include "LocalMap/Bounded/lms3dBorderShortcuts.h"
#include "LocalMap/Bounded/lms3dVertexMoves.h"

/// Borders may take shortcuts (lms3dBorderShortcuts), and demands of beams (lms3dBeamDemands) give
/// the bound.
class lms3dRegularMoves : public lms3dVertexMoves
{
public:
  /// Keeps references.
  lms3dRegularMoves(const lms3dBeamDemands& demands, const lms3dBorderShortcuts& shortcuts)
    : Demands(demands)
    , Shortcuts(shortcuts)
  {
  }

  bool MayLeaveBorder(const lms3dVertexStars& stars, std::int32_t last, std::int32_t middle,
    std::int32_t next) const override;
  bool MayLeaveOffset(const lms3dVertexStars& stars, std::int32_t last, std::int32_t middle,
    std::int32_t next) const override;
  bool KeepsBound(const lms3dVertexStars& stars, std::int32_t from, std::int32_t to) const override;

private:
  const lms3dBeamDemands& Demands;
  const lms3dBorderShortcuts& Shortcuts;
};

#endif
