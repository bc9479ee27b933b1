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

/// The arrays of a scan. VTK's access to an array takes longer than a step of a loop.
struct Returns
{
  explicit Returns(const lms3dScanInput& scan)
    : Ranges(scan.GetRanges())
    , Ids(scan.GetBeamIds())
    , Count(scan.GetNumberOfReturns())
  {
  }

  bool IsRange(vtkIdType i) const
  {
    const double range = this->Ranges[i];
    return (range > 0.0) & (range <= std::numeric_limits<double>::max());
  }

  bool IsBad(vtkIdType i, std::int64_t beams) const
  {
    return !this->IsRange(i) || this->Ids[i] < 0 || this->Ids[i] >= beams;
  }

  const double* const Ranges;
  const int* const Ids;
  const vtkIdType Count;
};

// Returns whether all ranges are good and the beams increase.
bool AreGoodAndSorted(const Returns& returns)
{
  std::atomic<bool> areGood{ true };
  tbb::parallel_for(Indices(0, returns.Count, MinimumGrainSize),
    [&](const Indices& part)
    {
      // Counts, because compilers vectorize a loop that does not stop early.
      std::int64_t bad = 0;
      const int* ids = returns.Ids;
      for (vtkIdType i = part.begin(); i < part.end(); ++i)
      {
        bad += returns.IsRange(i) ? 0 : 1;
      }
      std::int32_t unsorted = 0;
      for (vtkIdType i = std::max<vtkIdType>(1, part.begin()); i < part.end(); ++i)
      {
        unsorted += ids[i - 1] < ids[i] ? 0 : 1;
      }
      if (bad > 0 || unsorted > 0)
      {
        areGood = false;
      }
    });
  return areGood;
}

// Throws if a return is bad. Returns whether the beams increase. Increasing beams cannot repeat.
bool CheckReturns(const Returns& returns, std::int64_t beams)
{
  if (AreGoodAndSorted(returns) && returns.Ids[0] >= 0 && returns.Ids[returns.Count - 1] < beams)
  {
    return true;
  }
  std::vector<bool> isTaken(static_cast<std::size_t>(beams), false);
  for (vtkIdType i = 0; i < returns.Count; ++i)
  {
    const int id = returns.Ids[i];
    if (returns.IsBad(i, beams) || isTaken[id])
    {
      lms3dThrowBadReturn(i, returns.Ranges[i], id, beams);
    }
    isTaken[id] = true;
  }
  return false;
}
} // namespace

void lms3dFillGrid(const lms3dScanInput& scan, const lms3dScanGeometry& geometry, double* grid)
{
  const std::int64_t beams = geometry.CountBeamsOfAllTurns();
  if (scan.GetNumberOfReturns() < beams)
  {
    std::fill_n(grid, beams, NAN);
  }
  if (scan.GetNumberOfReturns() == 0)
  {
    return;
  }
  const Returns returns(scan);
  const bool areSorted = CheckReturns(returns, beams);
  tbb::parallel_for(Indices(0, returns.Count, MinimumGrainSize),
    [&](const Indices& part)
    {
      const int first = returns.Ids[part.begin()];
      const vtkIdType size = static_cast<vtkIdType>(part.size());
      if (areSorted && returns.Ids[part.end() - 1] - first == size - 1)
      {
        std::copy_n(returns.Ranges + part.begin(), size, grid + first);
        return;
      }
      for (vtkIdType i = part.begin(); i < part.end(); ++i)
      {
        grid[returns.Ids[i]] = returns.Ranges[i];
      }
    });
}
