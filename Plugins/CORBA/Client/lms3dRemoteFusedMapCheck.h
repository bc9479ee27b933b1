// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Validates the changes of the fused map that a server sends.
 */
#ifndef lms3dRemoteFusedMapCheck_h
#define lms3dRemoteFusedMapCheck_h

#include "Client/lms3dFusedMapChanges.h"

/// The largest number of points of a map.
constexpr CORBA::ULong lms3dMaximumFusedPoints = 16000000;

///@{
/// Throw std::runtime_error if the values are not as LMS3DScanner.idl demands. `since` is the state
/// that the client asked for. Check the header before fetching the arrays, whose checksum is
/// compared too. The limit is 16,000,000 regions, as many points, and twice as many triangles.
void lms3dCheckFusedMapHeader(const LMS3D::FusedMapHeader& header, CORBA::ULongLong since);
void lms3dCheckFusedMapChanges(const lms3dFusedMapChanges& changes);
///@}

#endif
