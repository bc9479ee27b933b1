// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes/lms3dVRMLTraversal.h"

#include "Grammar/lms3dVRMLContext.h"
#include "Grammar/lms3dVRMLNodeTypes.h"
#include "Meshes/lms3dVRMLColors.h"
#include "Meshes/lms3dVRMLGeometry.h"
#include "Model/lms3dUTF8.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace
{
std::size_t GetSize(const lms3dMesh& mesh)
{
  return mesh.Points.size() * sizeof(mesh.Points[0]) +
    mesh.Triangles.size() * sizeof(mesh.Triangles[0]) + mesh.Colors.size() * sizeof(mesh.Colors[0]);
}

// With the part of the output that vtkVRMLImporterSource makes of the shape: points, and for each
// triangle its corners, its offset, ShapeId and Color.
std::size_t GetSize(const lms3dShape& shape)
{
  constexpr std::size_t bytesPerTriangle = 4 * sizeof(std::int64_t) + sizeof(std::int32_t) + 4;
  return sizeof(shape) + 2 * shape.Name.size() + shape.Mesh->Points.size() * sizeof(lms3dPoint) +
    shape.Mesh->Triangles.size() * bytesPerTriangle;
}

// Discards the points of a mesh without triangles.
lms3dMesh MakeMesh(lms3dVRMLEvaluator& evaluator, const lms3dVRMLNodeInContext& geometry, int sides)
{
  lms3dMesh mesh = lms3dMakeMesh(evaluator, geometry, sides);
  return mesh.Triangles.empty() ? lms3dMesh() : std::move(mesh);
}
} // namespace

bool lms3dVRMLTraversal::HasSurface(const lms3dVRMLNodeInContext& geometry)
{
  const lms3dVRMLNodeType* type = geometry.Node ? geometry.Node->Type : nullptr;
  if (geometry.Node && (!type || !type->IsGeometry()))
  {
    this->Evaluator.ReportLoss(geometry,
      type ? std::string(type->Name) + " is not a geometry node, but is the geometry of a Shape"
           : lms3dExplainUnknownNode(geometry.Node->TypeName));
    return false;
  }
  return geometry.Node && type->Role != lms3dVRMLNodeType::OTHER_GEOMETRY;
}

void lms3dVRMLTraversal::VisitShape(
  const lms3dVRMLNodeInContext& shapeNode, const InheritedState& state)
{
  const lms3dVRMLNodeInContext geometry = this->Evaluator.GetNode(shapeNode, "geometry");
  if (!this->HasSurface(geometry))
  {
    return;
  }
  const Mesh& mesh = this->GetMesh(geometry, state);
  const std::size_t count = mesh.Triangles->Triangles.size();
  if (count == 0 ||
    !this->Context.CountTriangles(count, geometry.Node->Document->FileName, geometry.Node->Line))
  {
    return;
  }
  if (!state.ToWorld.IsFinite(mesh.LargestCoordinate))
  {
    this->Evaluator.ReportLoss(
      shapeNode, "a Shape is lost: its size or the transforms around it are not finite");
    return;
  }
  lms3dShape shape;
  shape.Name = lms3dToUTF8(state.Name);
  shape.ToWorld = state.ToWorld;
  shape.Mesh = mesh.Triangles;
  if (this->Evaluator.CountMemory(geometry, GetSize(shape)))
  {
    this->SetColor(shapeNode, shape);
    this->Shapes.push_back(std::move(shape));
  }
}

const lms3dVRMLTraversal::Mesh& lms3dVRMLTraversal::GetMesh(
  const lms3dVRMLNodeInContext& geometry, const InheritedState& state)
{
  const double scale = state.ToWorld.GetLargestScale();
  const int sides =
    lms3dCountSides(this->Evaluator, geometry, this->Context.Options.ChordError / scale);
  const lms3dVRMLInstance* const instance =
    this->Evaluator.MayDependOnInstance(geometry) ? geometry.Instance : nullptr;
  const auto [found, isNew] = this->Meshes.try_emplace({ geometry.Node, instance, sides });
  Mesh& mesh = found->second;
  if (isNew)
  {
    mesh.Triangles = std::make_shared<lms3dMesh>(MakeMesh(this->Evaluator, geometry, sides));
    this->Evaluator.CountMemory(geometry, GetSize(*mesh.Triangles));
    mesh.LargestCoordinate = lms3dGetLargestCoordinate(*mesh.Triangles);
  }
  return mesh;
}

// Without a Material a Shape is white and opaque.
void lms3dVRMLTraversal::SetColor(const lms3dVRMLNodeInContext& shape, lms3dShape& result)
{
  const lms3dVRMLNodeInContext appearance =
    this->Evaluator.GetNode(shape, "appearance", "Appearance");
  const lms3dVRMLNodeInContext material = appearance.Node
    ? this->Evaluator.GetNode(appearance, "material", "Material")
    : lms3dVRMLNodeInContext();
  if (material.Node)
  {
    result.Color =
      lms3dMakeColor(this->Evaluator.GetVector<3>(material, "diffuseColor", { 0.8, 0.8, 0.8 }));
    const double transparency = this->Evaluator.GetNumber(material, "transparency", 0.0);
    result.Opacity =
      static_cast<std::uint8_t>(std::lround(255.0 * (1.0 - std::clamp(transparency, 0.0, 1.0))));
  }
}
