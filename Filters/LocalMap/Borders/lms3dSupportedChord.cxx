// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Borders/lms3dSupportedChord.h"

#include "LocalMap/Borders/lms3dRangeSupport.h"

#include <cmath>

namespace
{
// How often the interval in which the support ends is divided by four.
constexpr int Divisions = 4;
} // namespace

double lms3dSupportedChord::FindEnd(double maximum) const
{
  if (this->IsSupported(maximum))
  {
    return maximum;
  }
  double within = 0.0;
  double beyond = maximum;
  for (int i = 0; i < Divisions; ++i)
  {
    const double middle = 0.5 * (within + beyond);
    const double near = 0.5 * (within + middle);
    const double far = 0.5 * (middle + beyond);
    const bool isMiddleWithin = this->IsSupported(middle);
    const bool isNearWithin = this->IsSupported(near);
    const bool isFarWithin = this->IsSupported(far);
    const bool isWithin = isMiddleWithin ? isFarWithin : isNearWithin;
    const double second = isMiddleWithin ? far : near;
    within = isWithin ? second : (isMiddleWithin ? middle : within);
    beyond = isWithin ? (isMiddleWithin ? beyond : middle) : second;
  }
  return within;
}

// Does not call lms3dRangeInterval::Contains(): FindEnd() needs the results of three positions at
// once, so no branch may depend on a part of a condition.
bool lms3dSupportedChord::IsSupported(double at) const
{
  // The distance of the point on the chord from the sensor.
  const double length = std::sqrt(1.0 - 2.0 * at * (1.0 - at) * (1.0 - this->Cosine));
  const lms3dRangeInterval interval = lms3dRangeSupport::GetInterval(
    this->Range, this->Margin, (1.0 - at + at * this->Cosine) / length);
  const double inverse = (this->Inverse + at * this->Change) / length;
  return (inverse * interval.Nearest <= 1.0) & (inverse * interval.Farthest >= 1.0);
}
