// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The connected parts of the cells of a block.
 */
#ifndef lms3dBlockParts_h
#define lms3dBlockParts_h

#include "Fusion/Cells/lms3dRaster.h"

#include <cstdint>
#include <vector>

/// Cells that share a side are connected. Parts are counted from 0, in the order of their first
/// cells.
class lms3dBlockParts
{
public:
  explicit lms3dBlockParts(const lms3dBits& cells);

  int GetCount() const { return this->Count; }

  /// Calls `visit` with a part, a row and bits of the row, for all cells.
  template <typename Visitor>
  void ForRuns(const Visitor& visit) const
  {
    for (const Run& run : this->Runs)
    {
      visit(run.Part, run.Row, run.Bits);
    }
  }

private:
  /// Successive cells of a row.
  struct Run
  {
    std::uint64_t Bits;
    int Row;
    int Part;
  };

  std::vector<Run> Runs;
  int Count = 0;
};

#endif
