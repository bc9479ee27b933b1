// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The threads that talk to servers.
 */
#ifndef lms3dRemoteThreads_h
#define lms3dRemoteThreads_h

#include <future>
#include <list>
#include <memory>
#include <mutex>

class lms3dRemoteWatch;

/**
 * A thread that waits for a server cannot be woken, so who stops a watch does not wait for its thread:
 * it ends by itself, and is joined when the next starts or, at the latest, when the process ends,
 * before the ORB's library is gone.
 */
class lms3dRemoteThreads
{
public:
  static lms3dRemoteThreads& GetInstance();

  void Start(std::shared_ptr<lms3dRemoteWatch> watch);

private:
  struct Runner
  {
    std::shared_ptr<lms3dRemoteWatch> Watch;
    /// Waits for the thread at its destruction.
    std::future<void> End;
  };

  lms3dRemoteThreads() = default;
  ~lms3dRemoteThreads();

  std::mutex Mutex;
  std::list<Runner> Runners;
};

#endif
