// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dFusionChecks.h"

#include "Device/lms3dScanInput.h"
#include "Geometry/lms3dVector.h"
#include "Pipeline/lms3dText.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
// How far the axes of a pose may be from orthonormal ones.
constexpr double AxisTolerance = 1e-6;
// Bounds: how far the map reaches from the origin. The cells of its planes have 32-bit numbers.
constexpr double LargestDistance = 6e8;

[[noreturn]] void Fail(const std::string& text)
{
  throw std::runtime_error(text);
}

void CheckPose(const lms3dPose& pose)
{
  for (int i = 0; i < 3; ++i)
  {
    const double length = lms3dGetLength(pose.Axes[i]);
    if (!(std::abs(length - 1.0) <= AxisTolerance))
    {
      Fail(lms3dJoinText("SensorToWorld of the scan scales an axis by ", length,
        ". A pose is a rotation and a translation, without a scale."));
    }
    if (!(std::abs(lms3dDot(pose.Axes[i], pose.Axes[(i + 1) % 3])) <= AxisTolerance))
    {
      Fail("SensorToWorld of the scan shears its axes. A pose is a rotation and a translation.");
    }
  }
  if (lms3dDot(lms3dCross(pose.Axes[0], pose.Axes[1]), pose.Axes[2]) < 0.0)
  {
    Fail("SensorToWorld of the scan is a mirror image. A pose is a rotation and a translation.");
  }
}

void CheckReturns(const lms3dScanInput& scan)
{
  const lms3dScanGeometry geometry = scan.GetGeometry();
  const std::int64_t beams = geometry.CountBeamsOfAllTurns();
  std::vector<bool> isTaken(static_cast<std::size_t>(beams));
  for (vtkIdType i = 0; i < scan.GetNumberOfReturns(); ++i)
  {
    const double range = scan.GetRanges()[i];
    const int id = scan.GetBeamIds()[i];
    if (id < 0 || id >= beams || !(range > 0.0) || !std::isfinite(range) || isTaken[id])
    {
      lms3dThrowBadReturn(i, range, id, beams);
    }
    isTaken[id] = true;
  }
}

// A Status of other beams would say nothing, and lost beams would count as free.
void CheckStatus(vtkPolyData* scan, std::int64_t beams)
{
  vtkDataArray* const status = scan->GetFieldData()->GetArray("Status");
  if (status && (status->GetNumberOfComponents() != 1 || status->GetNumberOfTuples() != beams))
  {
    Fail(lms3dJoinText("Status of the scan has ", status->GetNumberOfTuples(), " tuples of ",
      status->GetNumberOfComponents(), " components. One number for each of the ", beams,
      " beams is expected."));
  }
}

void CheckDistance(const char* what, double distance, double maximumError)
{
  const double largest = LargestDistance * maximumError;
  if (!(distance <= largest))
  {
    Fail(lms3dJoinText(what, " up to ", distance, " m from the origin. With a MaximumError of ",
      maximumError, " m, the map reaches ", largest,
      " m. Move the origin nearer to the poses, or use a larger MaximumError."));
  }
}

void CheckDistances(const lms3dScanInput& scan, vtkPolyData* map, double maximumError)
{
  const double* const ranges = scan.GetRanges();
  const double range = *std::max_element(ranges, ranges + scan.GetNumberOfReturns());
  CheckDistance(
    "The beams of the scan reach", lms3dGetLength(scan.GetSensorPosition()) + range, maximumError);
  for (vtkIdType i = 0; i < map->GetNumberOfPoints(); ++i)
  {
    lms3dVector point;
    map->GetPoint(i, point.data());
    CheckDistance("The local map lies", lms3dGetLength(point), maximumError);
  }
}

void CheckMap(vtkPolyData* map, double maximumError)
{
  const vtkIdType triangles = map->GetNumberOfPolys();
  vtkDataArray* const patches = map->GetCellData()->GetArray("PatchId");
  vtkDataArray* const deviation = map->GetFieldData()->GetArray("LargestDeviation");
  if (!patches || patches->GetNumberOfTuples() != triangles || !deviation ||
    deviation->GetNumberOfTuples() != 1)
  {
    Fail("The local map has no PatchId or no LargestDeviation. Connect the output of "
         "vtkLMS3DSurfaceReconstructionFilter, with a MaximumError above 0.");
  }
  if (!(deviation->GetTuple1(0) <= maximumError))
  {
    Fail(lms3dJoinText("The local map is up to ", deviation->GetTuple1(0),
      " m away from its returns, more than the MaximumError of ", maximumError,
      " m. Give both filters the same MaximumError."));
  }
  if (triangles > 0 && map->GetPolys()->GetNumberOfConnectivityIds() != 3 * triangles)
  {
    Fail("The local map has cells that are no triangles. Connect the output of "
         "vtkLMS3DSurfaceReconstructionFilter.");
  }
}
} // namespace

void lms3dCheckFusionInput(vtkPolyData* map, vtkPolyData* scan, double maximumError)
{
  if (scan->GetNumberOfPoints() == 0)
  {
    if (map->GetNumberOfPolys() > 0)
    {
      Fail("The local map has triangles, but its scan has no returns. Connect the scan from which "
           "the map was made.");
    }
    return;
  }
  const lms3dScanInput input(scan);
  input.CheckPoints();
  CheckPose(input.GetPose());
  CheckReturns(input);
  CheckStatus(scan, input.GetGeometry().CountBeamsOfAllTurns());
  CheckMap(map, maximumError);
  CheckDistances(input, map, maximumError);
}
