// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Poses between poses, and the part of a trajectory that a scan needs.
 */
#include "Device/lms3dMotion.h"
#include "Device/lms3dPoseInterpolation.h"
#include "Device/lms3dTrajectory.h"

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
lms3dPose MakePose(double x, double y, double z, double turn)
{
  const double position[3] = { x, y, z };
  const double orientation[3] = { 0.0, 0.0, turn };
  return lms3dPose::FromOrientation(position, orientation);
}

bool AreEqual(const lms3dPose& a, const lms3dPose& b)
{
  return a.Position == b.Position && a.Axes == b.Axes;
}

lms3dTrajectory MakeTrajectory()
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> times;
  times->SetName("Time");
  vtkNew<vtkDoubleArray> orientations;
  orientations->SetName("Orientation");
  orientations->SetNumberOfComponents(4);
  for (int i = 0; i < 5; ++i)
  {
    points->InsertNextPoint(0.1 * i * i, -0.3 * i, 1.0);
    times->InsertNextValue(10.0 + 0.5 * i);
    orientations->InsertNextTuple4(1.0, 0.05 * i, -0.1 * i, 0.2 * i * i);
  }
  vtkNew<vtkPolyData> poses;
  poses->SetPoints(points);
  poses->GetPointData()->AddArray(times);
  poses->GetPointData()->AddArray(orientations);
  const double orientation[3] = { 0.0, 0.0, 0.0 };
  return { poses, orientation };
}
} // namespace

TEST(PoseInterpolation, TurnsEvenly)
{
  const lms3dPoseSegment segment(MakePose(0, 0, 0, 10), MakePose(1, 2, 4, 110));
  for (double share : { 0.0, 0.25, 0.5, 0.9, 1.0 })
  {
    const lms3dPose pose = segment.Interpolate(share);
    const lms3dPose expected = MakePose(share, 2 * share, 4 * share, 10 + 100 * share);
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_NEAR(pose.Position[axis], expected.Position[axis], 1e-15);
      for (int i = 0; i < 3; ++i)
      {
        EXPECT_NEAR(pose.Axes[axis][i], expected.Axes[axis][i], 1e-15);
      }
    }
  }
}

TEST(PoseInterpolation, KeepsWhatBothEndsHaveInCommon)
{
  const lms3dPose pose = MakePose(0.1, 0.7, -0.3, 33.3);
  lms3dPose higher = pose;
  higher.Position[2] = 5.0;
  for (int i = 0; i <= 100; ++i)
  {
    EXPECT_TRUE(AreEqual(lms3dInterpolate(pose, pose, 0.01 * i), pose));
    const lms3dPose lifted = lms3dInterpolate(pose, higher, 0.01 * i);
    EXPECT_EQ(lifted.Axes, pose.Axes);
    EXPECT_EQ(lifted.Position[0], 0.1);
    EXPECT_EQ(lifted.Position[1], 0.7);
  }
}

TEST(Motion, IsThePartOfATrajectory)
{
  const lms3dTrajectory trajectory = MakeTrajectory();
  const lms3dMotion motion(trajectory, 10.6, 11.4);
  EXPECT_EQ(motion.GetPoses().size(), 3u);
  EXPECT_FALSE(motion.IsAtRest());
  const lms3dMotion copy(motion.GetPoses());
  for (int i = 0; i <= 80; ++i)
  {
    const double time = 10.6 + 0.01 * i;
    EXPECT_TRUE(AreEqual(motion.GetPose(time), trajectory.Interpolate(time))) << time;
    EXPECT_TRUE(AreEqual(copy.GetPose(time), trajectory.Interpolate(time))) << time;
  }
}

TEST(Motion, RestsAfterTheLastTime)
{
  const lms3dTrajectory trajectory = MakeTrajectory();
  const lms3dMotion motion(trajectory, 12.0, 14.0);
  EXPECT_TRUE(motion.IsAtRest());
  EXPECT_TRUE(AreEqual(motion.GetPose(13.0), trajectory.GetPose(4)));
  EXPECT_TRUE(AreEqual(motion.GetPose(11.0), trajectory.GetPose(4)));
}
