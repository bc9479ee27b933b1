// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Triangulates a patch so that the error bound holds for each of its returns.
 */
#ifndef lms3dPatchMesher_h
#define lms3dPatchMesher_h

#include "LocalMap/Bounded/lms3dPatchTriangulation.h"
#include "LocalMap/Bounded/lms3dRayCheck.h"

#include <array>
#include <cstdint>
#include <vector>

/// The triangles of a patch.
struct lms3dPatchMesh
{
  /// If false, only Uncovered has a meaning, and Rays if beams are not regular.
  bool IsValid = false;
  /// The vertices that only this patch has. They are numbered from the number of the outlines'
  /// vertices.
  std::vector<lms3dMapVertex> Added;
  /// Numbers of vertices, counter-clockwise as the sensor sees them.
  std::vector<std::array<std::int32_t, 3>> Triangles;
  /// If the mesh is not valid only because some beams of the patch hit no triangle: these beams,
  /// sorted.
  std::vector<lms3dBeamSphere::GridIndex> Uncovered;
  /// The check of beams that are not regular.
  lms3dRayCheck Rays;
};

/**
 * Triangulates the outline of a patch (lms3dPatchTriangulation), then casts all beams at the
 * triangles. If a return is farther than the bound from the triangle that its beam hits, measured
 * along the beam, the beam becomes a vertex, until no return is too far. In the worst case, all
 * returns are vertices, so the bound always holds. A new vertex lies at its return or, if ranges
 * are noisy, off it towards the triangle, as far as noise and bound allow, so that the surface does
 * not follow the noise.
 *
 * A mesh is not valid if the outline crosses itself, if a triangle is hit by a beam of another
 * patch, or if a beam of the patch hits no triangle. If beams are not regular, a mesh is valid if
 * its outline does not cross itself; lms3dCheckRays() finds which beams hit the triangles. A filled
 * entry of the sphere belongs to the patch and has the same bound as a return, but need not hit a
 * triangle.
 */
class lms3dPatchMesher
{
public:
  /// Keeps references. `maximumError` is the bound and `noise` the standard deviation of ranges,
  /// metres.
  lms3dPatchMesher(const lms3dBeamSphere& sphere, const lms3dPatches& patches,
    const lms3dPatchOutlines& outlines, double maximumError, double noise);

  /// Meshes one patch. `members` is the number of its returns, at least one. May be called for
  /// several patches at a time, once for each.
  lms3dPatchMesh Mesh(int patch, int members);

private:
  using GridIndex = lms3dBeamSphere::GridIndex;
  struct Work;

  /// The state of a beam in the mesh of its patch.
  enum State : std::uint8_t
  {
    IsUncovered,
    IsCovered,
    IsVertex
  };

  bool Refine(Work& work);
  bool Check(Work& work);
  bool CheckTriangle(Work& work, int triangle);
  bool CheckBeams(Work& work, int triangle, const lms3dTriangleRasterizer& beams, int column,
    int first, int last);
  bool TryToCoverBeams(
    Work& work, const lms3dTriangleRasterizer::ColumnRanges& hits, int column, int first, int last);
  int CoverBeams(GridIndex first, int count);
  bool InsertBeams(Work& work);
  lms3dMapVertex MakeVertex(GridIndex beam, double hit) const;
  std::vector<GridIndex> FindUncovered(int patch) const;

  const lms3dBeamSphere& Sphere;
  const lms3dPatches& Patches;
  const lms3dPatchOutlines& Outlines;
  const double MaximumError;
  /// How far a new vertex may lie off its return, metres.
  const double MaximumLift;
  /// By grid index. Threads write to the beams of their own patches only.
  std::vector<State> States;
};

#endif
