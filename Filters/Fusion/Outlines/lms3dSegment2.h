// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A part of a straight line in a plane.
 */
#ifndef lms3dSegment2_h
#define lms3dSegment2_h

#include "Triangulation/lms3dOrientation.h"

#include <algorithm>
#include <limits>

/// Keeps a reference to its first end.
class lms3dSegment2
{
public:
  lms3dSegment2(const lms3dPoint2& a, const lms3dPoint2& b)
    : Start(a)
    , Du(b[0] - a[0])
    , Dv(b[1] - a[1])
    , Inverse(GetInverse(this->Du * this->Du + this->Dv * this->Dv))
  {
  }

  double GetSquaredDistance(const lms3dPoint2& p) const
  {
    const double pu = p[0] - this->Start[0];
    const double pv = p[1] - this->Start[1];
    const double share = std::clamp((pu * this->Du + pv * this->Dv) * this->Inverse, 0.0, 1.0);
    const double u = pu - share * this->Du;
    const double v = pv - share * this->Dv;
    return u * u + v * v;
  }

private:
  static double GetInverse(double square)
  {
    return square > std::numeric_limits<double>::min() ? 1.0 / square : 0.0;
  }

  const lms3dPoint2& Start;
  const double Du;
  const double Dv;
  /// 1 by the squared length; 0 if this is 0 or underflows.
  const double Inverse;
};

#endif
