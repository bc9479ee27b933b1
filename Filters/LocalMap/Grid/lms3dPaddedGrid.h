// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A grid of turns and beams, padded by a halo.
 */
#ifndef lms3dPaddedGrid_h
#define lms3dPaddedGrid_h

#include <algorithm>
#include <cstddef>
#include <vector>

/**
 * Holds one value for each beam of each turn. The halo around the grid lets loops read the
 * neighbours of each beam without bounds checks: turns -2 to the number of turns + 2, and beams -2
 * to the number of beams + 1 can be read.
 */
template <typename T>
class lms3dPaddedGrid
{
public:
  lms3dPaddedGrid() = default;

  /// `outside` is the value of the halo where it continues nothing.
  explicit lms3dPaddedGrid(T outside)
    : Outside(outside)
  {
  }

  /// Sets the numbers of turns and beams. If they do not change, the values stay.
  void SetShape(int turns, int beams)
  {
    if (turns != this->Turns || beams != this->Beams)
    {
      this->Turns = turns;
      this->Beams = beams;
      this->Values.assign(this->GetNumberOfRows() * this->GetStride(), this->Outside);
    }
  }

  ///@{
  /// The values of a turn. Element i belongs to beam i; negative i reach into the halo.
  T* GetRow(int turn) { return this->Values.data() + this->GetStart(turn); }
  const T* GetRow(int turn) const { return this->Values.data() + this->GetStart(turn); }
  ///@}

  ///@{
  /// The first turn of the halo, and the end of its last turns.
  int GetFirstTurn() const { return -HaloTurnsBefore; }
  int GetEndOfTurns() const { return this->Turns + HaloTurnsAfter; }
  ///@}

  /// Fills the turns of the halo, after all turns of the grid are filled. If the grid is closed,
  /// they repeat the turns at its other end.
  void FillHalo(bool isClosed)
  {
    for (int distance = 1; distance <= HaloTurnsBefore; ++distance)
    {
      this->FillHaloTurn(-distance, isClosed);
    }
    for (int distance = 0; distance < HaloTurnsAfter; ++distance)
    {
      this->FillHaloTurn(this->Turns + distance, isClosed);
    }
  }

private:
  static constexpr int HaloTurnsBefore = 2;
  // One more than before: the turn after the last is compared with its own two neighbours.
  static constexpr int HaloTurnsAfter = 3;
  // On either side.
  static constexpr int HaloBeams = 2;

  std::size_t GetNumberOfRows() const
  {
    return static_cast<std::size_t>(this->Turns) + HaloTurnsBefore + HaloTurnsAfter;
  }
  std::size_t GetStride() const { return static_cast<std::size_t>(this->Beams) + 2 * HaloBeams; }
  std::size_t GetStart(int turn) const
  {
    return (turn + HaloTurnsBefore) * this->GetStride() + HaloBeams;
  }

  void FillHaloTurn(int haloTurn, bool isClosed)
  {
    const int turn = (haloTurn % this->Turns + this->Turns) % this->Turns;
    if (isClosed)
    {
      std::copy_n(this->GetRow(turn), this->Beams, this->GetRow(haloTurn));
    }
    else
    {
      std::fill_n(this->GetRow(haloTurn), this->Beams, this->Outside);
    }
  }

  const T Outside = T();
  int Turns = 0;
  int Beams = 0;
  std::vector<T> Values;
};

#endif
