// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
// The return of each beam.
#include "LocalMap/Grid/lms3dRangeGrid.h"

#include "Device/lms3dScanInput.h"
#include "Geometry/lms3dWideLoops.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace
{
constexpr double MaximumRange = std::numeric_limits<double>::max();
constexpr std::int64_t MinimumReturnsPerTask = 16384;

// Whether ranges are good and the beams of returns grow. The loops have no branches, so that
// the compiler makes them loops over vectors.
LMS3D_WIDE_LOOPS
bool AreInOrder(const double* ranges, const int* beamIds, std::int64_t first, std::int64_t end)
{
  std::int64_t bad = 0;
  for (std::int64_t i = first; i < end; ++i)
  {
    bad += (ranges[i] > 0.0) & (ranges[i] <= MaximumRange) ? 0 : 1;
  }
  int unsorted = 0;
  for (std::int64_t i = std::max<std::int64_t>(first, 1); i < end; ++i)
  {
    unsorted |= beamIds[i] > beamIds[i - 1] ? 0 : 1;
  }
  return bad == 0 && unsorted == 0;
}
} // namespace

void lms3dRangeGrid::AssignReturns(const double* ranges, const int* beamIds, std::int64_t count)
{
  const std::int64_t beams = this->Geometry->CountBeamsOfAllTurns();
  if (this->AreSorted(ranges, beamIds, count))
  {
    this->AssignSortedReturns(beamIds, count);
    return;
  }
  this->ReturnOfBeam.assign(beams, NoReturn);
  for (std::int64_t i = 0; i < count; ++i)
  {
    const int beam = beamIds[i];
    if (beam < 0 || beam >= beams || this->ReturnOfBeam[beam] != NoReturn ||
      !(ranges[i] > 0.0 && ranges[i] <= MaximumRange))
    {
      lms3dThrowBadReturn(i, ranges[i], beam, beams);
    }
    this->ReturnOfBeam[beam] = static_cast<std::int32_t>(i);
  }
}

// Whether all returns are good and in the order of their beams. Then no beam has two of them.
bool lms3dRangeGrid::AreSorted(const double* ranges, const int* beamIds, std::int64_t count) const
{
  const auto areSorted = [&](const tbb::blocked_range<std::int64_t>& part, bool before)
  { return before && AreInOrder(ranges, beamIds, part.begin(), part.end()); };
  return count == 0 ||
    (beamIds[0] >= 0 && beamIds[count - 1] < this->Geometry->CountBeamsOfAllTurns() &&
      tbb::parallel_reduce(tbb::blocked_range<std::int64_t>(0, count, MinimumReturnsPerTask), true,
        areSorted, [](bool a, bool b) { return a && b; }));
}

// Each return sets its beam, and the beams since the return before.
void lms3dRangeGrid::AssignSortedReturns(const int* beamIds, std::int64_t count)
{
  this->ReturnOfBeam.resize(this->Geometry->CountBeamsOfAllTurns());
  const auto assign = [&](const tbb::blocked_range<std::int64_t>& part)
  {
    int next = part.begin() > 0 ? beamIds[part.begin() - 1] + 1 : 0;
    for (std::int64_t i = part.begin(); i < part.end(); ++i)
    {
      while (next < beamIds[i])
      {
        this->ReturnOfBeam[next++] = NoReturn;
      }
      this->ReturnOfBeam[next++] = static_cast<std::int32_t>(i);
    }
  };
  tbb::parallel_for(tbb::blocked_range<std::int64_t>(0, count, MinimumReturnsPerTask), assign);
  const std::ptrdiff_t end = count > 0 ? beamIds[count - 1] + 1 : 0;
  std::fill(this->ReturnOfBeam.begin() + end, this->ReturnOfBeam.end(), NoReturn);
}

// Keeps the return of median range in the first turn and removes the others.
void lms3dRangeGrid::CollapsePole(int beam, const double* ranges)
{
  std::vector<std::pair<double, std::int32_t>> returns;
  std::vector<double>& all = this->RangesOfPoles.emplace_back();
  for (int turn = 0; turn < this->GetNumberOfTurns(); ++turn)
  {
    const std::size_t index = static_cast<std::size_t>(turn) * this->GetNumberOfBeams() + beam;
    const std::int32_t found = std::exchange(this->ReturnOfBeam[index], NoReturn);
    if (found != NoReturn)
    {
      returns.emplace_back(ranges[found], found);
      all.push_back(ranges[found]);
    }
  }
  if (!returns.empty())
  {
    const auto median = returns.begin() + returns.size() / 2;
    std::nth_element(returns.begin(), median, returns.end());
    this->ReturnOfBeam[beam] = median->second;
  }
}
