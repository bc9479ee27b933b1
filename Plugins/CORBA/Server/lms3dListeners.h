// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The clients' objects that are told of each scan.
 */
#ifndef lms3dListeners_h
#define lms3dListeners_h

#include "LMS3DScanner.hh"
#include "lms3dSnapshotStore.h"

#include <cstddef>
#include <map>
#include <mutex>
#include <thread>

/// A thread of its own tells them, one after the other, so that a slow one delays neither the scanner
/// nor clients that ask.
class lms3dListeners
{
public:
  static constexpr std::size_t Most = 16;

  /// The store must outlive this, and be stopped before this ends.
  explicit lms3dListeners(const lms3dSnapshotStore& store);
  ~lms3dListeners();
  lms3dListeners(const lms3dListeners&) = delete;
  void operator=(const lms3dListeners&) = delete;

  void Start();

  /// Returns the number of the subscription, or 0 where there are too many.
  CORBA::ULong Add(LMS3D::ScanListener_ptr listener);
  /// False where there is no such subscription.
  bool Remove(CORBA::ULong subscription);
  std::size_t GetNumber() const;

private:
  struct Listener
  {
    LMS3D::ScanListener_var Reference;
    int Failures = 0;
  };

  void Run();
  void Tell(
    CORBA::ULong subscription, LMS3D::ScanListener_ptr listener, const LMS3D::ScanHeader& header);
  void Count(CORBA::ULong subscription, bool isReached);

  const lms3dSnapshotStore& Store;
  mutable std::mutex Mutex;
  std::map<CORBA::ULong, Listener> Listeners;
  CORBA::ULong Last = 0;
  std::thread Thread;
};

#endif
