// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Where the surface may meet each beam.
 */
#ifndef lms3dBeamDemands_h
#define lms3dBeamDemands_h

#include "LocalMap/Patches/lms3dPatches.h"

#include <memory>

/// The inverse ranges of returns, 1/metre, and the inverse ranges within the bound of them.
class lms3dBeamDemands
{
public:
  using GridIndex = lms3dBeamSphere::GridIndex;

  /// What a return demands of the surface on its beam.
  struct Demand
  {
    /// The smallest and the largest inverse range within the bound.
    double Minimum;
    double Maximum;
    double Inverse;
    /// The weight of a difference in inverse range; 0 if the beam demands nothing.
    double Weight;
  };

  /// Keeps a reference to the sphere, whose beams must be regular. `maximumError` is the bound, metres. Returns
  /// without a patch demand nothing; filled beams demand the same as returns. Uses the threads of the calling TBB arena.
  lms3dBeamDemands(const lms3dBeamSphere& sphere, const lms3dPatches& patches, double maximumError);

  const lms3dBeamSphere& GetSphere() const { return this->Sphere; }
  const Demand& operator[](GridIndex index) const { return this->Demands[index]; }

private:
  void FillColumn(const lms3dPatches& patches, double maximumError, int column);

  const lms3dBeamSphere& Sphere;
  /// Not a vector, which would initialize all of it at first.
  std::unique_ptr<Demand[]> Demands;
};

#endif
