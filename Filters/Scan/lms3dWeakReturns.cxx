// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dWeakReturns.h"

#include "Kernels/lms3dBeamPacket.h"
#include "Scan/lms3dSurfaceNormals.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstddef>
#include <limits>

namespace
{
// SICK LMS 200 technical description 8008970/06-2003, pages 7 and 33: the device sees 10 percent up to a
// range of its own, less light the nearer the surface is, and never less than 1.8 percent.
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
    , RangeAtTenPercent(rangeAtTenPercent)
    , Normals(hits.Surface.Mesh)
    , Intensities(hits.Beams.GetGeometry().GetNumberOfBeams())
  {
  }

  // `ranges`, `triangles` and `isWeak` have a value for each beam of the turn.
  void Judge(int turn, const double* ranges, const std::int32_t* triangles, unsigned char* isWeak)
  {
    const int beams = static_cast<int>(this->Intensities.size());
    for (int beam = 0; beam < beams; ++beam)
    {
      this->Intensities[beam] = triangles[beam] == lms3dBeamPacket::NoTriangle
        ? std::numeric_limits<double>::infinity()
        : this->GetIntensity(turn, beam, triangles[beam]);
    }
    // A loop of its own, so that the compiler can vectorize it.
    const double* intensities = this->Intensities.data();
    for (int beam = 0; beam < beams; ++beam)
    {
      const double share = ranges[beam] / this->RangeAtTenPercent;
      const double needed = ReferenceReflectance * share * share;
      isWeak[beam] =
        (intensities[beam] < MinimumReflectance) | (intensities[beam] < needed) ? 1 : 0;
    }
  }

private:
  double GetIntensity(int turn, int beam, std::int32_t triangle)
  {
    return this->Hits.Surface.GetReflectance(triangle) *
      lms3dGetIncidenceCosine(
        this->Hits.Beams.GetDirection(turn, beam), this->Normals.Get(triangle));
  }

  const lms3dSurfaceHits& Hits;
  const double RangeAtTenPercent;
  lms3dSurfaceNormals Normals;
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
