// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Scans/lms3dPassingBeams.h"

#include "Scan/lms3dFreeBeams.h"

#include <vtkFieldData.h>
#include <vtkPolyData.h>

// A local map has NumberOfClosedGaps if gaps may be closed.
std::vector<bool> lms3dFindPassingBeams(vtkPolyData* map, vtkPolyData* scan, std::int64_t beams)
{
  std::vector<bool> isFree = lms3dFindFreeBeams(scan, beams);
  if (isFree.empty())
  {
    const bool mayBeLost = map->GetFieldData()->HasArray("NumberOfClosedGaps") != 0;
    isFree.assign(static_cast<std::size_t>(beams), !mayBeLost);
  }
  return isFree;
}
