// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Changes of the map of many scans in the IDL's types, within the size of a message.
 */
#ifndef lms3dFusedMapReplies_h
#define lms3dFusedMapReplies_h

#include "LMS3DScanner.hh"
#include "Scanning/lms3dFusedMapState.h"

/// The header of the changes of a state since the state `since`, without the problem.
LMS3D::FusedMapHeader lms3dMakeFusedMapHeader(
  const lms3dFusedMapState& state, CORBA::ULongLong since, const lms3dFusedRegions& changes);

///@{
/// The caller owns the result. Throw LMS3D::InvalidArgument if there are fewer items than
/// `first` + `count`, LMS3D::LimitExceeded if they do not fit into a message.
LMS3D::FusedRegions* lms3dMakeFusedRegions(
  const lms3dFusedRegions& changes, CORBA::ULong first, CORBA::ULong count);
LMS3D::Offsets* lms3dMakeFusedPoints(
  const lms3dFusedRegions& changes, CORBA::ULong first, CORBA::ULong count);
LMS3D::Indices* lms3dMakeFusedTriangles(
  const lms3dFusedRegions& changes, CORBA::ULong first, CORBA::ULong count);
///@}

/// All changes. The caller owns the result. Throws LMS3D::LimitExceeded if they do not fit into a
/// message.
LMS3D::FusedMap* lms3dMakeFusedMap(
  const LMS3D::FusedMapHeader& header, const lms3dFusedRegions& changes);

#endif
