// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dAngleSumTest.h"
#include "Casting/lms3dBruteForceCaster.h"

std::unique_ptr<lms3dRayCaster> lms3dNewAngleSumCaster(lms3dTriangleMesh mesh, const lms3dProgress&)
{
  return std::make_unique<lms3dBruteForceCaster<lms3dAngleSumTest>>(std::move(mesh));
}
