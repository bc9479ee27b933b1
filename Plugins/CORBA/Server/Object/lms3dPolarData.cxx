// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Object/lms3dPolarData.h"

#include "Common/lms3dGridGeometry.h"
#include "Common/lms3dMessageLimit.h"

#include <algorithm>

namespace
{
std::vector<CORBA::Float> MakeNumbers(const lms3dSnapshot& snapshot)
{
  const lms3dScanGeometry geometry = lms3dGetGeometry(snapshot.Header.settings, snapshot.Device);
  std::vector<CORBA::Float> numbers(3 * snapshot.Ranges.size());
  CORBA::Float* next = numbers.data();
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
  return numbers;
}
} // namespace

LMS3D::Data* lms3dPolarData::Get(const lms3dSnapshot& snapshot)
{
  const CORBA::ULongLong count = 3 * CORBA::ULongLong(snapshot.Header.beams);
  if (count > lms3dGetMaximumElements(sizeof(CORBA::Float)))
  {
    throw CORBA::IMP_LIMIT(0, CORBA::COMPLETED_NO);
  }
  const Numbers numbers = this->Find(snapshot);
  const CORBA::ULong length = static_cast<CORBA::ULong>(count);
  CORBA::Float* const buffer = LMS3D::Data::allocbuf(length);
  std::copy_n(numbers->data(), length, buffer);
  return new LMS3D::Data(length, length, buffer, true);
}

// Other clients of the same scan wait while one computes the numbers.
lms3dPolarData::Numbers lms3dPolarData::Find(const lms3dSnapshot& snapshot)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (this->ScanNumber != snapshot.Header.number)
  {
    this->Last = std::make_shared<const std::vector<CORBA::Float>>(MakeNumbers(snapshot));
    this->ScanNumber = snapshot.Header.number;
  }
  return this->Last;
}
