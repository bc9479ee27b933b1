// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The least that a scan can cost: Embree's own packets, with nothing done before or after.
 */
#ifndef RawEmbreeScan_h
#define RawEmbreeScan_h

#include <memory>

class vtkPolyData;

/// The default grid of 361 x 360 beams against a surface of triangles, in single precision.
class RawEmbreeScan
{
public:
  RawEmbreeScan(vtkPolyData* surface, const double sensor[3]);
  ~RawEmbreeScan();

  /// Casts all beams, and keeps only how many of them hit.
  int Cast(int threads);

private:
  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
