// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Object/lms3dSettingsCheck.h"

#include "Common/lms3dDeviceLimits.h"
#include "Device/lms3dScanGeometry.h"
#include "Object/lms3dReplies.h"

#include <cmath>
#include <limits>
#include <sstream>

namespace
{
constexpr double MaximumCoordinate = 1e6;
// Degrees. Within this limit, rounding changes an angle by less than 1e-10 degrees.
constexpr double MaximumOrientation = 1e6;
constexpr double FullCircle = 360.0;

// The message is "NAME is VALUE; it must be DEMAND".
void Require(bool isValid, const char* name, double value, const char* demand)
{
  if (!isValid)
  {
    std::ostringstream reason;
    reason.precision(std::numeric_limits<double>::max_digits10);
    reason << name << " is " << value << "; it must be " << demand;
    throw LMS3D::InvalidArgument(lms3dMakeText(reason.str()));
  }
}

// False for NaN.
bool IsWithin(double value, double minimum, double maximum)
{
  return value >= minimum && value <= maximum;
}

// Degrees. Within these limits, neighbouring angles differ after rounding.
constexpr double MaximumAngle = 36000.0;
constexpr double MinimumSpan = 1e-6;

void CheckAxis(const LMS3D::Axis& axis, const char* start, const char* stop, const char* count)
{
  Require(std::abs(axis.start) <= MaximumAngle, start, axis.start, "within 36,000 degrees of 0");
  Require(axis.stop >= axis.start + MinimumSpan && axis.stop <= MaximumAngle, stop, axis.stop,
    "above the start, by 1e-6 degrees or more, and up to 36,000");
  Require(axis.count >= 1, count, axis.count, "at least 1");
}

void RequireLength(const char* name, double value)
{
  Require(IsWithin(value, 0.0, lms3dMaximumLength), name, value, "from 0 to 1e6");
}

void CheckBeams(const LMS3D::Configuration& configuration)
{
  const CORBA::ULongLong beams =
    CORBA::ULongLong(configuration.alpha.count) * configuration.beta.count;
  if (beams > lms3dMaximumBeams)
  {
    throw LMS3D::LimitExceeded(
      lms3dMakeText("alpha.count * beta.count is " + std::to_string(beams)), lms3dMaximumBeams);
  }
}
} // namespace

LMS3D::Configuration lms3dDefaultConfiguration()
{
  LMS3D::Configuration configuration;
  configuration.alpha = { -90.0, 90.0, 361 };
  configuration.beta = { 0.0, FullCircle, 360 };
  configuration.minimumRange = 0.0;
  configuration.maximumRange = 80.0;
  configuration.method = LMS3D::METHOD_EXACT;
  configuration.makeMap = true;
  configuration.mapError = 0.01;
  return configuration;
}

void lms3dCheckPose(const LMS3D::Pose& pose)
{
  const LMS3D::Vector3& position = pose.position;
  for (double coordinate : { position.x, position.y, position.z })
  {
    Require(IsWithin(coordinate, -MaximumCoordinate, MaximumCoordinate),
      "a coordinate of the position", coordinate, "within 1e6 m of the origin");
  }
  const LMS3D::Vector3& orientation = pose.orientation;
  for (double angle : { orientation.x, orientation.y, orientation.z })
  {
    Require(IsWithin(angle, -MaximumOrientation, MaximumOrientation), "an angle of the orientation",
      angle, "within 1e6 degrees of 0");
  }
}

void lms3dCheckConfiguration(const LMS3D::Configuration& configuration)
{
  const LMS3D::Axis& alpha = configuration.alpha;
  CheckAxis(alpha, "alpha.start", "alpha.stop", "alpha.count");
  Require(alpha.start >= -90.0, "alpha.start", alpha.start, "at least -90");
  Require(alpha.stop <= 90.0, "alpha.stop", alpha.stop, "at most 90");
  const LMS3D::Axis& beta = configuration.beta;
  CheckAxis(beta, "beta.start", "beta.stop", "beta.count");
  const double extent = beta.stop - beta.start;
  Require(extent <= FullCircle || lms3dIsFullCircle(extent), "beta.stop - beta.start", extent,
    "at most 360");
  CheckBeams(configuration);

  const double maximum = configuration.maximumRange;
  Require(maximum > 0.0 && std::isfinite(maximum), "maximumRange", maximum, "above 0 and finite");
  Require(IsWithin(configuration.minimumRange, 0.0, maximum), "minimumRange",
    configuration.minimumRange, "from 0 to maximumRange");
  Require(configuration.mapError >= 0.0 && std::isfinite(configuration.mapError), "mapError",
    configuration.mapError, "at least 0 and finite");
}

void lms3dCheckDevice(const LMS3D::Device& device)
{
  Require(std::abs(device.rangeBias) <= lms3dMaximumLength, "rangeBias", device.rangeBias,
    "within 1e6 m of 0");
  RequireLength("rangeNoise", device.rangeNoise);
  RequireLength("rangeResolution", device.rangeResolution);
  RequireLength("beamDiameter", device.beamDiameter);
  Require(IsWithin(device.beamDivergence, 0.0, lms3dMaximumDivergence), "beamDivergence",
    device.beamDivergence, "from 0 to 1");
  Require(device.beamSamples >= 1 && device.beamSamples <= lms3dMaximumSamples, "beamSamples",
    device.beamSamples, "from 1 to 1,000");
  RequireLength("pulseLength", device.pulseLength);
  RequireLength("rangeAtTenPercent", device.rangeAtTenPercent);
  const LMS3D::Vector3& offset = device.axisOffset;
  for (const double coordinate : { offset.x, offset.y, offset.z })
  {
    Require(std::abs(coordinate) <= lms3dMaximumLength, "a coordinate of axisOffset", coordinate,
      "within 1e6 m of 0");
  }
  Require(std::abs(device.turnRate) <= lms3dMaximumTurnRate, "turnRate", device.turnRate,
    "within 1e6 degrees per second of 0");
}

void lms3dCheckRays(const LMS3D::Configuration& configuration, const LMS3D::Device& device)
{
  const CORBA::ULongLong rays =
    CORBA::ULongLong(configuration.alpha.count) * configuration.beta.count * device.beamSamples;
  if (rays > lms3dMaximumRays)
  {
    throw LMS3D::LimitExceeded(
      lms3dMakeText("alpha.count * beta.count * beamSamples is " + std::to_string(rays)),
      lms3dMaximumRays);
  }
}
