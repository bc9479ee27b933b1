// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dPolarData.h"

#include "lms3dGridGeometry.h"

LMS3D::Data* lms3dMakePolarData(const lms3dSnapshot& snapshot)
{
  const lms3dScanGeometry geometry = lms3dGetGeometry(snapshot.Header.settings);
  const CORBA::ULong length = 3 * snapshot.Header.beams;
  CORBA::Float* const buffer = LMS3D::Data::allocbuf(length);
  CORBA::Float* next = buffer;
  const float* range = snapshot.Ranges.data();
  for (const double beta : geometry.GetBetaAngles())
  {
    for (const double alpha : geometry.GetAlphaAngles())
    {
      next[0] = *range++;
      next[1] = static_cast<CORBA::Float>(alpha);
      next[2] = static_cast<CORBA::Float>(beta);
      next += 3;
    }
  }
  return new LMS3D::Data(length, length, buffer, true);
}
