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
#include <vector>

/// Notifies the listeners of each scan. Neither the scanner nor other clients wait for a listener.
/// A listener that is removed occupies its place until its current call ends, so that the number of
/// threads is limited too. All methods but Start() and Stop() may be called from any thread.
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
  /// Throws LMS3D::InvalidArgument unless all its addresses are network addresses (see
  /// lms3dIsNetworkAddress()), LMS3D::LimitExceeded, or CORBA::TRANSIENT after Stop().
  CORBA::ULong Add(LMS3D::ScanListener_ptr reference);

  /// Returns false if there is no such subscription. No call begins after this returns. Does not
  /// wait for the current call.
  bool Remove(CORBA::ULong subscription);

  /// The number of listeners that have not failed.
  std::size_t GetNumber() const;

private:
  using List = std::vector<std::unique_ptr<lms3dListener>>;

  void Run();
  void NotifyAll(const LMS3D::ScanHeader& header);
  /// Removes the listeners that have failed, and returns those that have ended. Destroy them
  /// unlocked.
  List TakeEnded();
  ///@{
  /// The mutex must be locked.
  void RequireRoom(const std::string& address) const;
  CORBA::ULong MakeNumber() const;
  void RemoveFailed();
  ///@}

  const lms3dSnapshotStore& Store;
  mutable std::mutex Mutex;
  std::map<CORBA::ULong, std::unique_ptr<lms3dListener>> Listeners;
  /// Listeners that are removed, and whose current call may go on.
  List Ending;
  bool Stopped = false;
  std::thread Thread;
};

#endif
