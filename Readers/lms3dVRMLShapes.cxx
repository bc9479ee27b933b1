// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dVRMLTraversal.h"

#include "Geometry/lms3dVector.h"
#include "lms3dUTF8.h"
#include "lms3dVRMLColors.h"
#include "lms3dVRMLContext.h"
#include "lms3dVRMLGeometry.h"
#include "lms3dVRMLNodeTypes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace
{
// Infinite where a point is not finite.
double GetLargestCoordinate(const lms3dMesh& mesh)
{
  double largest = 0.0;
  for (const lms3dPoint& point : mesh.Points)
  {
    if (!lms3dIsFinite(point))
    {
      return std::numeric_limits<double>::infinity();
    }
    largest = std::max({ largest, std::abs(point[0]), std::abs(point[1]), std::abs(point[2]) });
  }
  return largest;
}

// Points without a triangle count for nothing; let them take no room.
lms3dMesh MakeMesh(lms3dVRMLEvaluator& evaluator, const lms3dVRMLView& geometry, int sides)
{
  lms3dMesh mesh = lms3dMakeMesh(evaluator, geometry, sides);
  return mesh.Triangles.empty() ? lms3dMesh() : std::move(mesh);
}
} // namespace

bool lms3dVRMLTraversal::HasSurface(const lms3dVRMLView& geometry)
{
  const lms3dVRMLNodeType* type = geometry.Node ? geometry.Node->Type : nullptr;
  if (geometry.Node && (!type || !type->IsGeometry()))
  {
    this->Evaluator.Lose(geometry,
      type ? std::string(type->Name) + " is the geometry of a Shape, but has none"
           : lms3dExplainUnknownNode(geometry.Node->TypeName));
    return false;
  }
  return geometry.Node && type->Role != lms3dVRMLNodeType::OTHER_GEOMETRY;
}

void lms3dVRMLTraversal::ShowShape(const lms3dVRMLView& view, const Place& place)
{
  const lms3dVRMLView geometry = this->Evaluator.GetNode(view, "geometry");
  if (!this->HasSurface(geometry))
  {
    return;
  }
  const Mesh& mesh = this->GetMesh(geometry, place);
  const std::size_t count = mesh.Triangles->Triangles.size();
  if (count == 0 ||
    !this->Context.CountTriangles(count, geometry.Node->Document->FileName, geometry.Node->Line))
  {
    return;
  }
  if (!place.ToWorld.IsFinite(mesh.LargestCoordinate))
  {
    this->Evaluator.Lose(
      view, "a Shape is lost: its size or the transforms around it are not finite");
    return;
  }
  lms3dShape shape;
  shape.Name = lms3dToUTF8(place.Name);
  shape.ToWorld = place.ToWorld;
  shape.Mesh = mesh.Triangles;
  this->SetColor(view, shape);
  this->Shapes.push_back(std::move(shape));
}

const lms3dVRMLTraversal::Mesh& lms3dVRMLTraversal::GetMesh(
  const lms3dVRMLView& geometry, const Place& place)
{
  const double scale = place.ToWorld.GetLargestScale();
  const int sides =
    lms3dCountSides(this->Evaluator, geometry, this->Context.Options.ChordError / scale);
  const lms3dVRMLInstance* const instance =
    this->Evaluator.MayDependOnInstance(geometry) ? geometry.Instance : nullptr;
  const auto [found, isNew] = this->Meshes.try_emplace({ geometry.Node, instance, sides });
  Mesh& mesh = found->second;
  if (isNew)
  {
    mesh.Triangles = std::make_shared<lms3dMesh>(MakeMesh(this->Evaluator, geometry, sides));
    mesh.LargestCoordinate = GetLargestCoordinate(*mesh.Triangles);
  }
  return mesh;
}

// Without a Material a Shape is white, and as bright as can be.
void lms3dVRMLTraversal::SetColor(const lms3dVRMLView& shape, lms3dShape& result)
{
  const lms3dVRMLView appearance = this->Evaluator.GetNode(shape, "appearance", "Appearance");
  const lms3dVRMLView material =
    appearance.Node ? this->Evaluator.GetNode(appearance, "material", "Material") : lms3dVRMLView();
  if (material.Node)
  {
    result.Color =
      lms3dMakeColor(this->Evaluator.GetVector<3>(material, "diffuseColor", { 0.8, 0.8, 0.8 }));
    const double transparency = this->Evaluator.GetNumber(material, "transparency", 0.0);
    result.Opacity =
      static_cast<std::uint8_t>(std::lround(255.0 * (1.0 - std::clamp(transparency, 0.0, 1.0))));
  }
}
