// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Patches/lms3dOpenRuns.h"

#include "Geometry/lms3dWideLoops.h"

namespace
{
// Without branches, so that the compiler makes it a loop over vectors.
LMS3D_WIDE_LOOPS
void FindEnds(const std::int32_t* isOpen, const std::uint8_t* joins, int count, std::uint8_t* isEnd)
{
  for (int i = 0; i < count; ++i)
  {
    const int goesOn = joins[i] & lms3dBeamSphere::JoinedUp ? isOpen[i + 1] : 0;
    isEnd[i] = static_cast<std::uint8_t>(isOpen[i] & ~goesOn);
  }
}
} // namespace

void lms3dOpenRuns::MarkEnds(const std::uint8_t* joins, int count)
{
  this->IsOpen[count] = 0;
  FindEnds(this->IsOpen.data(), joins, count, this->IsEnd.data());
}
