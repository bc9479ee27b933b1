// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dScanner.h"

#include "Pipeline/lms3dProgressReporter.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace
{
constexpr int Side = lms3dPacketGrid::Side;

class Scan
{
public:
  Scan(const lms3dScanRequest& request, const lms3dScanPlan& plan)
    : Request(request)
    , Plan(plan)
    , GridCaster(*plan.GridCaster)
    , Turns(plan.Grid.Turns)
    , Beams(plan.Grid.Beams)
  {
  }

  int CountRectangles() const { return this->CountRows() * this->CountColumns(); }

  void Cast(int number) const
  {
    const lms3dPacketRectangle rectangle = this->GetRectangle(number);
    if (this->GridCaster.IsEmpty(rectangle))
    {
      this->StoreNothing(rectangle);
    }
    else if (this->Request.NearestHits.Ranges)
    {
      this->Cast(rectangle);
    }
    else
    {
      this->CastParts(rectangle);
    }
  }

private:
  // Part by part, so that the packets stay in the nearest cache.
  void CastParts(const lms3dPacketRectangle& rectangle) const
  {
    const int step = this->GridCaster.GetColumnsAtOnce();
    for (int column = 0; column < rectangle.Columns; column += step)
    {
      const lms3dPacketRectangle part = { rectangle.FirstTurn, rectangle.FirstBeam + column * Side,
        rectangle.Rows, std::min(step, rectangle.Columns - column) };
      if (!this->GridCaster.CastAtOnce(part, this->Request.Limits.Minimum, this->Request.Returns))
      {
        this->Cast(part);
      }
    }
  }

  void Cast(const lms3dPacketRectangle& rectangle) const
  {
    const int count = rectangle.Rows * rectangle.Columns;
    lms3dBeamPacket packets[lms3dGridCaster::MaximumPackets];
    this->Generate(rectangle, packets);
    this->GridCaster.FindNearest(rectangle, packets);
    if (this->Request.NearestHits.Ranges)
    {
      this->Request.Caster.ComputeRanges(this->Plan.Origin, packets, count);
      this->Store(rectangle, packets, this->Request.NearestHits);
    }
    this->Request.Caster.RefineRanges(this->Plan.Origin, packets, count);
    for (int i = 0; i < count; ++i)
    {
      this->Kernels.ApplyMinimumRange(this->Request.Limits.Minimum, packets[i]);
    }
    this->Store(rectangle, packets, this->Request.Returns);
  }

  lms3dFanAxes MakeAxes(int firstTurn) const
  {
    lms3dFanAxes axes;
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int i = 0; i < lms3dBeamPacket::Size; ++i)
      {
        const int turn = std::min(firstTurn + i / Side, this->Turns - 1);
        axes.Horizontal[axis][i] = this->Plan.Directions.GetFanAxis(turn)[axis];
      }
      axes.Up[axis] = this->Plan.Directions.GetUp()[axis];
    }
    return axes;
  }

  int CountRows() const
  {
    return (lms3dBeamGrid::CountPackets(this->Turns) - 1) / this->GridCaster.GetRows() + 1;
  }

  int CountColumns() const
  {
    return (lms3dBeamGrid::CountPackets(this->Beams) - 1) / this->GridCaster.GetColumns() + 1;
  }

  lms3dPacketRectangle GetRectangle(int number) const
  {
    const int row = number / this->CountColumns() * this->GridCaster.GetRows();
    const int column = number % this->CountColumns() * this->GridCaster.GetColumns();
    return { row * Side, column * Side,
      std::min(this->GridCaster.GetRows(), lms3dBeamGrid::CountPackets(this->Turns) - row),
      std::min(this->GridCaster.GetColumns(), lms3dBeamGrid::CountPackets(this->Beams) - column) };
  }

  void Generate(const lms3dPacketRectangle& rectangle, lms3dBeamPacket* packets) const
  {
    const std::size_t firstColumn = rectangle.FirstBeam / Side;
    for (int row = 0; row < rectangle.Rows; ++row)
    {
      const int firstTurn = rectangle.FirstTurn + row * Side;
      const lms3dFanAxes axes = this->MakeAxes(firstTurn);
      for (int i = 0; i < rectangle.Columns; ++i, ++packets)
      {
        this->Kernels.GenerateDirections(this->Plan.Elevations[firstColumn + i], axes, *packets);
        packets->Active = this->Plan.Grid.GetActive(firstTurn, rectangle.FirstBeam + i * Side);
      }
    }
  }

  void StoreNothing(const lms3dPacketRectangle& rectangle) const
  {
    if (this->Request.NearestHits.Ranges)
    {
      this->StoreNothing(rectangle, lms3dBeamPacket::NoRange, this->Request.NearestHits);
    }
    this->StoreNothing(rectangle, std::numeric_limits<double>::quiet_NaN(), this->Request.Returns);
  }

  void StoreNothing(
    const lms3dPacketRectangle& rectangle, double range, const lms3dBeamHits& hits) const
  {
    const int endTurn = std::min(rectangle.FirstTurn + rectangle.Rows * Side, this->Turns);
    const int endBeam = std::min(rectangle.FirstBeam + rectangle.Columns * Side, this->Beams);
    for (int turn = rectangle.FirstTurn; turn < endTurn; ++turn)
    {
      const std::size_t slot = static_cast<std::size_t>(turn) * this->Beams + rectangle.FirstBeam;
      const int beams = endBeam - rectangle.FirstBeam;
      std::fill_n(hits.Ranges + slot, beams, range);
      std::fill_n(hits.Triangles + slot, beams, lms3dBeamPacket::NoTriangle);
    }
  }

  void Store(const lms3dPacketRectangle& rectangle, const lms3dBeamPacket* packets,
    const lms3dBeamHits& hits) const
  {
    for (int row = 0; row < rectangle.Rows; ++row)
    {
      for (int column = 0; column < rectangle.Columns; ++column, ++packets)
      {
        this->Plan.Grid.Store(
          rectangle.FirstTurn + row * Side, rectangle.FirstBeam + column * Side, *packets, hits);
      }
    }
  }

  const lms3dPacketKernels& Kernels = lms3dGetPacketKernels();
  const lms3dScanRequest& Request;
  const lms3dScanPlan& Plan;
  const lms3dGridCaster& GridCaster;
  const int Turns;
  const int Beams;
};
} // namespace

bool lms3dScan(const lms3dScanRequest& request, const lms3dProgress& progress)
{
  std::optional<lms3dScanPlan> own;
  const lms3dScanPlan& plan = request.Plan
    ? *request.Plan
    : own.emplace(request.Caster, request.Geometry, request.Pose, request.Limits.Maximum);
  const Scan scan(request, plan);
  const int rectangles = scan.CountRectangles();
  std::atomic<int> done{ 0 };
  lms3dProgressReporter reporter(progress);

  tbb::parallel_for(tbb::blocked_range<int>(0, rectangles),
    [&](const tbb::blocked_range<int>& range)
    {
      for (int i = range.begin(); i < range.end() && !reporter.IsStopped(); ++i)
      {
        scan.Cast(i);
        reporter.Report(static_cast<double>(++done) / rectangles);
      }
    });
  return !reporter.IsStopped();
}
