// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Packets of beams in any direction, for tests below VTK.
 */
#ifndef BeamFixtures_h
#define BeamFixtures_h

#include "Fixtures/MeshFixtures.h"
#include "Kernels/lms3dBeamPacket.h"

#include <array>

using Beams = std::array<Vector, lms3dBeamPacket::Size>;

/// All beams of a packet the same.
Beams MakeSame(const Vector& direction);

/// A packet along some directions. Each component must be at most 1.
lms3dBeamPacket MakePacket(const Beams& directions);

#endif
