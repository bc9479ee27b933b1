// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Remote/lms3dRemoteThreads.h"

#include "Remote/lms3dRemoteWatch.h"

#include <chrono>
#include <utility>

lms3dRemoteThreads& lms3dRemoteThreads::GetInstance()
{
  static lms3dRemoteThreads instance;
  return instance;
}

lms3dRemoteThreads::~lms3dRemoteThreads()
{
  for (const Runner& runner : this->Runners)
  {
    runner.Watch->Stop();
  }
}

void lms3dRemoteThreads::Start(std::shared_ptr<lms3dRemoteWatch> watch)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Runners.remove_if([](const Runner& runner)
    { return runner.End.wait_for(std::chrono::seconds(0)) == std::future_status::ready; });
  std::future<void> end = std::async(std::launch::async, [watch] { watch->Run(); });
  this->Runners.push_back({ std::move(watch), std::move(end) });
}
