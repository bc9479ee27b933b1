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

/**
 * The default grid of 361 x 360 beams, sensor upright, against a surface of triangles, all in
 * single precision: a robust scene with its centre as origin, coherent packets of 4 x 4 beams,
 * directions made on the fly from tables of sines and cosines, hits neither read nor written
 * anywhere.
 */
class RawEmbreeScan
{
public:
  /// Builds the tree with a number of threads.
  RawEmbreeScan(vtkPolyData* surface, const double sensor[3], double maximumRange, int threads);
  ~RawEmbreeScan();

  /// Casts all beams.
  void Cast(int threads) const;

  /// Casts all beams and returns how many hit.
  int CountHits() const;

private:
  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
