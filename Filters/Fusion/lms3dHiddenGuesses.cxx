// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dHiddenGuesses.h"

#include "Fusion/lms3dCutPolygon.h"
#include "Fusion/lms3dRasterRows.h"

#include <algorithm>
#include <array>
#include <cmath>

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
// How many beams of a turn are looked at together.
constexpr int BeamsAtOnce = 16;

/// The planes of a few beams, each once.
class PlanesOfBeams
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

class HiddenGuesses
{
public:
  HiddenGuesses(const lms3dLocalMap& local, const lms3dSeenRanges& ranges,
    const std::vector<int>& planeOfPatch, lms3dFusedPlanes& planes)
    : Local(local)
    , Ranges(ranges)
    , Planes(planes)
    , PlaneOfBeam(static_cast<std::size_t>(ranges.GetTable().GetSize()), -1)
    , ReturnOfBeam(PlaneOfBeam)
  {
    for (std::size_t i = 0; i < local.Returns.size(); ++i)
    {
      const lms3dMappedReturn& mapped = local.Returns[i];
      const int patch = local.PatchIds[mapped.Triangle];
      const int plane = patch < 0 ? -1 : planeOfPatch[patch];
      const bool isOnPlane = plane >= 0 &&
        std::abs(planes[plane].Frame.GetHeight(mapped.Point)) <= planes.GetMaximumError();
      this->PlaneOfBeam[mapped.BeamId] = isOnPlane ? plane : -1;
      this->ReturnOfBeam[mapped.BeamId] = static_cast<int>(i);
    }
  }

  void TakeOut()
  {
    const lms3dBeamTable& table = this->Ranges.GetTable();
    const int beams = table.GetBeamsOfFan();
    for (int first = 0; first < table.GetSize(); first += beams)
    {
      std::array<int, 4> turns = { first, table.GetNextTurn(first), -1, -1 };
      for (std::size_t i = 2; i < turns.size(); ++i)
      {
        turns[i] = turns[i - 1] < 0 ? -1 : table.GetNextTurn(turns[i - 1]);
      }
      // The first of the beams that have the plane of the last one in all turns.
      int same = 0;
      for (int last = 0; turns[3] >= 0 && last < beams; ++last)
      {
        if (!this->HasOnePlane(turns, last))
        {
          same = last + 1;
        }
        else if (this->PlaneOfBeam[first + last] != this->PlaneOfBeam[first + same])
        {
          same = last;
        }
        if (last >= 3 && same > last - 3)
        {
          this->TakeOutBetween(GetAround(turns, last - 3));
        }
        else if (same <= last - 3 && this->HaveOnePlane(turns, last, beams))
        {
          last += BeamsAtOnce;
        }
      }
    }
  }

private:
  static Around GetAround(const std::array<int, 4>& turns, int beam)
  {
    Around around = {};
    for (int i = 0; i < static_cast<int>(around.size()); ++i)
    {
      around[i] = turns[i / 4] + beam + i % 4;
    }
    return around;
  }

  /// Whether the beams of the turns have one plane.
  bool HasOnePlane(const std::array<int, 4>& turns, int beam) const
  {
    const int* const planes = this->PlaneOfBeam.data() + beam;
    const int first = planes[turns[0]];
    return ((planes[turns[1]] ^ first) | (planes[turns[2]] ^ first) | (planes[turns[3]] ^ first)) ==
      0;
  }

  /// Whether the beams of the turns behind one beam, and this beam, have one plane.
  bool HaveOnePlane(const std::array<int, 4>& turns, int beam, int beams) const
  {
    if (beam + BeamsAtOnce >= beams)
    {
      return false;
    }
    const int plane = this->PlaneOfBeam[turns[0] + beam];
    int different = 0;
    for (const int turn : turns)
    {
      const int* const planes = this->PlaneOfBeam.data() + turn + beam;
      for (int i = 1; i <= BeamsAtOnce; ++i)
      {
        different |= planes[i] ^ plane;
      }
    }
    return different == 0;
  }

  void TakeOutBetween(const Around& around)
  {
    PlanesOfBeams guessed;
    for (const int id : around)
    {
      guessed.Add(this->PlaneOfBeam[id]);
    }
    PlanesOfBeams hiding;
    for (const int i : Middle)
    {
      hiding.Add(this->PlaneOfBeam[around[i]]);
    }
    for (const int guess : guessed)
    {
      for (const int other : hiding)
      {
        if (guess != other && this->Planes[guess].Raster.MayHaveGuess() &&
          this->MayHide(around, guess, other))
        {
          this->TakeOutBehind(around, guess, other);
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
          return this->PlaneOfBeam[id] == guess &&
            frame.GetHeight(this->Local.Returns[this->ReturnOfBeam[id]].Point) <
            -this->Planes.GetMaximumError();
        });
  }

  void TakeOutBehind(const Around& around, int guess, int other)
  {
    lms3dFusedPlane& plane = this->Planes[guess];
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
    const lms3dCutPolygon hidden =
      lms3dClip(corners, -BehindShare * this->Planes.GetMaximumError());
    if (hidden.size() < 3 || !plane.Raster.MayHaveGuess(lms3dGetTouchedBox(hidden)))
    {
      return;
    }
    lms3dForCentreRows(hidden,
      [&](std::int32_t row, std::int32_t first, std::int32_t last)
      {
        plane.Raster.SetRow(&lms3dRasterBlock::Guess, row, first, last, false, false, [](int) {});
        return true;
      });
  }

  const lms3dLocalMap& Local;
  const lms3dSeenRanges& Ranges;
  lms3dFusedPlanes& Planes;
  std::vector<int> PlaneOfBeam;
  std::vector<int> ReturnOfBeam;
};
} // namespace

void lms3dTakeOutHiddenGuesses(const lms3dLocalMap& local, const lms3dSeenRanges& ranges,
  const std::vector<int>& planeOfPatch, lms3dFusedPlanes& planes)
{
  HiddenGuesses(local, ranges, planeOfPatch, planes).TakeOut();
}
