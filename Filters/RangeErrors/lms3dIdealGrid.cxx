// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RangeErrors/lms3dIdealGrid.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace
{
// The smallest part of a loop over returns that a thread takes.
constexpr vtkIdType MinimumGrainSize = 4096;

using Indices = tbb::blocked_range<vtkIdType>;

std::int64_t CountBeams(const lms3dScanGeometry& geometry)
{
  return static_cast<std::int64_t>(geometry.GetNumberOfBeams()) * geometry.GetNumberOfTurns();
}

bool IsBad(const lms3dScanInput& scan, vtkIdType i, std::int64_t beams)
{
  const double range = scan.GetRanges()[i];
  const int id = scan.GetBeamIds()[i];
  return id < 0 || id >= beams || !(range > 0.0 && range <= std::numeric_limits<double>::max());
}

/// What a pass over all returns finds out.
struct Order
{
  std::atomic<bool> HasBad{ false };
  std::atomic<bool> IsSorted{ true };
};

void FindOrder(const lms3dScanInput& scan, std::int64_t beams, Order& order)
{
  const int* ids = scan.GetBeamIds();
  tbb::parallel_for(Indices(0, scan.GetNumberOfReturns(), MinimumGrainSize),
    [&](const Indices& part)
    {
      bool hasBad = false;
      bool isSorted = true;
      for (vtkIdType i = part.begin(); i < part.end(); ++i)
      {
        hasBad |= IsBad(scan, i, beams);
        isSorted &= i == 0 || ids[i - 1] < ids[i];
      }
      if (hasBad)
      {
        order.HasBad = true;
      }
      if (!isSorted)
      {
        order.IsSorted = false;
      }
    });
}

// Throws if a return is bad. Increasing beams cannot repeat.
void CheckReturns(const lms3dScanInput& scan, std::int64_t beams)
{
  Order order;
  FindOrder(scan, beams, order);
  if (!order.HasBad && order.IsSorted)
  {
    return;
  }
  std::vector<bool> isTaken(static_cast<std::size_t>(beams), false);
  for (vtkIdType i = 0; i < scan.GetNumberOfReturns(); ++i)
  {
    const int id = scan.GetBeamIds()[i];
    if (IsBad(scan, i, beams) || isTaken[id])
    {
      lms3dThrowBadReturn(i, scan.GetRanges()[i], id, beams);
    }
    isTaken[id] = true;
  }
}
} // namespace

void lms3dFillGrid(const lms3dScanInput& scan, const lms3dScanGeometry& geometry, double* grid)
{
  const std::int64_t beams = CountBeams(geometry);
  const vtkIdType count = scan.GetNumberOfReturns();
  if (count > 0)
  {
    CheckReturns(scan, beams);
  }
  if (count < beams)
  {
    std::fill_n(grid, beams, NAN);
  }
  tbb::parallel_for(Indices(0, count, MinimumGrainSize),
    [&](const Indices& part)
    {
      for (vtkIdType i = part.begin(); i < part.end(); ++i)
      {
        grid[scan.GetBeamIds()[i]] = scan.GetRanges()[i];
      }
    });
}
