// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The part of a quadrilateral in a plane that lies behind another plane.
 */
#ifndef lms3dCutPolygon_h
#define lms3dCutPolygon_h

#include "Triangulation/lms3dOrientation.h"

#include <array>
#include <cstddef>

/// A corner of a polygon in a plane, and its height above another plane, metres.
struct lms3dCutCorner
{
  lms3dPoint2 Place;
  double Height;
};

/// The corners of a small polygon.
class lms3dCutPolygon
{
public:
  void Add(const lms3dPoint2& point) { this->Points[this->Count++] = point; }
  std::size_t size() const { return this->Count; }
  const lms3dPoint2& operator[](std::size_t i) const { return this->Points[i]; }
  const lms3dPoint2* begin() const { return this->Points.data(); }
  const lms3dPoint2* end() const { return this->Points.data() + this->Count; }

private:
  std::array<lms3dPoint2, 8> Points = {};
  std::size_t Count = 0;
};

/// The part of a convex polygon that lies lower than a height.
inline lms3dCutPolygon lms3dClip(const std::array<lms3dCutCorner, 4>& corners, double height)
{
  lms3dCutPolygon clipped;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const lms3dCutCorner& a = corners[i];
    const lms3dCutCorner& b = corners[(i + 1) % corners.size()];
    if (a.Height < height)
    {
      clipped.Add(a.Place);
    }
    if ((a.Height < height) != (b.Height < height))
    {
      const double share = (height - a.Height) / (b.Height - a.Height);
      clipped.Add({ a.Place[0] + share * (b.Place[0] - a.Place[0]),
        a.Place[1] + share * (b.Place[1] - a.Place[1]) });
    }
  }
  return clipped;
}

#endif
