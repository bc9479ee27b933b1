// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dPoseArrays.h"

#include "Device/lms3dPoseInterpolation.h"
#include "Device/lms3dScanFieldData.h"
#include "Pipeline/lms3dArray.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace
{
// The smallest part of the loop over returns that a thread takes.
constexpr vtkIdType MinimumGrainSize = 1024;

/// Calls `function` with the index, the turn and the beam of each return, in many threads.
template <typename Function>
void ForEachReturn(const lms3dMovingBeams& beams, vtkPolyData* scan, const Function& function)
{
  const int* ids =
    vtkIntArray::SafeDownCast(scan->GetPointData()->GetArray("BeamId"))->GetPointer(0);
  const int beamsOfTurn = beams.GetGeometry().GetNumberOfBeams();
  tbb::parallel_for(tbb::blocked_range<vtkIdType>(0, scan->GetNumberOfPoints(), MinimumGrainSize),
    [&](const tbb::blocked_range<vtkIdType>& range)
    {
      for (vtkIdType i = range.begin(); i < range.end(); ++i)
      {
        function(i, ids[i] / beamsOfTurn, ids[i] % beamsOfTurn);
      }
    });
}

vtkSmartPointer<vtkDoubleArray> AddArray(const char* name, int components, vtkPolyData* scan)
{
  const auto array = lms3dMakeArray<vtkDoubleArray>(
    name, static_cast<std::size_t>(scan->GetNumberOfPoints()), components);
  scan->GetPointData()->AddArray(array);
  return array;
}

void AddTimes(const lms3dMovingBeams& beams, vtkPolyData* scan)
{
  double* times = AddArray("Time", 1, scan)->GetPointer(0);
  ForEachReturn(
    beams, scan, [&](vtkIdType i, int turn, int beam) { times[i] = beams.GetTime(turn, beam); });
}

void AddPoses(const lms3dMovingBeams& beams, vtkPolyData* scan)
{
  double* positions = AddArray("SensorPosition", 3, scan)->GetPointer(0);
  double* orientations = AddArray("SensorOrientation", 4, scan)->GetPointer(0);
  ForEachReturn(beams, scan,
    [&](vtkIdType i, int turn, int beam)
    {
      const lms3dPose pose = beams.GetPose(turn, beam);
      const lms3dQuaternion orientation = lms3dToQuaternion(pose.Axes);
      std::copy(pose.Position.begin(), pose.Position.end(), positions + 3 * i);
      std::copy(orientation.begin(), orientation.end(), orientations + 4 * i);
    });
}

void AddTurnPoses(const lms3dMovingBeams& beams, vtkPolyData* scan)
{
  const int turns = beams.GetGeometry().GetNumberOfTurns();
  const auto array =
    lms3dMakeArray<vtkDoubleArray>("TurnToWorld", static_cast<std::size_t>(turns), 16);
  for (int turn = 0; turn < turns; ++turn)
  {
    const std::array<double, 16> matrix = lms3dToMatrix(beams.GetPose(turn, 0));
    std::copy(matrix.begin(), matrix.end(), array->GetPointer(16 * static_cast<vtkIdType>(turn)));
  }
  lms3dAddHiddenArray(array, scan->GetFieldData());
}
} // namespace

void lms3dAddPoseArrays(const lms3dMovingBeams& beams, const lms3dExtraArrays& wanted,
  bool hasTurnPoses, vtkPolyData* scan)
{
  if (wanted.Time)
  {
    AddTimes(beams, scan);
  }
  if (wanted.Poses)
  {
    AddPoses(beams, scan);
  }
  if (hasTurnPoses)
  {
    AddTurnPoses(beams, scan);
  }
}
