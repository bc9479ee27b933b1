// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/DeviceFixtures.h"

#include "Fixtures/SceneBuilder.h"
#include "Scan/TrajectoryFixtures.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

vtkSmartPointer<vtkPolyData> MakeBoxScene(const Point& halfSizes)
{
  SceneBuilder builder;
  builder.AddBox({ -halfSizes[0], -halfSizes[1], -halfSizes[2] }, halfSizes);
  return builder.GetSurface();
}

double GetRangeInBox(const Point& halfSizes, const Point& from, const Point& direction)
{
  double range = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
  {
    const double wall = std::copysign(halfSizes[axis], direction[axis]);
    if (direction[axis] != 0.0)
    {
      range = std::min(range, (wall - from[axis]) / direction[axis]);
    }
  }
  return range;
}

Point GetMountedDirection(int mounting, double alpha, double beta)
{
  const double a = vtkMath::RadiansFromDegrees(alpha);
  const double b = vtkMath::RadiansFromDegrees(beta);
  switch (mounting)
  {
    case vtkLMS3DScanFilter::YAWING_TOP:
      return { std::sin(a) * std::cos(b), -std::sin(a) * std::sin(b), std::cos(a) };
    case vtkLMS3DScanFilter::PITCHING:
      return { std::cos(a) * std::cos(b), std::sin(a), std::cos(a) * std::sin(b) };
    case vtkLMS3DScanFilter::ROLLING:
      return { std::cos(a), std::sin(a) * std::cos(b), -std::sin(a) * std::sin(b) };
    default:
      return GetPaperDirection(alpha, beta);
  }
}

Point Rotate(const std::vector<double>& q, const Point& v)
{
  const double* axis = q.data() + 1;
  Point once, twice, rotated;
  vtkMath::Cross(axis, v.data(), once.data());
  vtkMath::Cross(axis, once.data(), twice.data());
  for (int i = 0; i < 3; ++i)
  {
    rotated[i] = v[i] + 2.0 * (q[0] * once[i] + twice[i]);
  }
  return rotated;
}

vtkSmartPointer<vtkPolyData> MakeShortDrive(double duration)
{
  auto poses = MakePoses({ { 0.1, -0.2, 1.0 }, { 0.2, -0.2, 1.02 }, { 0.3, -0.1, 1.0 } });
  AddArray(poses, "Time", 1, { 5.0, 5.0 + duration, 5.0 + 2.0 * duration });
  AddArray(
    poses, "Orientation", 4, { 1.0, 0.0, 0.0, 0.0, 0.985, 0.02, -0.01, 0.17, 0.9, 0.0, 0.05, 0.4 });
  return poses;
}

std::vector<double> GetValues(vtkLMS3DScanFilter* scan, const char* name)
{
  vtkDataArray* array = GetArray(scan, name);
  std::vector<double> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    for (int component = 0; component < array->GetNumberOfComponents(); ++component)
    {
      values.push_back(array->GetComponent(i, component));
    }
  }
  return values;
}

void PrintTo(const Device& device, std::ostream* os)
{
  *os << device.Name;
}

namespace
{
void SetWidth(vtkLMS3DScanFilter* scan)
{
  scan->SetBeamDiameter(0.012);
  scan->SetBeamDivergence(0.0044);
  scan->SetBeamSamples(7);
}

void SetMotion(vtkLMS3DScanFilter* scan)
{
  scan->SetTrajectoryData(MakeShortDrive());
  scan->MotionDuringScanOn();
}
} // namespace

const std::vector<Device>& GetDevices()
{
  static const std::vector<Device> Devices = {
    { "YawingTop", [](vtkLMS3DScanFilter* scan) { scan->SetMountingToYawingTop(); } },
    { "Pitching", [](vtkLMS3DScanFilter* scan) { scan->SetMountingToPitching(); } },
    { "Rolling", [](vtkLMS3DScanFilter* scan) { scan->SetMountingToRolling(); } },
    { "Offset", [](vtkLMS3DScanFilter* scan) { scan->SetAxisOffset(0.1, 0.03, -0.05); } },
    { "Rate", [](vtkLMS3DScanFilter* scan) { scan->SetTurnRate(75.0); } },
    { "Motion", [](vtkLMS3DScanFilter* scan) { SetMotion(scan); } },
    { "Divergence",
      [](vtkLMS3DScanFilter* scan)
      {
        scan->SetBeamDivergence(0.0044);
        scan->SetBeamSamples(7);
      } },
    { "Width", [](vtkLMS3DScanFilter* scan) { SetWidth(scan); } },
    { "All",
      [](vtkLMS3DScanFilter* scan)
      {
        SetWidth(scan);
        SetMotion(scan);
        scan->SetMountingToRolling();
        scan->SetAxisOffset(0.1, 0.03, -0.05);
        scan->SetTurnRate(75.0);
        scan->ComputeTimeOn();
        scan->ComputePosesOn();
      } },
  };
  return Devices;
}

std::uint64_t HashOutputs(vtkLMS3DScanFilter* scan)
{
  return Hash(scan->GetOutput()) ^ (31 * Hash(scan->GetRangeImage()));
}
