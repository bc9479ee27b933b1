// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Values at the places of the grid of turns and beams, and on a ring of ghosts around it.
 */
#ifndef lms3dGhostGrid_h
#define lms3dGhostGrid_h

#include <algorithm>
#include <cstddef>
#include <vector>

/**
 * Whoever looks at the neighbours of a place needs not ask where the grid ends: turns -2 to the
 * number of turns + 2 and beams -2 to the number of beams + 1 can be read.
 */
template <typename T>
class lms3dPaddedGrid
{
public:
  lms3dPaddedGrid() = default;

  /// `outside` is the value of ghosts that repeat no place.
  explicit lms3dPaddedGrid(T outside)
    : Outside(outside)
  {
  }

  /// Keeps its memory, and its values where the shape is the same.
  void SetShape(int turns, int beams)
  {
    if (turns != this->Turns || beams != this->Beams)
    {
      this->Turns = turns;
      this->Beams = beams;
      this->Values.assign(this->GetNumberOfRows() * this->GetStride(), this->Outside);
    }
  }

  /// The element at i belongs to beam i of the turn.
  T* GetRow(int turn) { return this->Values.data() + this->GetStart(turn); }
  const T* GetRow(int turn) const { return this->Values.data() + this->GetStart(turn); }

  /// To call when all turns are filled: beyond a closed grid's ends they go on with its other end.
  void FillHalo(bool isClosed)
  {
    for (int ghost = 1; ghost <= HaloTurnsBefore; ++ghost)
    {
      this->FillHaloTurn(-ghost, isClosed);
    }
    for (int ghost = 0; ghost < HaloTurnsAfter; ++ghost)
    {
      this->FillHaloTurn(this->Turns + ghost, isClosed);
    }
  }

private:
  // Of turns; the first turn is a neighbour of the last one, and has two neighbours more.
  static constexpr int HaloTurnsBefore = 2;
  static constexpr int HaloTurnsAfter = 3;
  // Of beams, on either side.
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

  void FillHaloTurn(int ghost, bool isClosed)
  {
    const int turn = (ghost % this->Turns + this->Turns) % this->Turns;
    if (isClosed)
    {
      std::copy_n(this->GetRow(turn), this->Beams, this->GetRow(ghost));
    }
    else
    {
      std::fill_n(this->GetRow(ghost), this->Beams, this->Outside);
    }
  }

  const T Outside = T();
  int Turns = 0;
  int Beams = 0;
  std::vector<T> Values;
};

#endif
