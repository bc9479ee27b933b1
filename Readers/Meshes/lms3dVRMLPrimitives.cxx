// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshes/lms3dVRMLGeometry.h"

#include "Geometry/lms3dAngle.h"
#include "Grammar/lms3dVRMLNodeTypes.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace
{
constexpr int MinimumNumberOfSides = 8;
constexpr int MaximumNumberOfSides = 2048;

// Sizes must be positive. For a negative size its absolute value is used, with a message.
double GetSize(lms3dVRMLEvaluator& evaluator, const lms3dVRMLNodeInContext& node, const char* name,
  double fallback)
{
  const double size = evaluator.GetNumber(node, name, fallback);
  if (size <= 0.0)
  {
    evaluator.Warn(
      node, std::string(name) + " of " + std::string(node.Node->TypeName) + " is not positive");
  }
  return std::abs(size);
}

// Returns the radius of the largest circle.
double GetRadius(lms3dVRMLEvaluator& evaluator, const lms3dVRMLNodeInContext& node)
{
  return std::abs(evaluator.GetNumber(
    node, node.Node->Type->Role == lms3dVRMLNodeType::CONE ? "bottomRadius" : "radius", 1.0));
}

/// Appends points on a circle around the y axis. The four points on the x and z axes are exact.
/// Returns the index of the first point.
std::int32_t AddCircle(double radius, double y, int sides, lms3dMesh& mesh)
{
  const std::int32_t first = static_cast<std::int32_t>(mesh.Points.size());
  for (int i = 0; i < sides; ++i)
  {
    const double angle = 2.0 * lms3dPi * i / sides;
    const int quarter = 4 * i / sides;
    const bool isOnAxis = quarter * sides == 4 * i;
    const double sine = isOnAxis ? (quarter == 1) - (quarter == 3) : std::sin(angle);
    const double cosine = isOnAxis ? (quarter == 0) - (quarter == 2) : std::cos(angle);
    mesh.Points.push_back({ radius * sine, y, radius * cosine });
  }
  return first;
}

std::int32_t AddPoint(const lms3dPoint& point, lms3dMesh& mesh)
{
  mesh.Points.push_back(point);
  return static_cast<std::int32_t>(mesh.Points.size()) - 1;
}

/// Appends a band of triangles between two circles of `sides` points.
void AddBand(std::int32_t lower, std::int32_t upper, int sides, lms3dMesh& mesh)
{
  for (int i = 0; i < sides; ++i)
  {
    const int next = (i + 1) % sides;
    lms3dAddQuadrilateral({ lower + i, lower + next, upper + next, upper + i }, mesh);
  }
}

/// Appends triangles from a circle to a point above it.
void AddTip(std::int32_t circle, std::int32_t tip, int sides, lms3dMesh& mesh)
{
  for (int i = 0; i < sides; ++i)
  {
    mesh.Triangles.push_back({ circle + i, circle + (i + 1) % sides, tip });
  }
}

/// Appends a disc that uses the points of the circle only.
void AddDisc(std::int32_t circle, int sides, bool facesUp, lms3dMesh& mesh)
{
  for (int i = 1; i + 1 < sides; ++i)
  {
    mesh.Triangles.push_back(
      { circle, circle + (facesUp ? i : i + 1), circle + (facesUp ? i + 1 : i) });
  }
}
} // namespace

// The distance of a chord over the angle t from its arc is r (1 - cos(t / 2)). The triangles of a
// sphere span t in two directions, so their distance from the centre is r cos(t / 2)^2 or more.
int lms3dCountSides(
  lms3dVRMLEvaluator& evaluator, const lms3dVRMLNodeInContext& geometry, double tolerance)
{
  const lms3dVRMLNodeType::Roles role = geometry.Node->Type->Role;
  const bool isSphere = role == lms3dVRMLNodeType::SPHERE;
  if (!isSphere && role != lms3dVRMLNodeType::CONE && role != lms3dVRMLNodeType::CYLINDER)
  {
    return 0;
  }
  const double share = std::clamp(tolerance / GetRadius(evaluator, geometry), 0.0, 0.5);
  if (std::isnan(share))
  {
    return MinimumNumberOfSides;
  }
  const double halfAngle = std::acos(isSphere ? std::sqrt(1.0 - share) : 1.0 - share);
  const double sides = std::min(lms3dPi / halfAngle, 1e6);
  if (sides > MaximumNumberOfSides)
  {
    evaluator.Warn(geometry,
      std::string(geometry.Node->TypeName) + " would need " +
        std::to_string(static_cast<int>(sides)) + " sides for this ChordError; it gets " +
        std::to_string(MaximumNumberOfSides));
  }
  const int multipleOfFour = 4 * static_cast<int>(std::ceil(sides / 4.0));
  return std::clamp(multipleOfFour, MinimumNumberOfSides, MaximumNumberOfSides);
}

