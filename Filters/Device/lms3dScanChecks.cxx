// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Device/lms3dScanChecks.h"

#include "Device/lms3dScanGeometry.h"
#include "Pipeline/lms3dText.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace
{
// Squares of larger coordinates exceed the range of single precision.
constexpr double MaximumCoordinate = 1e18;
// How far the axes of a pose may be from orthonormal ones.
constexpr double AxisTolerance = 1e-6;

// Returns whether the ends increase. A single beam or turn uses only the first.
bool IsProperRange(const double range[2], int resolution)
{
  return range[0] < range[1] || (resolution == 1 && range[0] == range[1]);
}

bool IsWithinACircle(const double range[2])
{
  const double extent = range[1] - range[0];
  return extent <= 360.0 || lms3dIsFullCircle(extent);
}

bool IsFiniteRange(const double range[2])
{
  return std::isfinite(range[0]) && std::isfinite(range[1]);
}
} // namespace

bool lms3dIsPosition(const lms3dVector& position)
{
  return std::all_of(
    position.begin(), position.end(), [](double x) { return std::abs(x) <= MaximumCoordinate; });
}

std::string lms3dFindPoseError(const lms3dVector& position, const lms3dVector& orientation)
{
  if (!lms3dIsPosition(position) || !lms3dIsFinite(orientation))
  {
    return lms3dJoinText("The pose is Position ", position[0], ' ', position[1], ' ', position[2],
      ", Orientation ", orientation[0], ' ', orientation[1], ' ', orientation[2],
      "; finite numbers are expected, positions up to 1e18 m.");
  }
  return std::string();
}

std::string lms3dFindAxesError(const lms3dPose& pose)
{
  for (int i = 0; i < 3; ++i)
  {
    const double length = lms3dGetLength(pose.Axes[i]);
    if (!(std::abs(length - 1.0) <= AxisTolerance))
    {
      return lms3dJoinText("SensorToWorld of the scan scales an axis by ", length,
        ". A pose is a rotation and a translation, without a scale.");
    }
    if (!(std::abs(lms3dDot(pose.Axes[i], pose.Axes[(i + 1) % 3])) <= AxisTolerance))
    {
      return "SensorToWorld of the scan shears its axes. A pose is a rotation and a translation.";
    }
  }
  if (lms3dDot(lms3dCross(pose.Axes[0], pose.Axes[1]), pose.Axes[2]) < 0.0)
  {
    return "SensorToWorld of the scan is a mirror image. A pose is a rotation and a translation.";
  }
  return std::string();
}

std::string lms3dFindAngleError(
  const double alphaRange[2], int alphaResolution, const double betaRange[2], int betaResolution)
{
  if (alphaResolution < 1 || betaResolution < 1)
  {
    return lms3dJoinText("AlphaResolution x BetaResolution is ", alphaResolution, " x ",
      betaResolution, "; each must be at least 1.");
  }
  if (static_cast<std::int64_t>(alphaResolution) * betaResolution >
    std::numeric_limits<std::int32_t>::max())
  {
    return lms3dJoinText("AlphaResolution x BetaResolution is ", alphaResolution, " x ",
      betaResolution, " beams; at most 2147483647 are possible.");
  }
  if (!IsProperRange(alphaRange, alphaResolution) || alphaRange[0] < -90.0 || alphaRange[1] > 90.0)
  {
    return lms3dJoinText("AlphaRange is ", alphaRange[0], " to ", alphaRange[1],
      " degrees; it must increase, within -90 to 90.");
  }
  if (!IsFiniteRange(betaRange) || !IsProperRange(betaRange, betaResolution) ||
    !IsWithinACircle(betaRange))
  {
    return lms3dJoinText("BetaRange is ", betaRange[0], " to ", betaRange[1],
      " degrees; it must increase, by at most 360.");
  }
  return std::string();
}

std::string lms3dFindLimitError(const lms3dRangeLimits& limits)
{
  const bool areGood = limits.Minimum >= 0.0 && std::isfinite(limits.Minimum) &&
    limits.Minimum <= limits.Maximum && limits.Maximum > 0.0;
  if (!areGood)
  {
    return lms3dJoinText("MinimumRange and MaximumRange are ", limits.Minimum, " and ",
      limits.Maximum, " m; 0 <= minimum <= maximum and 0 < maximum are expected.");
  }
  return std::string();
}
