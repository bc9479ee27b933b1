// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Collects the joins of one turn while its pairs are classified.
 */
#ifndef lms3dTurnJoins_h
#define lms3dTurnJoins_h

#include "LocalMap/Grid/lms3dDepthStep.h"
#include "LocalMap/Grid/lms3dJoinResolver.h"

#include <cstdint>
#include <vector>

/// The flags of one turn and the pairs that are looked at again.
struct lms3dTurnJoins
{
  int Turn;
  std::uint8_t* Flags;
  std::vector<lms3dUncertainJoin>& UncertainJoins;
  std::vector<lms3dUncertainJoin>& Creases;

  void Add(int beam, lms3dJoinFlag towards, lms3dDepthStep::Relation relation)
  {
    if (lms3dDepthStep::IsOneSurface(relation))
    {
      this->Flags[beam] |= towards;
      if (relation == lms3dDepthStep::Crease)
      {
        this->Creases.push_back({ this->Turn, beam, towards, false });
      }
    }
    else if (relation != lms3dDepthStep::Separate)
    {
      this->UncertainJoins.push_back(
        { this->Turn, beam, towards, relation == lms3dDepthStep::Noisy });
    }
  }
};

#endif
