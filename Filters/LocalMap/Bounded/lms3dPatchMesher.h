// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Triangulates a patch, and makes sure of the bound for each of its returns.
 */
#ifndef lms3dPatchMesher_h
#define lms3dPatchMesher_h

#include "LocalMap/Borders/lms3dPatchOutlines.h"
#include "LocalMap/Bounded/lms3dTriangleRasterizer.h"
#include "Triangulation/lms3dTriangulation.h"

#include <cstdint>
#include <vector>

/// The triangles of a patch. Numbers from the number of the outlines' vertices on are those of Added.
struct lms3dPatchMesh
{
  bool IsValid = false;
  std::vector<lms3dMapVertex> Added;
  std::vector<std::array<std::int32_t, 3>> Triangles;
  /// No return is farther than so many metres from the triangle that its beam meets, along the beam.
  double DeviationOnBeams = 0.0;
  /// Where it is not valid only because beams of the patch meet no triangle: these, in order.
  std::vector<lms3dBeamSphere::GridIndex> Unmet;
};

/**
 * The outline is triangulated as it is seen against the patch's plane, where nearness is that of the
 * surface itself. Then the beams of every triangle are compared with it, and where a return is
 * farther from the triangle than the bound, measured along the beam, the beam becomes a vertex: at
 * its return or, where the ranges are noisy, off it towards the triangle, by as much as noise and
 * bound allow, so that the surface does not follow the noise. That goes on until no return is too
 * far: at worst, all are vertices. A mesh is not valid where the outline crosses itself, or where a
 * triangle meets a beam that is not the patch's, or none one that is.
 */
class lms3dPatchMesher
{
public:
  lms3dPatchMesher(const lms3dBeamSphere& sphere, const lms3dPatches& patches,
    const lms3dPatchOutlines& outlines, double maximumError, double noise);

  /// `members` is the number of the patch's returns; may be called for several patches at a time.
  lms3dPatchMesh Mesh(int patch, int members);

private:
  using GridIndex = lms3dBeamSphere::GridIndex;
  struct Work;

  /// Of a beam in the mesh of its patch.
  enum State : std::uint8_t
  {
    IsUnmet,
    IsMet,
    IsVertex
  };

  bool Project(Work& work) const;
  bool ProjectAlong(Work& work, const lms3dVector& axis) const;
  bool Refine(Work& work);
  bool Check(Work& work);
  bool CheckTriangle(Work& work, int triangle);
  bool CheckBeams(
    Work& work, int triangle, const lms3dPlane& plane, int column, int first, int last);
  void FindUnmet(Work& work) const;
  bool InsertBeams(Work& work);
  void Finish(Work& work) const;

  const lms3dBeamSphere& Sphere;
  const lms3dPatches& Patches;
  const lms3dPatchOutlines& Outlines;
  const double MaximumError;
  /// How far a vertex may be off its return, metres.
  const double Lift;
  std::vector<State> States;
};

#endif
