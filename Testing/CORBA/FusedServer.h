// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A server that keeps a map of many scans, for tests.
 */
#ifndef FusedServer_h
#define FusedServer_h

#include "ClientORB.h"
#include "ServerProcess.h"

#include <string>
#include <vector>

/// Metres.
constexpr double FusedBound = 0.02;

inline std::vector<LMS3D::Pose> GetFusedPoses()
{
  return { At(0.3, -0.2, 1.0), At(-1.0, -0.2, 1.0), At(0.5, 0.4, 1.2), At(1.0, 0.5, 1.0) };
}

inline void MoveTo(LMS3D::LaserScanner_ptr scanner, const LMS3D::Pose& pose)
{
  WaitFor(scanner, scanner->setPose(pose));
}

/// Has not scanned from any pose but the first.
class FusedServer : public ServerProcess
{
public:
  explicit FusedServer(const std::vector<std::string>& more = {})
    : ServerProcess(GetArguments(more))
  {
  }

  LMS3D::LaserScanner_var Connect() const
  {
    const LMS3D::LaserScanner_var scanner = ::Connect(this->GetCorbaloc());
    WaitFor(scanner);
    return scanner;
  }

private:
  static std::vector<std::string> GetArguments(const std::vector<std::string>& more)
  {
    std::vector<std::string> arguments = { "--fused-map", "0.02", "--map-error", "0.02",
      "--position", "0.3", "-0.2", "1" };
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
};

#endif
