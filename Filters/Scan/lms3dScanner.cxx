// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dScanner.h"

#include "Kernels/lms3dPacketKernels.h"
#include "Pipeline/lms3dProgressReporter.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace
{
constexpr int Side = lms3dBeamGrid::Side;
static_assert(Side * Side == lms3dBeamPacket::Size, "a packet is square");

/// Beam Side * i + j of a packet belongs to its turn i and elevation j. Beyond the end of the grid a
/// packet repeats the last turn or beam, inactive, so that it stays coherent.
class Scan
{
public:
  explicit Scan(const lms3dScanRequest& request)
    : Request(request)
    , Directions(request.Geometry, request.Pose)
    , Kernels(lms3dGetPacketKernels())
    , Elevations(MakeElevations(request.Geometry))
    , Origin{ { request.Pose.Position[0], request.Pose.Position[1], request.Pose.Position[2] },
      request.Limits.Maximum }
    , Turns(request.Geometry.GetNumberOfTurns())
    , Beams(request.Geometry.GetNumberOfBeams())
    , GridCaster(request.Caster.NewGridCaster(this->Origin,
        { this->Turns, this->Beams, &this->Directions.GetFanAxis(0), request.Geometry.GetBetaStep(),
          request.Geometry.GetAlphaCosines().data(), request.Geometry.GetAlphaSines().data(),
          this->Directions.GetUp() }))
  {
  }

  int GetTurnsOfBand() const { return this->GridCaster->GetTurnsOfBand(); }

  void CastBand(int firstTurn) const
  {
    const int columns = static_cast<int>(this->Elevations.size());
    const int turns = std::min(this->GetTurnsOfBand(), this->Turns - firstTurn);
    const int rows = lms3dBeamGrid::CountPackets(turns);
    const int count = rows * columns;
    // A vector would write zeros first.
    const std::unique_ptr<lms3dBeamPacket[]> packets(new lms3dBeamPacket[count]);
    for (int row = 0; row < rows; ++row)
    {
      this->GenerateRow(firstTurn + row * Side, packets.get() + row * columns);
    }
    this->GridCaster->FindNearest(firstTurn, packets.get(), count);
    if (this->Request.NearestHits.Ranges)
    {
      this->Request.Caster.ComputeRanges(this->Origin, packets.get(), count);
      this->Store(firstTurn, packets.get(), count, this->Request.NearestHits);
    }
    this->Request.Caster.RefineRanges(this->Origin, packets.get(), count);
    for (int i = 0; i < count; ++i)
    {
      this->Kernels.ApplyMinimumRange(this->Request.Limits.Minimum, packets[i]);
    }
    this->Store(firstTurn, packets.get(), count, this->Request.Returns);
  }

private:
  static std::vector<lms3dElevations> MakeElevations(const lms3dScanGeometry& geometry)
  {
    const int beams = geometry.GetNumberOfBeams();
    std::vector<lms3dElevations> elevations(lms3dBeamGrid::CountPackets(beams));
    for (std::size_t column = 0; column < elevations.size(); ++column)
    {
      for (int i = 0; i < lms3dBeamPacket::Size; ++i)
      {
        const int beam = std::min(static_cast<int>(column) * Side + i % Side, beams - 1);
        elevations[column].Cosine[i] = geometry.GetAlphaCosine(beam);
        elevations[column].Sine[i] = geometry.GetAlphaSine(beam);
      }
    }
    return elevations;
  }

  lms3dFanAxes MakeAxes(int firstTurn) const
  {
    lms3dFanAxes axes;
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int i = 0; i < lms3dBeamPacket::Size; ++i)
      {
        const int turn = std::min(firstTurn + i / Side, this->Turns - 1);
        axes.Horizontal[axis][i] = this->Directions.GetFanAxis(turn)[axis];
      }
      axes.Up[axis] = this->Directions.GetUp()[axis];
    }
    return axes;
  }

  void GenerateRow(int firstTurn, lms3dBeamPacket* packets) const
  {
    const lms3dFanAxes axes = this->MakeAxes(firstTurn);
    const int turns = std::min(Side, this->Turns - firstTurn);
    for (std::size_t column = 0; column < this->Elevations.size(); ++column)
    {
      this->Kernels.GenerateDirections(this->Elevations[column], axes, packets[column]);
      packets[column].Active = GetActive(turns, this->CountBeams(column));
    }
  }

  int CountBeams(std::size_t column) const
  {
    return std::min(Side, this->Beams - static_cast<int>(column) * Side);
  }

  static std::uint32_t GetActive(int turns, int beams)
  {
    std::uint32_t active = 0;
    for (int turn = 0; turn < turns; ++turn)
    {
      active |= ((1u << beams) - 1u) << (Side * turn);
    }
    return active;
  }

  void Store(
    int firstTurn, const lms3dBeamPacket* packets, int count, const lms3dBeamHits& hits) const
  {
    const int columns = static_cast<int>(this->Elevations.size());
    for (int i = 0; i < count; ++i)
    {
      this->Store(firstTurn + i / columns * Side, i % columns, packets[i], hits);
    }
  }

  void Store(int firstTurn, std::size_t column, const lms3dBeamPacket& packet,
    const lms3dBeamHits& hits) const
  {
    const int turns = std::min(Side, this->Turns - firstTurn);
    const int beams = this->CountBeams(column);
    std::size_t slot = static_cast<std::size_t>(firstTurn) * this->Beams + column * Side;
    for (int turn = 0; turn < turns; ++turn, slot += this->Beams)
    {
      const double* range = packet.Range + Side * turn;
      const std::int32_t* triangle = packet.Triangle + Side * turn;
      // With a constant count, the compiler does not call a general copy.
      if (beams == Side)
      {
        std::copy_n(range, Side, hits.Ranges + slot);
        std::copy_n(triangle, Side, hits.Triangles + slot);
      }
      else
      {
        std::copy_n(range, beams, hits.Ranges + slot);
        std::copy_n(triangle, beams, hits.Triangles + slot);
      }
    }
  }

  const lms3dScanRequest& Request;
  const lms3dBeamDirections Directions;
  const lms3dPacketKernels& Kernels;
  const std::vector<lms3dElevations> Elevations;
  const lms3dRayOrigin Origin;
  const int Turns;
  const int Beams;
  const std::unique_ptr<const lms3dGridCaster> GridCaster;
};
} // namespace

bool lms3dScan(const lms3dScanRequest& request, const lms3dProgress& progress)
{
  const Scan scan(request);
  const int turns = scan.GetTurnsOfBand();
  const int bands = (request.Geometry.GetNumberOfTurns() - 1) / turns + 1;
  std::atomic<int> bandsDone{ 0 };
  lms3dProgressReporter reporter(progress);

  tbb::parallel_for(tbb::blocked_range<int>(0, bands),
    [&](const tbb::blocked_range<int>& range)
    {
      for (int band = range.begin(); band < range.end() && !reporter.IsStopped(); ++band)
      {
        scan.CastBand(band * turns);
        reporter.Report(static_cast<double>(++bandsDone) / bands);
      }
    });
  return !reporter.IsStopped();
}
