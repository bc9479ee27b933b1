// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Gaps/lms3dBeamStates.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace
{
// With fewer turns, a circle of turns has no neighbours on both sides.
constexpr int MinimumTurnsOfCircle = 3;
} // namespace

lms3dBeamStates::lms3dBeamStates(
  const lms3dRangeGrid& grid, const lms3dMapGeometry& geometry, const std::vector<bool>& isFree)
  : Grid(grid)
  , Geometry(geometry)
  , Turns(grid.GetNumberOfTurns())
  , Beams(grid.GetNumberOfBeams())
  , IsBesideAxis(geometry.GetDistanceFromAxis() > 0.0)
  , States(static_cast<std::size_t>(this->Turns) * this->Beams, Outside)
  , IsPoleBeam(this->Beams, false)
{
  for (int pole : grid.GetPoles())
  {
    this->IsPoleBeam[pole] = true;
  }
  this->FillMeasured(isFree);
  this->FillReturns();
}

void lms3dBeamStates::FillMeasured(const std::vector<bool>& isFree)
{
  const bool isAsScanned = this->Geometry.IsAsScanned();
  if (isAsScanned && isFree.empty())
  {
    std::fill(this->States.begin(), this->States.end(), Missing);
    return;
  }
  if (!isAsScanned)
  {
    this->BeamIds.assign(this->States.size(), NoBeam);
  }
  const int scanned = static_cast<int>(this->Geometry.GetScanned().CountBeamsOfAllTurns());
  for (int id = 0; id < scanned; ++id)
  {
    const int place = isAsScanned ? id : this->Geometry.GetBeamId(id);
    if (place == lms3dMapGeometry::NoBeam)
    {
      continue;
    }
    this->States[place] = !isFree.empty() && isFree[id] ? Free : Missing;
    if (!isAsScanned)
    {
      this->BeamIds[place] = id;
    }
  }
}

// A pole without a return stays open: it is Outside.
void lms3dBeamStates::FillReturns()
{
  tbb::parallel_for(0, this->Turns,
    [this](int turn)
    {
      const double* const ranges = this->Grid.GetRanges(turn);
      for (int beam = 0; beam < this->Beams; ++beam)
      {
        const int place = turn * this->Beams + beam;
        if (ranges[beam] > 0.0)
        {
          this->States[place] = this->IsBeyondAxis(place, ranges[beam]) ? Outside : Returned;
        }
        else if (this->IsPoleBeam[beam])
        {
          this->States[place] = Outside;
        }
      }
    });
}

lms3dMapRay lms3dBeamStates::GetRay(int place) const
{
  const int turn = this->GetTurn(place);
  const int beam = this->GetBeam(place);
  if (!this->Geometry.IsRegular())
  {
    return this->Geometry.GetRay(turn, beam);
  }
  const lms3dScanGeometry& grid = this->Geometry.GetGrid();
  const double cosine = grid.GetAlphaCosine(beam);
  return { { 0.0, 0.0, 0.0 },
    { cosine * grid.GetBetaCosine(turn), -cosine * grid.GetBetaSine(turn),
      grid.GetAlphaSine(beam) } };
}

bool lms3dBeamStates::IsBeyondAxis(int place, double range) const
{
  return this->IsBesideAxis &&
    this->Geometry.IsBeyondAxis(this->GetTurn(place), this->GetBeam(place), range);
}

// The turn `step` after a turn, -1 to 1, or NoPlace.
int lms3dBeamStates::GetTurnBeside(int turn, int step) const
{
  const int seam = this->Geometry.GetSeam();
  const int beside = turn + step;
  const bool isAround = beside < 0 || beside >= this->Turns;
  const bool isAtSeam = seam > 0 && (isAround || (turn < seam) != (beside < seam));
  if (isAtSeam || (isAround && !(this->Grid.IsClosed() && this->Turns >= MinimumTurnsOfCircle)))
  {
    return NoPlace;
  }
  return (beside + this->Turns) % this->Turns;
}

std::array<int, 8> lms3dBeamStates::GetNeighbors(int place) const
{
  const int turn = this->GetTurn(place);
  const int beam = this->GetBeam(place);
  const std::array<int, 3> turns = { this->GetTurnBeside(turn, -1), turn,
    this->GetTurnBeside(turn, 1) };
  const auto getPlace = [&](int step, int besideBeam)
  {
    const int besideTurn = turns[step + 1];
    if (besideTurn == NoPlace || besideBeam < 0 || besideBeam >= this->Beams)
    {
      return NoPlace;
    }
    return (this->IsPoleBeam[besideBeam] ? 0 : besideTurn * this->Beams) + besideBeam;
  };
  return { getPlace(0, beam - 1), getPlace(0, beam + 1), getPlace(-1, beam), getPlace(1, beam),
    getPlace(-1, beam - 1), getPlace(-1, beam + 1), getPlace(1, beam - 1), getPlace(1, beam + 1) };
}
