// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Makes meshes from the geometry nodes of VRML97 (ISO/IEC 14772-1, chapter 6).
 */
#ifndef lms3dVRMLGeometry_h
#define lms3dVRMLGeometry_h

#include "Evaluation/lms3dVRMLEvaluator.h"
#include "Model/lms3dScene.h"

#include <memory>

/// Returns the number of sides of the regular polygons that approximate the circles of a Sphere,
/// Cone or Cylinder. No triangle is farther from the true surface than `tolerance` (local units),
/// unless the maximum of 2,048 sides is too small; then adds a message. Returns 0 for all other
/// nodes.
int lms3dCountSides(
  lms3dVRMLEvaluator& evaluator, const lms3dVRMLNodeInContext& geometry, double tolerance);

/// Makes the mesh of a geometry node that was expanded. `sides` comes from lms3dCountSides().
/// Returns an empty mesh for nodes without surfaces. Adds a message for each face that cannot be
/// made.
lms3dMesh lms3dMakeMesh(
  lms3dVRMLEvaluator& evaluator, const lms3dVRMLNodeInContext& geometry, int sides);

///@{
/// Make the mesh of one kind of node each.
lms3dMesh lms3dMakeBox(lms3dVRMLEvaluator& evaluator, const lms3dVRMLNodeInContext& box);
lms3dMesh lms3dMakeSphere(
  lms3dVRMLEvaluator& evaluator, const lms3dVRMLNodeInContext& sphere, int sides);
lms3dMesh lms3dMakeCone(
  lms3dVRMLEvaluator& evaluator, const lms3dVRMLNodeInContext& cone, int sides);
lms3dMesh lms3dMakeCylinder(
  lms3dVRMLEvaluator& evaluator, const lms3dVRMLNodeInContext& cylinder, int sides);
lms3dMesh lms3dMakeElevationGrid(lms3dVRMLEvaluator& evaluator, const lms3dVRMLNodeInContext& grid);
lms3dMesh lms3dMakeExtrusion(
  lms3dVRMLEvaluator& evaluator, const lms3dVRMLNodeInContext& extrusion);
lms3dMesh lms3dMakeFaceSet(lms3dVRMLEvaluator& evaluator, const lms3dVRMLNodeInContext& faceSet);
///@}

/// Appends two triangles for a quadrilateral, split from corner 0 to corner 2. Skips triangles that
/// have two equal points.
void lms3dAddQuadrilateral(const std::array<std::int32_t, 4>& corners, lms3dMesh& mesh);

/// Reverses the orientation of all triangles.
void lms3dFlip(lms3dMesh& mesh);

/// Returns the largest absolute coordinate of the mesh, or infinity if any coordinate is not
/// finite.
double lms3dGetLargestCoordinate(const lms3dMesh& mesh);

#endif
