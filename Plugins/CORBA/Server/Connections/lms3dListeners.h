// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The subscribed listeners of all clients.
 */
#ifndef lms3dListeners_h
#define lms3dListeners_h

#include "Connections/lms3dListener.h"
#include "Scanning/lms3dSnapshotStore.h"

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

/// Notifies the listeners of each scan. Neither the scanner nor other clients wait for a listener.
/// All methods but Start() and Stop() may be called from any thread.
class lms3dListeners
{
public:
  static constexpr std::size_t Maximum = 16;
  /// One client has one address, and must leave room for others.
  static constexpr std::size_t MaximumPerAddress = 4;

  /// `store` must outlive this object, and must be stopped before Stop().
  explicit lms3dListeners(const lms3dSnapshotStore& store);
  ~lms3dListeners();
  lms3dListeners(const lms3dListeners&) = delete;
  void operator=(const lms3dListeners&) = delete;

  void Start();
  /// Waits for the current calls. No listener is called afterwards, so the ORB may be destroyed.
  void Stop();

  /// Returns the number of the subscription, which is random so that other clients cannot guess it.
  /// Throws LMS3D::LimitExceeded, or CORBA::TRANSIENT after Stop().
  CORBA::ULong Add(LMS3D::ScanListener_ptr reference);

  /// Returns false if there is no such subscription. The listener is not called after this returns.
  bool Remove(CORBA::ULong subscription);

  /// The number of listeners that have not failed.
  std::size_t GetNumber() const;

private:
  using Table = std::map<CORBA::ULong, std::unique_ptr<lms3dListener>>;

  void Run();
  void NotifyAll(const LMS3D::ScanHeader& header);
  /// Removes the listeners that have failed. Their threads end with the result, so destroy it
  /// unlocked.
  Table TakeFailed();
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
