// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Device/lms3dTrajectory.h"

#include "Device/lms3dPoseInterpolation.h"
#include "Device/lms3dScanChecks.h"
#include "Geometry/lms3dVector.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <string>

namespace
{
[[noreturn]] void Fail(const std::string& what)
{
  throw std::runtime_error("The trajectory " + what);
}

// Returns the points of the polyline in its order, or all points if there is no line.
std::vector<vtkIdType> GetOrder(vtkPolyData* poses)
{
  const vtkIdType lines = poses->GetNumberOfLines();
  if (lines > 1)
  {
    Fail("has " + std::to_string(lines) +
      " lines, whose order is undefined. Join them to one polyline.");
  }
  std::vector<vtkIdType> order(poses->GetNumberOfPoints());
  std::iota(order.begin(), order.end(), 0);
  if (lines == 1)
  {
    vtkNew<vtkIdList> line;
    poses->GetLines()->GetCellAtId(0, line);
    order.assign(line->begin(), line->end());
  }
  const auto isNone = [poses](vtkIdType i) { return i < 0 || i >= poses->GetNumberOfPoints(); };
  if (std::any_of(order.begin(), order.end(), isNone))
  {
    Fail("has a polyline that uses missing points. Repair the polyline.");
  }
  if (order.empty())
  {
    Fail("has no points. Each point is a pose of the sensor.");
  }
  return order;
}

lms3dVector GetPosition(vtkPolyData* poses, vtkIdType point)
{
  lms3dVector position;
  poses->GetPoint(point, position.data());
  if (!lms3dIsPosition(position))
  {
    std::ostringstream text;
    text << "has its point " << point << " at " << position[0] << ' ' << position[1] << ' '
         << position[2] << ". Coordinates must be finite and at most 1e18 m.";
    Fail(text.str());
  }
  return position;
}

// Returns null if there is no such array.
vtkDataArray* GetArray(vtkPolyData* poses, const char* name, int components)
{
  vtkDataArray* array = poses->GetPointData()->GetArray(name);
  if (array && array->GetNumberOfComponents() != components)
  {
    Fail("has a point array " + std::string(name) + " of " +
      std::to_string(array->GetNumberOfComponents()) + " components. It must have " +
      (components == 1 ? "1, seconds." : "4, quaternions w x y z."));
  }
  if (array && array->GetNumberOfTuples() < poses->GetNumberOfPoints())
  {
    Fail("has " + std::to_string(poses->GetNumberOfPoints()) + " points, but only " +
      std::to_string(array->GetNumberOfTuples()) + " values in the array " + name + ".");
  }
  return array;
}

std::vector<double> GetTimes(vtkPolyData* poses, const std::vector<vtkIdType>& order)
{
  std::vector<double> times(order.size());
  vtkDataArray* array = GetArray(poses, "Time", 1);
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    times[i] = array ? array->GetTuple1(order[i]) : static_cast<double>(i);
    const bool isLater = i == 0 || times[i] > times[i - 1];
    if (!std::isfinite(times[i]) || !isLater)
    {
      std::ostringstream text;
      text << "has the Time " << times[i] << " at its point " << order[i];
      if (i > 0)
      {
        text << ", after " << times[i - 1] << " at point " << order[i - 1];
      }
      text << ". Times must be finite, and each must be later than the one before.";
      Fail(text.str());
    }
  }
  return times;
}

// The columns of the rotation matrix of a quaternion w x y z of any length.
std::array<lms3dVector, 3> GetAxes(std::array<double, 4> q, vtkIdType point)
{
  double largest = 0.0;
  for (double x : q)
  {
    largest = std::max(largest, std::abs(x));
  }
  const bool isFinite = std::all_of(q.begin(), q.end(), [](double x) { return std::isfinite(x); });
  if (!isFinite || largest == 0.0)
  {
    std::ostringstream text;
    text << "has the Orientation " << q[0] << ' ' << q[1] << ' ' << q[2] << ' ' << q[3]
         << " at its point " << point << ". It must be a quaternion w x y z other than 0.";
    Fail(text.str());
  }
  // Squares of the largest finite numbers would be infinite.
  std::transform(q.begin(), q.end(), q.begin(), [largest](double x) { return x / largest; });
  return lms3dToAxes(q);
}

// The x axis points along the tangent, and the y axis is level. If x is vertical, y is the last
// one.
std::array<lms3dVector, 3> GetAxesAlong(const lms3dVector& tangent, const lms3dVector& lastSide)
{
  const lms3dVector ahead = lms3dNormalize(tangent);
  const bool isUpright = ahead[0] == 0.0 && ahead[1] == 0.0;
  const lms3dVector side = isUpright ? lastSide : lms3dNormalize({ -ahead[1], ahead[0], 0.0 });
  return { ahead, side, lms3dCross(ahead, side) };
}

// The tangent runs from the previous to the next point. A sensor that stands still keeps its axes.
void FollowPolyline(std::vector<lms3dPose>& poses)
{
  std::array<lms3dVector, 3> axes = { lms3dVector{ 1.0, 0.0, 0.0 }, lms3dVector{ 0.0, 1.0, 0.0 },
    lms3dVector{ 0.0, 0.0, 1.0 } };
  const int last = static_cast<int>(poses.size()) - 1;
  for (int i = 0; i <= last; ++i)
  {
    const lms3dVector& from = poses[std::max(i - 1, 0)].Position;
    const lms3dVector& to = poses[std::min(i + 1, last)].Position;
    const lms3dVector tangent = lms3dSubtract(to, from);
    if (tangent != lms3dVector{ 0.0, 0.0, 0.0 })
    {
      axes = GetAxesAlong(tangent, axes[1]);
    }
    poses[i].Axes = axes;
  }
}
} // namespace

lms3dTrajectory::lms3dTrajectory(vtkPolyData* poses, const double orientation[3])
{
  const std::vector<vtkIdType> order = GetOrder(poses);
  this->Times = ::GetTimes(poses, order);
  vtkDataArray* quaternions = GetArray(poses, "Orientation", 4);
  this->Poses.reserve(order.size());
  for (vtkIdType point : order)
  {
    const lms3dVector position = GetPosition(poses, point);
    this->Poses.push_back(lms3dPose::FromOrientation(position.data(), orientation));
    if (quaternions)
    {
      std::array<double, 4> quaternion;
      quaternions->GetTuple(point, quaternion.data());
      this->Poses.back().Axes = GetAxes(quaternion, point);
    }
  }
  if (!quaternions && poses->GetNumberOfLines() > 0)
  {
    FollowPolyline(this->Poses);
  }
}

int lms3dTrajectory::FindStep(double time) const
{
  const auto later = std::upper_bound(this->Times.begin(), this->Times.end(), time);
  return std::max(0, static_cast<int>(later - this->Times.begin()) - 1);
}

lms3dPose lms3dTrajectory::Interpolate(double time) const
{
  const int last = static_cast<int>(this->Times.size()) - 1;
  const int step = this->FindStep(time);
  if (step == last || time <= this->Times[step])
  {
    return this->Poses[step];
  }
  const double share = (time - this->Times[step]) / (this->Times[step + 1] - this->Times[step]);
  return lms3dInterpolate(this->Poses[step], this->Poses[step + 1], share);
}
