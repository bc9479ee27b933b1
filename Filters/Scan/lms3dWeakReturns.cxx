// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dWeakReturns.h"

#include "Kernels/lms3dBeamPacket.h"
#include "Scan/lms3dSurfaceNormals.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace
{
// SICK LMS 200 technical description 8008970/06-2003, pages 7 and 33: the device sees 10 percent up
// to a range of its own, less light the nearer the surface is, and never less than 1.8 percent.
constexpr double ReferenceReflectance = 0.1;
constexpr double MinimumReflectance = 0.018;

// The smallest number of turns that a thread takes, so that it uses normals again.
constexpr int MinimumTurns = 8;

/// Judges the beams of one turn after another. For one thread.
class TurnJudge
{
public:
  TurnJudge(const lms3dSurfaceHits& hits, double rangeAtTenPercent)
    : Hits(hits)
    , Count(hits.Beams.GetGeometry().GetNumberOfBeams())
    , RangeAtTenPercent(rangeAtTenPercent)
    , Normals(hits.Surface.Mesh)
    , Intensities(this->Count)
  {
    for (std::vector<double>& component : this->Directions)
    {
      component.resize(this->Count);
    }
  }

  // `ranges`, `triangles` and `isWeak` have a value for each beam of the turn.
  void Judge(int turn, const double* ranges, const std::int32_t* triangles, unsigned char* isWeak)
  {
    for (int beam = 0; beam < this->Count; ++beam)
    {
      const lms3dVector direction = this->Hits.Beams.GetDirection(turn, beam);
      this->Directions[0][beam] = direction[0];
      this->Directions[1][beam] = direction[1];
      this->Directions[2][beam] = direction[2];
    }
    for (int first = 0; first < this->Count;)
    {
      int last = first + 1;
      while (last < this->Count && triangles[last] == triangles[first])
      {
        ++last;
      }
      this->FillIntensities(triangles[first], first, last);
      first = last;
    }
    const double* intensities = this->Intensities.data();
    for (int beam = 0; beam < this->Count; ++beam)
    {
      const double share = ranges[beam] / this->RangeAtTenPercent;
      const double needed = ReferenceReflectance * share * share;
      isWeak[beam] =
        (intensities[beam] < MinimumReflectance) | (intensities[beam] < needed) ? 1 : 0;
    }
  }

private:
  // For a run of beams that hit the same triangle. The loop has no calls that keep the compiler
  // from vectorizing it.
  void FillIntensities(std::int32_t triangle, int first, int last)
  {
    double* intensities = this->Intensities.data();
    if (triangle == lms3dBeamPacket::NoTriangle)
    {
      std::fill(intensities + first, intensities + last, std::numeric_limits<double>::infinity());
      return;
    }
    const lms3dVector normal = this->Normals.Get(triangle);
    const double reflectance = this->Hits.Surface.GetReflectance(triangle);
    const double* x = this->Directions[0].data();
    const double* y = this->Directions[1].data();
    const double* z = this->Directions[2].data();
    for (int beam = first; beam < last; ++beam)
    {
      intensities[beam] =
        reflectance * lms3dGetIncidenceCosine({ x[beam], y[beam], z[beam] }, normal);
    }
  }

  const lms3dSurfaceHits& Hits;
  const int Count;
  const double RangeAtTenPercent;
  lms3dSurfaceNormals Normals;
  std::vector<double> Directions[3];
  std::vector<double> Intensities;
};
} // namespace

std::vector<unsigned char> lms3dFindWeakReturns(
  const lms3dSurfaceHits& hits, const double* ranges, double rangeAtTenPercent)
{
  std::vector<unsigned char> isWeak(hits.Triangles.size());
  const lms3dScanGeometry& geometry = hits.Beams.GetGeometry();
  tbb::parallel_for(tbb::blocked_range<int>(0, geometry.GetNumberOfTurns(), MinimumTurns),
    [&](const tbb::blocked_range<int>& turns)
    {
      TurnJudge judge(hits, rangeAtTenPercent);
      for (int turn = turns.begin(); turn < turns.end(); ++turn)
      {
        const std::ptrdiff_t first =
          static_cast<std::ptrdiff_t>(turn) * geometry.GetNumberOfBeams();
        judge.Judge(turn, ranges + first, hits.Triangles.data() + first, isWeak.data() + first);
      }
    });
  return isWeak;
}
