// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dRayCaster.h"

namespace
{
lms3dNewRayCaster* const Methods[] = { lms3dNewExactCaster, lms3dNewFastCaster,
  lms3dNewAngleSumCaster, lms3dNewMollerTrumboreCaster, lms3dNewStaticCellLocatorCaster };
}

std::unique_ptr<lms3dRayCaster> lms3dRayCaster::New(int method, lms3dTriangleMesh mesh)
{
  return Methods[method](std::move(mesh));
}