lms3dMesh lms3dMakeBox(lms3dVRMLEvaluator& evaluator, const lms3dVRMLNodeInContext& box)
{
  const std::array<double, 3> size = evaluator.GetVector<3>(box, "size", { 2, 2, 2 });
  if (!(std::min({ size[0], size[1], size[2] }) > 0.0))
  {
    evaluator.Warn(box, "size of Box is not positive");
  }
  lms3dMesh mesh;
  for (int corner = 0; corner < 8; ++corner)
  {
    lms3dPoint point;
    for (int axis = 0; axis < 3; ++axis)
    {
      point[axis] = 0.5 * std::abs(size[axis]) * ((corner >> axis) % 2 == 1 ? 1.0 : -1.0);
    }
    mesh.Points.push_back(point);
  }
  for (const std::array<std::int32_t, 4>& face : { std::array<std::int32_t, 4>{ 0, 4, 6, 2 },
         { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 2, 3, 1 }, { 4, 5, 7, 6 } })
  {
    lms3dAddQuadrilateral(face, mesh);
  }
  return mesh;
}

// The circles of latitude include the equator, so that the mesh has the exact bounds of the sphere.
lms3dMesh lms3dMakeSphere(
  lms3dVRMLEvaluator& evaluator, const lms3dVRMLNodeInContext& sphere, int sides)
{
  const double radius = GetSize(evaluator, sphere, "radius", 1.0);
  lms3dMesh mesh;
  if (radius == 0.0)
  {
    return mesh;
  }
  const int bands = sides / 2;
  std::int32_t below =
    AddCircle(radius * std::sin(lms3dPi / bands), -radius * std::cos(lms3dPi / bands), sides, mesh);
  for (int i = 0; i < sides; ++i)
  {
    mesh.Triangles.push_back({ below + (i + 1) % sides, below + i, sides });
  }
  AddPoint({ 0, -radius, 0 }, mesh);
  for (int band = 2; band < bands; ++band)
  {
    const bool isEquator = 2 * band == bands;
    const double angle = lms3dPi * band / bands;
    const std::int32_t circle = AddCircle(isEquator ? radius : radius * std::sin(angle),
      isEquator ? 0.0 : -radius * std::cos(angle), sides, mesh);
    AddBand(below, circle, sides, mesh);
    below = circle;
  }
  AddTip(below, AddPoint({ 0, radius, 0 }, mesh), sides, mesh);
  return mesh;
}

lms3dMesh lms3dMakeCone(
  lms3dVRMLEvaluator& evaluator, const lms3dVRMLNodeInContext& cone, int sides)
{
  const double radius = GetSize(evaluator, cone, "bottomRadius", 1.0);
  const double height = GetSize(evaluator, cone, "height", 2.0);
  lms3dMesh mesh;
  if (radius == 0.0)
  {
    return mesh;
  }
  const std::int32_t circle = AddCircle(radius, -0.5 * height, sides, mesh);
  if (evaluator.GetBool(cone, "side", true))
  {
    AddTip(circle, AddPoint({ 0, 0.5 * height, 0 }, mesh), sides, mesh);
  }
  if (evaluator.GetBool(cone, "bottom", true))
  {
    AddDisc(circle, sides, false, mesh);
  }
  return mesh;
}

lms3dMesh lms3dMakeCylinder(
  lms3dVRMLEvaluator& evaluator, const lms3dVRMLNodeInContext& cylinder, int sides)
{
  const double radius = GetSize(evaluator, cylinder, "radius", 1.0);
  const double height = GetSize(evaluator, cylinder, "height", 2.0);
  lms3dMesh mesh;
  if (radius == 0.0)
  {
    return mesh;
  }
  const std::int32_t bottom = AddCircle(radius, -0.5 * height, sides, mesh);
  const std::int32_t top = AddCircle(radius, 0.5 * height, sides, mesh);
  if (evaluator.GetBool(cylinder, "side", true))
  {
    AddBand(bottom, top, sides, mesh);
  }
  if (evaluator.GetBool(cylinder, "bottom", true))
  {
    AddDisc(bottom, sides, false, mesh);
  }
  if (evaluator.GetBool(cylinder, "top", true))
  {
    AddDisc(top, sides, true, mesh);
  }
  return mesh;
}
