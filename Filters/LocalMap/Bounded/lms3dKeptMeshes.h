// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The meshes of an attempt that the next attempt need not make again.
 */
#ifndef lms3dKeptMeshes_h
#define lms3dKeptMeshes_h

#include "LocalMap/Borders/lms3dPatchOutlines.h"
#include "LocalMap/Bounded/lms3dPatchMesher.h"

#include <cstdint>
#include <vector>

/**
 * A mesh depends on the plane, the returns and the outline of its patch only. After some patches
 * failed and were split, most others have the same returns and the same outline as before. Only the
 * numbers of its vertices change.
 *
 * Beams must be regular.
 */
class lms3dKeptMeshes
{
public:
  /// Keeps the meshes of patches. `labels` are those with which the meshes were made.
  void Keep(lms3dBeamVector<std::int32_t> labels, const lms3dPatchOutlines& outlines,
    std::vector<lms3dPatchMesh> meshes);

  /// Finds the patches whose returns are not the same any more. To be called before TryToTake().
  void FindChanges(const lms3dPatches& patches);

  /// Gives a mesh away with the numbers of these outlines. Returns false if it was not valid, or if
  /// the patch or its outline has changed. May be called for several patches at a time.
  bool TryToTake(int patch, const lms3dPatchOutlines& outlines, lms3dPatchMesh& mesh);

private:
  /// A vertex of an outline: its old number and its new one.
  struct Number
  {
    std::int32_t Old;
    std::int32_t New;
  };

  std::vector<Number> MatchOutlines(int patch, const lms3dPatchOutlines& outlines) const;
  bool AreSameVertices(
    const std::vector<Number>& sorted, const std::vector<lms3dMapVertex>& vertices) const;

  lms3dBeamVector<std::int32_t> Labels;
  std::vector<lms3dMapVertex> Vertices;
  ///@{
  /// By patch.
  std::vector<lms3dPatchOutlines::Outline> Outlines;
  std::vector<lms3dPatchMesh> Meshes;
  std::vector<bool> HasChanged;
  ///@}
};

#endif
