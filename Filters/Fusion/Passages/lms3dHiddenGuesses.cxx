// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Passages/lms3dHiddenGuesses.h"

#include "Fusion/Passages/lms3dCutPolygon.h"
#include "Fusion/Passages/lms3dGuessedBlocks.h"
#include "Fusion/Passages/lms3dPlanesOfBeams.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace
{
// The sine of the smallest angle at which a plane can hide another.
constexpr double SmallestSine = 0.17;
// As a share of the bound: how far a guess may lie behind a plane. Less would fray the borders at
// creases.
constexpr double BehindShare = 4.0;
// Metres: how far behind the returns around it a guess is looked for.
constexpr double LargestOvershoot = 5.0;
constexpr double SmallestCosine = 1e-6;

/// Four beams in each of four turns. The guesses lie between the four in the middle.
using Around = std::array<int, 16>;
constexpr std::array<int, 4> Middle = { 5, 6, 10, 9 };

/// The planes of a few beams, each once.
class DifferentPlanes
{
public:
  void Add(int plane)
  {
    if (plane >= 0 && std::find(this->begin(), this->end(), plane) == this->end())
    {
      this->Numbers[this->Count++] = plane;
    }
  }

  const int* begin() const { return this->Numbers.data(); }
  const int* end() const { return this->Numbers.data() + this->Count; }

private:
  std::array<int, 16> Numbers = {};
  std::size_t Count = 0;
};

/// Cells of a plane in which guesses are hidden.
struct HiddenCells
{
  int Plane;
  lms3dCutPolygon Polygon;
};

/// Takes out what is hidden between successive turns. The threads divide turns. They change nothing
/// before all of them have looked at the guesses.
class HiddenGuesses
{
public:
  HiddenGuesses(const lms3dLocalMap& local, const lms3dSeenRanges& ranges,
    const std::vector<int>& planeOfPatch, lms3dFusedPlanes& planes)
    : Local(local)
    , Ranges(ranges)
    , Planes(planes)
    , Beams(local, ranges.GetTable().GetSize(), planeOfPatch, planes)
  {
    for (const int plane : planeOfPatch)
    {
      if (plane >= 0)
      {
        this->Guessed.try_emplace(plane, planes[plane].Raster);
      }
    }
  }

  void TakeOut()
  {
    const lms3dBeamTable& table = this->Ranges.GetTable();
    const int beams = table.GetBeamsOfFan();
    std::vector<Hidden> hidden(static_cast<std::size_t>(table.GetSize() / beams));
    tbb::parallel_for(std::size_t{ 0 }, hidden.size(),
      [&](std::size_t turn) { this->FindInTurn(static_cast<int>(turn) * beams, hidden[turn]); });
    for (const Hidden& cellsOfTurn : hidden)
    {
      for (const HiddenCells& cells : cellsOfTurn)
      {
        this->Guessed.at(cells.Plane).Clear(cells.Polygon, this->Planes[cells.Plane].Raster);
      }
    }
  }

private:
  using Hidden = std::vector<HiddenCells>;

  /// Finds what is hidden between the turn of a first beam and the next three.
  void FindInTurn(int first, Hidden& hidden) const
  {
    const lms3dBeamTable& table = this->Ranges.GetTable();
    lms3dPlanesOfBeams::Turns turns = { first, table.GetNextTurn(first), -1, -1 };
    for (std::size_t i = 2; i < turns.size(); ++i)
    {
      turns[i] = turns[i - 1] < 0 ? -1 : table.GetNextTurn(turns[i - 1]);
    }
    if (turns.back() < 0)
    {
      return;
    }
    for (const int beam : this->Beams.FindMixed(turns, table.GetBeamsOfFan()))
    {
      this->FindBetween(GetAround(turns, beam), hidden);
    }
  }

  static Around GetAround(const lms3dPlanesOfBeams::Turns& turns, int beam)
  {
    Around around = {};
    for (int i = 0; i < static_cast<int>(around.size()); ++i)
    {
      around[i] = turns[i / 4] + beam + i % 4;
    }
    return around;
  }

  void FindBetween(const Around& around, Hidden& hidden) const
  {
    DifferentPlanes guessed;
    for (const int id : around)
    {
      guessed.Add(this->Beams.GetPlane(id));
    }
    DifferentPlanes hiding;
    for (const int i : Middle)
    {
      hiding.Add(this->Beams.GetPlane(around[i]));
    }
    for (const int guess : guessed)
    {
      for (const int other : hiding)
      {
        if (guess != other && this->Planes[guess].Raster.MayHaveGuess() &&
          this->MayHide(around, guess, other))
        {
          this->FindBehind(around, guess, other, hidden);
        }
      }
    }
  }

  /// Whether the planes meet, and no return of the guessed one is behind the other.
  bool MayHide(const Around& around, int guess, int other) const
  {
    const lms3dPlaneFrame& frame = this->Planes[other].Frame;
    const lms3dVector cross = lms3dCross(this->Planes[guess].Frame.GetNormal(), frame.GetNormal());
    return lms3dDot(cross, cross) >= SmallestSine * SmallestSine &&
      std::none_of(around.begin(), around.end(),
        [&](int id)
        {
          return this->Beams.GetPlane(id) == guess &&
            frame.GetHeight(this->Local.Returns[this->Beams.GetReturn(id)].Point) <
            -this->Planes.GetMaximumError();
        });
  }

  void FindBehind(const Around& around, int guess, int other, Hidden& hidden) const
  {
    const lms3dFusedPlane& plane = this->Planes[guess];
    double largest = 0.0;
    for (const int i : Middle)
    {
      largest = std::max(largest, this->Ranges.GetRange(around[i]));
    }
    largest += LargestOvershoot;
    std::array<lms3dCutCorner, 4> corners = {};
    for (std::size_t i = 0; i < Middle.size(); ++i)
    {
      const lms3dVector start = this->Ranges.GetStart(around[Middle[i]]);
      const lms3dVector direction = this->Ranges.GetDirection(around[Middle[i]]);
      const double height = plane.Frame.GetHeight(start);
      const double cosine = -lms3dDot(plane.Frame.GetNormal(), direction);
      if (height <= 0.0)
      {
        return;
      }
      const double range = cosine > SmallestCosine ? std::min(height / cosine, largest) : largest;
      corners[i].Place = plane.Frame.ToCells(lms3dAdd(start, lms3dScale(direction, range)));
      corners[i].Height =
        this->Planes[other].Frame.GetHeight(plane.Frame.ToWorld(corners[i].Place));
    }
    const lms3dCutPolygon polygon =
      lms3dClip(corners, -BehindShare * this->Planes.GetMaximumError());
    if (polygon.size() >= 3 && this->Guessed.at(guess).HasAny(polygon, plane.Raster))
    {
      hidden.push_back({ guess, polygon });
    }
  }

  const lms3dLocalMap& Local;
  const lms3dSeenRanges& Ranges;
  lms3dFusedPlanes& Planes;
  const lms3dPlanesOfBeams Beams;
  /// The blocks with guesses of each plane of a patch.
  std::map<int, lms3dGuessedBlocks> Guessed;
};
} // namespace

void lms3dTakeOutHiddenGuesses(const lms3dLocalMap& local, const lms3dSeenRanges& ranges,
  const std::vector<int>& planeOfPatch, lms3dFusedPlanes& planes)
{
  HiddenGuesses(local, ranges, planeOfPatch, planes).TakeOut();
}
