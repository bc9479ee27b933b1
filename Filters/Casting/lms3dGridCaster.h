// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Casts the beams of one whole scan, rectangle by rectangle.
 */
#ifndef lms3dGridCaster_h
#define lms3dGridCaster_h

#include "Casting/lms3dBeamGrid.h"
#include "Kernels/lms3dBeamPacket.h"

#include <bitset>

/// A rectangle of packets in the grid of a scan: rows along its turns, columns along its beams. The
/// packets are ordered by row, then by column.
struct lms3dPacketRectangle
{
  int FirstTurn;
  int FirstBeam;
  int Rows;
  int Columns;
};

class lms3dGridCaster
{
public:
  /// No rectangle has more packets. Enough for the preparations of a call to cost little, and few
  /// enough for the cache.
  static constexpr int MaximumPackets = 64;

  virtual ~lms3dGridCaster() = default;

  ///@{
  /// The rows and columns of the rectangles into which the grid is to be divided, from turn 0 and
  /// beam 0 on. Those at the grid's end can be smaller.
  virtual int GetRows() const = 0;
  virtual int GetColumns() const = 0;
  ///@}

  /// The columns of the parts of a rectangle that CastAtOnce takes.
  virtual int GetColumnsAtOnce() const { return MaximumPackets; }

  /// Stores the final hits of a part of a rectangle if all its beams hit one triangle at ranges
  /// that count, or none: what FindNearest, lms3dRayCaster::RefineRanges and the minimum range
  /// give. Otherwise returns false, and the hits of these beams are undefined. Several threads may
  /// call this at once.
  virtual bool CastAtOnce(
    const lms3dPacketRectangle&, double /*minimumRange*/, const lms3dBeamHits&) const
  {
    return false;
  }

  /// Returns true only if no beam of a rectangle hits a triangle. Such rectangles need not be cast.
  virtual bool IsEmpty(const lms3dPacketRectangle&) const { return false; }

  /// Does what lms3dRayCaster::FindNearest does for the packets of one rectangle. Several threads
  /// may call this at once.
  virtual void FindNearest(
    const lms3dPacketRectangle& rectangle, lms3dBeamPacket* packets) const = 0;
};

/// Some packets of a rectangle, numbered row by row.
using lms3dPacketMask = std::bitset<lms3dGridCaster::MaximumPackets>;

/// Returns the first `count` packets, at least one.
inline lms3dPacketMask lms3dGetFirstPackets(int count)
{
  return ~lms3dPacketMask() >> (lms3dGridCaster::MaximumPackets - count);
}

#endif
