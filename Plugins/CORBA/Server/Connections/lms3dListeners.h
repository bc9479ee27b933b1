// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The clients' objects that are told of each scan.
 */
#ifndef lms3dListeners_h
#define lms3dListeners_h

#include "lms3dListener.h"
#include "lms3dSnapshotStore.h"

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

/// Neither the scanner nor clients that ask wait for any of them.
class lms3dListeners
{
public:
  static constexpr std::size_t Most = 16;
  /// Of one client, which is one address, so that it leaves room for others.
  static constexpr std::size_t MostOfAddress = 4;

  /// The store must outlive this, and be stopped before Stop().
  explicit lms3dListeners(const lms3dSnapshotStore& store);
  ~lms3dListeners();
  lms3dListeners(const lms3dListeners&) = delete;
  void operator=(const lms3dListeners&) = delete;

  void Start();
  /// Nobody is told after it, so that the ORB may be destroyed.
  void Stop();

  /// Returns the number of the subscription, which nobody can guess. Throws LMS3D::LimitExceeded, and
  /// CORBA::TRANSIENT after Stop().
  CORBA::ULong Add(LMS3D::ScanListener_ptr reference);
  /// False where there is no such subscription. It is told no more when this returns.
  bool Remove(CORBA::ULong subscription);
  std::size_t GetNumber() const;

private:
  using Table = std::map<CORBA::ULong, std::unique_ptr<lms3dListener>>;

  void Run();
  void TellAll(const LMS3D::ScanHeader& header);
  Table TakeThoseLeftOut();
  ///@{
  /// The mutex must be locked.
  void RequireRoom(const std::string& address) const;
  CORBA::ULong MakeNumber() const;
  ///@}

  const lms3dSnapshotStore& Store;
  mutable std::mutex Mutex;
  Table Listeners;
  bool Stopped = false;
  std::thread Thread;
};

#endif
