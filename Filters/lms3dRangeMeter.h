// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Measures the range of beams whose triangle is known, to the last bits of a double.
 */
#ifndef lms3dRangeMeter_h
#define lms3dRangeMeter_h

#include "lms3dPacketKernels.h"
#include "lms3dTriangleMesh.h"

/// Keeps the planes that it met last, since neighbouring packets meet the same. One thread each.
class lms3dRangeMeter
{
public:
  lms3dRangeMeter(const lms3dTriangleMesh& mesh, const lms3dViewpoint& viewpoint);

  /// Sets Range of all beams with a Triangle; takes the hit back where it is not above 0, or too
  /// far.
  void Measure(lms3dBeamPacket& packet);

private:
  struct Entry
  {
    std::int32_t Triangle = lms3dBeamPacket::NoTriangle;
    bool IsNear;
    lms3dSeenPlane Plane;
  };

  const Entry& GetEntry(std::int32_t triangle);
  void MeasureAll(std::int32_t triangle, const lms3dBeamPacket& packet, double* ranges);

  static constexpr int NumberOfEntries = 64;

  const lms3dTriangleMesh& Mesh;
  const lms3dViewpoint& Viewpoint;
  const lms3dPacketKernels& Kernels;
  Entry Entries[NumberOfEntries];
};

/// Measures all packets of a scene that was cast.
void lms3dMeasureRanges(const lms3dTriangleMesh& mesh, const lms3dViewpoint& viewpoint,
  lms3dBeamPacket* packets, int count);

#endif
