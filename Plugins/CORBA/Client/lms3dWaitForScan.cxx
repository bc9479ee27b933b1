// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dWaitForScan.h"

#include <thread>

LMS3D::ScanHeader* lms3dWaitForScan(LMS3D::LaserScanner_ptr scanner, CORBA::ULongLong after,
  CORBA::ULongLong generation, CORBA::ULong milliseconds, std::chrono::milliseconds pause)
{
  try
  {
    return scanner->waitForScan(after, generation, milliseconds);
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
