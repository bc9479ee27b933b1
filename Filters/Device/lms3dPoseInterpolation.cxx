// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Device/lms3dPoseInterpolation.h"

#include "Geometry/lms3dVector.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{
// Below this angle, radians, sines are equal to their angles to the last digit.
constexpr double SmallAngle = 1e-8;

lms3dQuaternion Normalize(lms3dQuaternion q)
{
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  std::transform(q.begin(), q.end(), q.begin(), [length](double x) { return x / length; });
  return q;
}

lms3dQuaternion Combine(
  const lms3dQuaternion& a, double weightA, const lms3dQuaternion& b, double weightB)
{
  lms3dQuaternion sum;
  for (std::size_t i = 0; i < sum.size(); ++i)
  {
    sum[i] = weightA * a[i] + weightB * b[i];
  }
  return Normalize(sum);
}

} // namespace

lms3dQuaternion lms3dToQuaternion(const std::array<std::array<double, 3>, 3>& axes)
{
  // The largest of the four components is found first; the others are quotients by it (Shepperd
  // 1978).
  const auto& [x, y, z] = axes;
  const lms3dQuaternion squares = { 1.0 + x[0] + y[1] + z[2], 1.0 + x[0] - y[1] - z[2],
    1.0 - x[0] + y[1] - z[2], 1.0 - x[0] - y[1] + z[2] };
  lms3dQuaternion q;
  switch (std::max_element(squares.begin(), squares.end()) - squares.begin())
  {
    case 0:
      q = { squares[0], y[2] - z[1], z[0] - x[2], x[1] - y[0] };
      break;
    case 1:
      q = { y[2] - z[1], squares[1], x[1] + y[0], z[0] + x[2] };
      break;
    case 2:
      q = { z[0] - x[2], x[1] + y[0], squares[2], y[2] + z[1] };
      break;
    default:
      q = { x[1] - y[0], z[0] + x[2], y[2] + z[1], squares[3] };
      break;
  }
  if (q[0] < 0.0)
  {
    std::transform(q.begin(), q.end(), q.begin(), [](double c) { return -c; });
  }
  return Normalize(q);
}

std::array<std::array<double, 3>, 3> lms3dToAxes(const lms3dQuaternion& quaternion)
{
  const auto [w, x, y, z] = quaternion;
  const double s = 2.0 / (w * w + x * x + y * y + z * z);
  return { lms3dVector{ 1.0 - s * (y * y + z * z), s * (x * y + w * z), s * (x * z - w * y) },
    lms3dVector{ s * (x * y - w * z), 1.0 - s * (x * x + z * z), s * (y * z + w * x) },
    lms3dVector{ s * (x * z + w * y), s * (y * z - w * x), 1.0 - s * (x * x + y * y) } };
}

lms3dPoseSegment::lms3dPoseSegment(const lms3dPose& from, const lms3dPose& to)
  : From(from)
  , To(to)
  , First(lms3dToQuaternion(from.Axes))
  , Last(lms3dToQuaternion(to.Axes))
{
  double cosine = 0.0;
  for (std::size_t i = 0; i < this->First.size(); ++i)
  {
    cosine += this->First[i] * this->Last[i];
  }
  if (cosine < 0.0)
  {
    // The opposite quaternion is the same rotation.
    std::transform(
      this->Last.begin(), this->Last.end(), this->Last.begin(), [](double x) { return -x; });
    cosine = -cosine;
  }
  this->Angle = std::acos(std::min(cosine, 1.0));
}

lms3dQuaternion lms3dPoseSegment::Slerp(double share) const
{
  return this->Angle < SmallAngle ? Combine(this->First, 1.0 - share, this->Last, share)
                                  : Combine(this->First, std::sin((1.0 - share) * this->Angle),
                                      this->Last, std::sin(share * this->Angle));
}

lms3dPose lms3dPoseSegment::Interpolate(double share) const
{
  if (share == 0.0 || share == 1.0)
  {
    return share == 0.0 ? this->From : this->To;
  }
  lms3dPose pose = this->From;
  for (std::size_t axis = 0; axis < pose.Position.size(); ++axis)
  {
    const double from = this->From.Position[axis];
    const double to = this->To.Position[axis];
    pose.Position[axis] = from == to ? from : from * (1.0 - share) + to * share;
  }
  if (this->From.Axes != this->To.Axes)
  {
    pose.Axes = lms3dToAxes(this->Slerp(share));
  }
  return pose;
}

lms3dPose lms3dInterpolate(const lms3dPose& from, const lms3dPose& to, double share)
{
  return lms3dPoseSegment(from, to).Interpolate(share);
}
