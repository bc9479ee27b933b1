// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Straightens the chains of borders.
 */
#ifndef lms3dBorderPaths_h
#define lms3dBorderPaths_h

#include "LocalMap/Borders/lms3dBorderJunctions.h"
#include "LocalMap/Borders/lms3dMinimumLinkPath.h"

#include <cstddef>
#include <vector>

/**
 * Turns a chain of edges into the few vertices at which the straightened border bends, between the
 * junctions at its ends. See lms3dBorderGates for the words.
 */
class lms3dBorderPaths
{
public:
  using Chain = lms3dBorderChains::Chain;

  /// Keeps references.
  lms3dBorderPaths(const lms3dBeamSphere& sphere, const lms3dBorderGates& gates,
    const lms3dBorderRanges& borderRanges, const lms3dBorderChains& chains,
    const lms3dBorderJunctions& junctions)
    : Sphere(sphere)
    , Gates(gates)
    , BorderRanges(borderRanges)
    , Chains(chains)
    , Junctions(junctions)
  {
  }

  /// The vertices of a chain between its junctions, in order. Along an offset, each bend has two:
  /// one for the chain's own side, then one for the other side. `vertices` starts with the vertices
  /// of all junctions. May be called for several chains at a time.
  std::vector<lms3dMapVertex> Straighten(
    std::size_t chain, const std::vector<lms3dMapVertex>& vertices) const;

private:
  using Path = lms3dMinimumLinkPath;

  std::vector<Path::Gate> GetPathGates(const Chain& chain) const;
  void LimitExtension(int edge, Path::Gate& gate) const;
  std::vector<Path::Vertex> FindBends(std::size_t number, const std::vector<Path::Gate>& gates,
    const std::vector<lms3dMapVertex>& vertices) const;
  std::vector<Path::Vertex> FindOpenBends(
    std::size_t number, const Path& path, const std::vector<lms3dMapVertex>& vertices) const;
  void AppendVertices(int edge, double at, std::vector<lms3dMapVertex>& out) const;

  const lms3dBeamSphere& Sphere;
  const lms3dBorderGates& Gates;
  const lms3dBorderRanges& BorderRanges;
  const lms3dBorderChains& Chains;
  const lms3dBorderJunctions& Junctions;
};

#endif
