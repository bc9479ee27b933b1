// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The threads that wait for servers.
 */
#ifndef lms3dRemoteThreads_h
#define lms3dRemoteThreads_h

#include <future>
#include <list>
#include <memory>
#include <mutex>

class lms3dRemoteWatch;

/**
 * A thread that waits for a server cannot be interrupted. So lms3dRemoteWatch::Stop() does not wait
 * for its thread. The thread ends later, and is joined when the next one starts or, at the latest,
 * when the process ends, before the ORB's library is unloaded.
 */
class lms3dRemoteThreads
{
public:
  static lms3dRemoteThreads& GetInstance();

  /// Runs `watch` in a new thread, which shares its ownership. Any thread.
  void Start(std::shared_ptr<lms3dRemoteWatch> watch);

private:
  struct Runner
  {
    std::shared_ptr<lms3dRemoteWatch> Watch;
    /// Its destructor waits for the thread.
    std::future<void> End;
  };

  lms3dRemoteThreads() = default;
  ~lms3dRemoteThreads();

  std::mutex Mutex;
  std::list<Runner> Runners;
};

#endif
