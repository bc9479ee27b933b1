// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Decides which of some triangles the parts of a block or tile can meet.
 */
#ifndef lms3dTileClassifier_h
#define lms3dTileClassifier_h

#include "Casting/lms3dExactView.h"
#include "Casting/lms3dTileCandidateLists.h"
#include "Kernels/lms3dPacketKernels.h"

#include <cstddef>
#include <cstdint>
#include <vector>

class lms3dTileClassifier
{
public:
  /// The view must have or keep its narrow triangles, and must outlive this object.
  explicit lms3dTileClassifier(const lms3dExactView& view)
    : View(view)
  {
  }

  ///@{
  /// Computes the directions of the triangles' corners beforehand: memory for all triangles, then
  /// the triangles from `begin` up to, but not including, `end`. Without AllocateCorners, they are
  /// computed where they are needed.
  void AllocateCorners();
  void MakeCorners(std::size_t begin, std::size_t end);
  ///@}

  /// `kept` is the view's GetKept. `present` has the parts that the grid has.
  lms3dTileCandidateLists Classify(const lms3dTileCandidate* candidates, std::size_t count,
    std::uint32_t present, const lms3dTiles& tiles, lms3dNarrowCache* kept) const;

  /// Returns the tiles among `present` that one triangle can meet.
  std::uint32_t FindMet(std::int32_t triangle, std::uint32_t present, const lms3dTiles& tiles,
    lms3dNarrowCache* kept) const;

  const lms3dExactView& GetView() const { return this->View; }

private:
  lms3dCornerDirections GetCorners(std::size_t triangle) const;

  const lms3dPacketKernels& Kernels = lms3dGetPacketKernels();
  const lms3dExactView& View;

  /// One for each triangle, or none.
  std::vector<lms3dCornerDirections> Corners;
};

#endif
