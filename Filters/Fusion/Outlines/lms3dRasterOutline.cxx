// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Outlines/lms3dRasterOutline.h"

#include <cstddef>
#include <utility>

namespace
{
constexpr int Last = lms3dRaster::Size - 1;

/// Walks along borders with the cells on its left.
class Tracer
{
public:
  explicit Tracer(const lms3dRegion& raster)
    : Raster(raster)
    , Visited(static_cast<std::size_t>(raster.GetNumberOfBlocks()), lms3dBits{})
  {
  }

  std::vector<lms3dLoop> Trace()
  {
    std::vector<lms3dLoop> loops;
    for (int number = 0; number < this->Raster.GetNumberOfBlocks(); ++number)
    {
      const lms3dRegionBlock& block = this->Raster.GetBlock(number);
      for (int row = 0; row <= Last; ++row)
      {
        this->TraceRow(number, block, row, loops);
      }
    }
    return loops;
  }

private:
  /// Starts at cells without a cell below, which each outline has.
  void TraceRow(int number, const lms3dRegionBlock& block, int row, std::vector<lms3dLoop>& loops)
  {
    const int below = row > 0 ? number : this->Raster.Find(block.U, block.V - 1);
    const std::uint64_t word = below < 0 ? 0 : this->Raster.GetBlock(below).May[(row - 1) & Last];
    for (std::uint64_t starts = block.May[row] & ~word; starts != 0; starts &= starts - 1)
    {
      const int place = lms3dGetFirstBit(starts);
      if ((this->Visited[number][row] >> place & 1U) == 0)
      {
        loops.push_back(
          this->Walk(block.U * lms3dRaster::Size + place, block.V * lms3dRaster::Size + row));
      }
    }
  }

  bool IsCell(std::int32_t u, std::int32_t v)
  {
    const int number = this->FindBlock(u, v);
    return number >= 0 && (this->Raster.GetBlock(number).May[v & Last] >> (u & Last) & 1U) != 0;
  }

  int FindBlock(std::int32_t u, std::int32_t v)
  {
    const std::int32_t blockU = lms3dRaster::GetBlockOf(u);
    const std::int32_t blockV = lms3dRaster::GetBlockOf(v);
    if (blockU != this->LastU || blockV != this->LastV || !this->HasLast)
    {
      this->HasLast = true;
      this->LastU = blockU;
      this->LastV = blockV;
      this->LastNumber = this->Raster.Find(blockU, blockV);
    }
    return this->LastNumber;
  }

  lms3dLoop Walk(std::int32_t u, std::int32_t v)
  {
    const std::int32_t startU = u;
    const std::int32_t startV = v;
    int du = 1;
    int dv = 0;
    lms3dLoop loop;
    do
    {
      if (du == 1)
      {
        this->Visited[this->FindBlock(u, v)][v & Last] |= std::uint64_t{ 1 } << (u & Last);
      }
      u += du;
      v += dv;
      if (this->Turn(u, v, du, dv))
      {
        loop.push_back({ static_cast<double>(u), static_cast<double>(v) });
      }
    } while (u != startU || v != startV || du != 1);
    return loop;
  }

  /// Turns at a corner of cells if the border does.
  bool Turn(std::int32_t u, std::int32_t v, int& du, int& dv)
  {
    // The cells ahead, left and right of the direction.
    const std::int32_t leftU = u + (du != 0 ? (du > 0 ? 0 : -1) : (dv > 0 ? -1 : 0));
    const std::int32_t leftV = v + (dv != 0 ? (dv > 0 ? 0 : -1) : (du > 0 ? 0 : -1));
    if (!this->IsCell(leftU, leftV))
    {
      std::swap(du, dv);
      du = -du;
      return true;
    }
    const std::int32_t rightU = dv != 0 ? (dv > 0 ? u : u - 1) : leftU;
    const std::int32_t rightV = du != 0 ? (du > 0 ? v - 1 : v) : leftV;
    if (this->IsCell(rightU, rightV))
    {
      std::swap(du, dv);
      dv = -dv;
      return true;
    }
    return false;
  }

  const lms3dRegion& Raster;
  /// Cells whose lower side was walked along.
  std::vector<lms3dBits> Visited;
  bool HasLast = false;
  std::int32_t LastU = 0;
  std::int32_t LastV = 0;
  int LastNumber = -1;
};
} // namespace

std::vector<lms3dLoop> lms3dTraceOutlines(const lms3dRegion& raster)
{
  return Tracer(raster).Trace();
}

// The area is relative to a corner, so that its rounding is that of the loop's size.
bool lms3dIsAroundCells(const lms3dLoop& loop)
{
  double area = 0.0;
  for (std::size_t i = 2; i < loop.size(); ++i)
  {
    area += (loop[i - 1][0] - loop[0][0]) * (loop[i][1] - loop[0][1]) -
      (loop[i - 1][1] - loop[0][1]) * (loop[i][0] - loop[0][0]);
  }
  return area > 0.0;
}
