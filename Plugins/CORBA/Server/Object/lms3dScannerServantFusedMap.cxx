// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
// The operations of the scanner's object that are about the map of many scans.
#include "Object/lms3dFusedMapReplies.h"
#include "Object/lms3dReplies.h"
#include "Object/lms3dScannerServant.h"

LMS3D::FusedMapHeader* lms3dScannerServant::getFusedMapHeader(CORBA::ULongLong since)
{
  const lms3dFusedMapPointer state = this->GetNewestFusedMap();
  LMS3D::FusedMapHeader_var header =
    new LMS3D::FusedMapHeader(lms3dMakeFusedMapHeader(*state, since, state->GetChanges(since)));
  header->problem = lms3dMakeText(this->FusedMap.GetProblem());
  return header._retn();
}

LMS3D::FusedMap* lms3dScannerServant::getFusedMap(CORBA::ULongLong since)
{
  const lms3dFusedMapPointer state = this->GetNewestFusedMap();
  const lms3dFusedRegions changes = state->GetChanges(since);
  LMS3D::FusedMapHeader header = lms3dMakeFusedMapHeader(*state, since, changes);
  header.problem = lms3dMakeText(this->FusedMap.GetProblem());
  return lms3dMakeFusedMap(header, changes);
}

LMS3D::FusedRegions* lms3dScannerServant::getFusedRegions(
  CORBA::ULongLong number, CORBA::ULongLong since, CORBA::ULong first, CORBA::ULong count)
{
  return lms3dMakeFusedRegions(this->FindFusedMap(number)->GetChanges(since), first, count);
}

LMS3D::Offsets* lms3dScannerServant::getFusedPoints(
  CORBA::ULongLong number, CORBA::ULongLong since, CORBA::ULong first, CORBA::ULong count)
{
  return lms3dMakeFusedPoints(this->FindFusedMap(number)->GetChanges(since), first, count);
}

LMS3D::Indices* lms3dScannerServant::getFusedTriangles(
  CORBA::ULongLong number, CORBA::ULongLong since, CORBA::ULong first, CORBA::ULong count)
{
  return lms3dMakeFusedTriangles(this->FindFusedMap(number)->GetChanges(since), first, count);
}

CORBA::ULongLong lms3dScannerServant::resetFusedMap()
{
  this->RequireFusedMap();
  this->RequireWritable();
  return this->Board.BeginFusedMap();
}

void lms3dScannerServant::RequireFusedMap() const
{
  if (!this->Permissions.FusedMap)
  {
    throw LMS3D::NoFusedMap("the server was started without --fused-map");
  }
}

lms3dFusedMapPointer lms3dScannerServant::GetNewestFusedMap() const
{
  this->RequireFusedMap();
  lms3dFusedMapPointer state = this->FusedMap.GetNewest();
  if (!state)
  {
    throw LMS3D::NoFusedMap("no scan was made yet");
  }
  return state;
}

lms3dFusedMapPointer lms3dScannerServant::FindFusedMap(CORBA::ULongLong number) const
{
  lms3dFusedMapPointer state = this->FusedMap.Find(number);
  if (!state)
  {
    // In this order, so that newest >= oldest even if a state is published in between.
    const CORBA::ULongLong oldest = this->FusedMap.GetOldestNumber();
    throw LMS3D::FusedMapGone(oldest, this->FusedMap.GetNewestNumber());
  }
  return state;
}
