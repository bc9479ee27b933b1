// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dFusionChecks.h"

#include "Device/lms3dScanChecks.h"
#include "Device/lms3dScanInput.h"
#include "Geometry/lms3dVector.h"
#include "Pipeline/lms3dText.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
// Bounds: how far the map reaches from the origin. The cells of its planes have 32-bit numbers.
constexpr double LargestDistance = 6e8;

[[noreturn]] void Fail(const std::string& text)
{
  throw std::runtime_error(text);
}

void CheckPose(const lms3dPose& pose)
{
  const std::string error = lms3dFindAxesError(pose);
  if (!error.empty())
  {
    Fail(error);
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
  const lms3dVector offset = scan.GetGeometry().GetPlatform().AxisOffset;
  CheckDistance("The beams of the scan reach",
    lms3dGetLength(scan.GetSensorPosition()) + lms3dGetLength(offset) + range, maximumError);
  for (vtkIdType i = 0; i < map->GetNumberOfPoints(); ++i)
  {
    lms3dVector point;
    map->GetPoint(i, point.data());
    CheckDistance("The local map lies", lms3dGetLength(point), maximumError);
  }
}

// A patch has a return, so there are no more patches than beams.
void CheckPatches(vtkDataArray* patches, std::int64_t beams)
{
  for (vtkIdType i = 0; i < patches->GetNumberOfTuples(); ++i)
  {
    const double patch = patches->GetTuple1(i);
    if (!(patch >= -1.0 && patch < static_cast<double>(beams)))
    {
      Fail(lms3dJoinText("Triangle ", i, " of the local map has the PatchId ", patch, "; -1 to ",
        beams - 1, " are expected. Connect the output of vtkLMS3DSurfaceReconstructionFilter."));
    }
  }
}

void CheckTriangles(vtkPolyData* map)
{
  const vtkIdType points = map->GetNumberOfPoints();
  const auto cells = vtk::TakeSmartPointer(map->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    cells->GetCurrentCell(size, ids);
    const auto isPoint = [points](vtkIdType id) { return id >= 0 && id < points; };
    if (size != 3 || !std::all_of(ids, ids + size, isPoint))
    {
      Fail(lms3dJoinText("Cell ", cells->GetCurrentCellId(), " of the local map is no triangle of ",
        "its ", points, " points. Connect the output of vtkLMS3DSurfaceReconstructionFilter."));
    }
  }
}

void CheckMap(vtkPolyData* map, std::int64_t beams, double maximumError)
{
  const vtkIdType triangles = map->GetNumberOfPolys();
  vtkDataArray* const patches = map->GetCellData()->GetArray("PatchId");
  vtkDataArray* const deviation = map->GetFieldData()->GetArray("LargestDeviation");
  if (map->GetNumberOfPoints() == 0 && !patches)
  {
    Fail("The local map is empty, but its scan has returns. The filter that makes the map has "
         "failed, or was aborted. Update it again.");
  }
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
  CheckTriangles(map);
  CheckPatches(patches, beams);
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
  const std::int64_t beams = input.GetGeometry().CountBeamsOfAllTurns();
  CheckStatus(scan, beams);
  CheckMap(map, beams, maximumError);
  CheckDistances(input, map, maximumError);
}
