// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Where the surface may meet each beam.
 */
#ifndef lms3dBeamDemands_h
#define lms3dBeamDemands_h

#include "LocalMap/Patches/lms3dBeamVector.h"
#include "LocalMap/Patches/lms3dPatches.h"

/// The inverse ranges of returns, 1/metre, and the inverse ranges within the bound of them.
class lms3dBeamDemands
{
public:
  using GridIndex = lms3dBeamSphere::GridIndex;

  /// What the returns of consecutive rows of a column demand of the surface on their beams, from
  /// one row on.
  struct Demands
  {
    /// The smallest and the largest inverse range within the bound; -inf and inf if the beam
    /// demands nothing.
    const double* Minimum;
    const double* Maximum;
  };

  /// Keeps a reference to the sphere, whose beams must be regular. `maximumError` is the bound,
  /// metres. Returns without a patch demand nothing; filled beams demand the same as returns. Uses
  /// the threads of the calling TBB arena.
  lms3dBeamDemands(const lms3dBeamSphere& sphere, const lms3dPatches& patches, double maximumError);

  const lms3dBeamSphere& GetSphere() const { return this->Sphere; }
  Demands operator[](GridIndex index) const
  {
    return { this->Minima.data() + index, this->Maxima.data() + index };
  }

private:
  void FillColumn(const lms3dPatches& patches, double maximumError, int column);

  const lms3dBeamSphere& Sphere;
  ///@{
  /// As in Demands, of all entries.
  lms3dBeamVector<double> Minima;
  lms3dBeamVector<double> Maxima;
  ///@}
};

#endif
