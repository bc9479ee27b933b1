// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The results of the paper's fetch().
 */
#ifndef lms3dPolarData_h
#define lms3dPolarData_h

#include "LMS3DScanner.hh"
#include "Scanning/lms3dSnapshotStore.h"

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

/**
 * Range (metres), alpha and beta (degrees) of each beam, in the order of the grid. The numbers are
 * computed once for each scan, and each client gets a copy. Computing them takes several times as
 * long as copying them.
 */
class lms3dPolarData
{
public:
  /// The caller owns the result. Throws CORBA::IMP_LIMIT if it does not fit into a message. Any
  /// thread.
  LMS3D::Data* Get(const lms3dSnapshot& snapshot);

private:
  using Numbers = std::shared_ptr<const std::vector<CORBA::Float>>;

  Numbers Find(const lms3dSnapshot& snapshot);

  std::mutex Mutex;
  /// The scan of the last call, and its numbers.
  std::uint64_t ScanNumber = 0;
  Numbers Last;
};

#endif
