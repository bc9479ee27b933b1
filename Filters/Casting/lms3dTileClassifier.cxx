// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dTileClassifier.h"

#include "Casting/lms3dTriangle.h"

void lms3dTileClassifier::AllocateCorners()
{
  this->Corners.resize(this->View.GetMesh().GetNumberOfTriangles());
}

void lms3dTileClassifier::MakeCorners(std::size_t begin, std::size_t end)
{
  for (std::size_t i = begin; i < end; ++i)
  {
    this->Corners[i] = this->GetCorners(i);
  }
}

lms3dTileCandidateLists lms3dTileClassifier::Classify(const lms3dTileCandidate* candidates,
  std::size_t count, std::uint32_t present, const lms3dTiles& tiles, lms3dNarrowCache* kept) const
{
  lms3dTileCandidateLists parts(count);
  lms3dTileCover cover = {};
  for (std::size_t i = 0; i < count; ++i)
  {
    const lms3dTileCandidate& candidate = candidates[i];
    const std::int32_t triangle = candidate.Triangle;
    lms3dTileMasks masks = { present, candidate.Covers ? present : 0u, 0u };
    this->Kernels.ClassifyTiles(tiles, this->View.GetNarrowTriangle(triangle, kept),
      this->Corners.empty() ? this->GetCorners(triangle) : this->Corners[triangle],
      this->View.GetMinimumInverse(), masks, cover);
    parts.Add(triangle, masks);
  }
  return parts;
}

std::uint32_t lms3dTileClassifier::FindMet(std::int32_t triangle, std::uint32_t present,
  const lms3dTiles& tiles, lms3dNarrowCache* kept) const
{
  lms3dTileMasks masks = { present, 0u, 0u };
  lms3dTileCover cover = {};
  this->Kernels.ClassifyTiles(tiles, this->View.GetNarrowTriangle(triangle, kept),
    this->GetCorners(triangle), this->View.GetMinimumInverse(), masks, cover);
  return masks.Met;
}

lms3dCornerDirections lms3dTileClassifier::GetCorners(std::size_t triangle) const
{
  return lms3dGetCornerDirections(lms3dToSensorFrame(
    lms3dGetCorners(this->View.GetMesh(), triangle), this->View.GetOrigin().Position));
}
