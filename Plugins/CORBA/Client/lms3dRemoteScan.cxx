// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Client/lms3dRemoteScan.h"

#include "Client/lms3dFetchParts.h"
#include "Client/lms3dRemoteCheck.h"

#include <thread>

namespace
{
// Older servers have an ideal device, and no such operation.
LMS3D::Device FetchDevice(LMS3D::LaserScanner_ptr scanner, CORBA::ULongLong number)
{
  try
  {
    const LMS3D::Device_var device = scanner->getScanDevice(number);
    return device.in();
  }
  catch (const CORBA::BAD_OPERATION&)
  {
    return lms3dGetIdealDevice();
  }
}
} // namespace

lms3dRemoteScan lms3dFetchScan(LMS3D::LaserScanner_ptr scanner, const LMS3D::ScanHeader& header,
  const std::function<void()>& beforePart)
{
  lms3dCheckHeader(header);
  lms3dRemoteScan scan;
  scan.Header = header;
  const CORBA::ULongLong number = header.number;
  beforePart();
  scan.Device = FetchDevice(scanner, number);
  lms3dCheckDevice(scan);
  lms3dFetchParts<LMS3D::Ranges>(
    header.beams, 1, beforePart,
    [&](CORBA::ULong first, CORBA::ULong count)
    { return scanner->getRanges(number, first, count); },
    scan.Ranges);
  lms3dFetchParts<LMS3D::BeamStatuses>(
    scan.Device.computeStatus ? header.beams : 0, 1, beforePart,
    [&](CORBA::ULong first, CORBA::ULong count)
    { return scanner->getBeamStatuses(number, first, count); },
    scan.Statuses);
  lms3dFetchParts<LMS3D::Coordinates>(
    header.mapPoints, 3, beforePart,
    [&](CORBA::ULong first, CORBA::ULong count)
    { return scanner->getMapPoints(number, first, count); },
    scan.MapPoints);
  lms3dFetchParts<LMS3D::Indices>(
    header.mapTriangles, 3, beforePart,
    [&](CORBA::ULong first, CORBA::ULong count)
    { return scanner->getMapTriangles(number, first, count); },
    scan.MapTriangles);
  lms3dCheckArrays(scan);
  return scan;
}

LMS3D::ScanHeader* lms3dWaitForScan(LMS3D::LaserScanner_ptr scanner, CORBA::ULongLong after,
  CORBA::ULongLong generation, CORBA::ULong timeout, std::chrono::milliseconds pause)
{
  try
  {
    return scanner->waitForScan(after, generation, timeout);
  }
  catch (const LMS3D::LimitExceeded&)
  {
    std::this_thread::sleep_for(pause);
  }
  LMS3D::ScanHeader_var header = scanner->getHeader();
  if (header->number <= after || header->generation < generation)
  {
    throw LMS3D::NoScanYet(header->number);
  }
  return header._retn();
}
