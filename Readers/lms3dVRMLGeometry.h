// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Makes meshes of VRML97's geometry nodes (ISO/IEC 14772-1, chapter 6).
 */
#ifndef lms3dVRMLGeometry_h
#define lms3dVRMLGeometry_h

#include "lms3dScene.h"
#include "lms3dVRMLEvaluator.h"

#include <memory>

/// The sides of the regular polygon that stands for each circle of a Sphere, Cone or Cylinder, so
/// that its triangles are no farther from it than the tolerance; 0 for all other nodes.
int lms3dCountSides(lms3dVRMLEvaluator& evaluator, const lms3dVRMLView& geometry, double tolerance);

/// Nothing of other nodes. What cannot be made becomes a message.
lms3dMesh lms3dMakeMesh(lms3dVRMLEvaluator& evaluator, const lms3dVRMLView& geometry, int sides);

///@{
/// Those of one kind of node each.
lms3dMesh lms3dMakeBox(lms3dVRMLEvaluator& evaluator, const lms3dVRMLView& box);
lms3dMesh lms3dMakeSphere(lms3dVRMLEvaluator& evaluator, const lms3dVRMLView& sphere, int sides);
lms3dMesh lms3dMakeCone(lms3dVRMLEvaluator& evaluator, const lms3dVRMLView& cone, int sides);
lms3dMesh lms3dMakeCylinder(
  lms3dVRMLEvaluator& evaluator, const lms3dVRMLView& cylinder, int sides);
lms3dMesh lms3dMakeElevationGrid(lms3dVRMLEvaluator& evaluator, const lms3dVRMLView& grid);
lms3dMesh lms3dMakeExtrusion(lms3dVRMLEvaluator& evaluator, const lms3dVRMLView& extrusion);
lms3dMesh lms3dMakeFaceSet(lms3dVRMLEvaluator& evaluator, const lms3dVRMLView& faceSet);
///@}

/// Adds two triangles for a quadrilateral; none where two neighbours are the same point.
void lms3dAddQuadrilateral(const std::array<std::int32_t, 4>& corners, lms3dMesh& mesh);

/// Turns all triangles around.
void lms3dFlip(lms3dMesh& mesh);

#endif
