// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/lms3dTriangulator.h"
#include "Geometry/lms3dVector.h"
#include "Meshes/lms3dUsedPoints.h"
#include "Meshes/lms3dVRMLColors.h"
#include "Meshes/lms3dVRMLGeometry.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace
{
using Integers = std::shared_ptr<const lms3dVRMLIntegers>;

std::string CountFaces(std::size_t count, const char* verbOfOne, const char* verbOfMore)
{
  return std::to_string(count) + (count == 1 ? " face" : " faces") + " of an IndexedFaceSet" +
    (count == 1 ? verbOfOne : verbOfMore);
}

class FaceSet
{
public:
  FaceSet(lms3dVRMLEvaluator& evaluator, const lms3dVRMLNodeInContext& node)
    : Evaluator(evaluator)
    , Node(node)
    , Indices(evaluator.GetIntegers(node, "coordIndex"))
    , ColorIndices(evaluator.GetIntegers(node, "colorIndex"))
    , Colors(evaluator, node)
  {
    const lms3dVRMLNodeInContext coord = evaluator.GetNode(node, "coord", "Coordinate");
    this->Coordinates =
      coord.Node ? evaluator.GetReals(coord, "point", 3) : std::make_shared<lms3dVRMLReals>();
    this->PointCount = this->Coordinates->size() / 3;
    this->HasCoord = coord.Node != nullptr;
  }

  lms3dMesh MakeMesh()
  {
    if (!this->HasCoord && !this->Indices->empty())
    {
      this->Evaluator.ReportLoss(this->Node, "an IndexedFaceSet has faces but no coord");
      return {};
    }
    if (!this->Evaluator.CountWork(this->Node, this->Indices->size() / 4))
    {
      return {};
    }
    this->AddFaces();
    lms3dCopyUsedPoints(*this->Coordinates, this->Mesh);
    if (!this->Evaluator.GetBool(this->Node, "ccw", true))
    {
      lms3dFlip(this->Mesh);
    }
    this->ReportLosses();
    return std::move(this->Mesh);
  }

private:
  lms3dVector GetPoint(std::int32_t index) const
  {
    const double* point = this->Coordinates->data() + 3 * static_cast<std::size_t>(index);
    return { point[0], point[1], point[2] };
  }

  // Each face ends with -1, which can be missing after the last one.
  void AddFaces()
  {
    this->Mesh.Triangles.reserve(this->Indices->size() / 4);
    const std::size_t count = this->Indices->size();
    std::int64_t face = 0;
    for (std::size_t begin = 0; begin < count;)
    {
      std::size_t end = begin;
      while (end < count && (*this->Indices)[end] != -1)
      {
        ++end;
      }
      if (end > begin)
      {
        this->AddFace(begin, end, face++);
      }
      begin = end + 1;
    }
  }

  // Faces of fewer than three corners have no surface.
  void AddFace(std::size_t begin, std::size_t end, std::int64_t face)
  {
    if (end - begin < 3)
    {
      return;
    }
    if (!this->AreIndices(begin, end))
    {
      ++this->OutOfRange;
    }
    else if (!this->AreFinite(begin, end))
    {
      ++this->NotFinite;
    }
    else if (end - begin == 3)
    {
      this->AddTriangle(begin, { 0, 1, 2 }, face);
    }
    else
    {
      this->AddPolygon(begin, end, face);
    }
  }

  bool AreIndices(std::size_t begin, std::size_t end) const
  {
    for (std::size_t i = begin; i < end; ++i)
    {
      const std::int32_t index = (*this->Indices)[i];
      if (index < 0 || static_cast<std::size_t>(index) >= this->PointCount)
      {
        return false;
      }
    }
    return true;
  }

  // The bound keeps areas finite, too.
  bool AreFinite(std::size_t begin, std::size_t end) const
  {
    constexpr double maximum = 1e150;
    for (std::size_t i = begin; i < end; ++i)
    {
      const lms3dVector point = this->GetPoint((*this->Indices)[i]);
      if (!std::all_of(point.begin(), point.end(), [](double x) { return std::abs(x) <= maximum; }))
      {
        return false;
      }
    }
    return true;
  }

  void AddPolygon(std::size_t begin, std::size_t end, std::int64_t face)
  {
    this->Corners.clear();
    for (std::size_t i = begin; i < end; ++i)
    {
      this->Corners.push_back(this->GetPoint((*this->Indices)[i]));
    }
    this->Crossed += this->Triangulator.Cut(this->Corners) ? 0 : 1;
    for (const lms3dTriangulator::Triangle& triangle : this->Triangulator.GetTriangles())
    {
      this->AddTriangle(begin, triangle, face);
    }
  }

  /// `corners` counts from the beginning of the face.
  void AddTriangle(std::size_t begin, const lms3dTriangulator::Triangle& corners, std::int64_t face)
  {
    const auto index = [this, begin, &corners](int i)
    { return (*this->Indices)[begin + static_cast<std::size_t>(corners[i])]; };
    if (index(0) == index(1) || index(1) == index(2) || index(2) == index(0))
    {
      return;
    }
    this->Mesh.Triangles.push_back({ index(0), index(1), index(2) });
    if (this->Colors.AreGiven())
    {
      this->Mesh.Colors.push_back(this->GetColor(begin, corners, face));
    }
  }

  // Without colorIndex, coordIndex selects the colour of a corner, and the number of a face its
  // colour.
  lms3dColor GetColor(
    std::size_t begin, const lms3dTriangulator::Triangle& corners, std::int64_t face)
  {
    const lms3dVRMLIntegers& indices = *this->ColorIndices;
    const auto at = [](const lms3dVRMLIntegers& list, std::size_t i) -> std::int64_t
    { return i < list.size() ? list[i] : -1; };
    if (!this->Colors.ArePerVertex())
    {
      return this->Colors.Get(indices.empty() ? face : at(indices, static_cast<std::size_t>(face)));
    }
    std::array<std::int64_t, 3> colors;
    for (int i = 0; i < 3; ++i)
    {
      const std::size_t position = begin + static_cast<std::size_t>(corners[i]);
      colors[i] = at(indices.empty() ? *this->Indices : indices, position);
    }
    return this->Colors.GetMean(colors);
  }

  void ReportLosses()
  {
    if (this->OutOfRange > 0)
    {
      this->Evaluator.ReportLoss(this->Node,
        CountFaces(this->OutOfRange, " is lost", " are lost") +
          ": coordIndex is out of range, the Coordinate has " + std::to_string(this->PointCount) +
          " points");
    }
    if (this->NotFinite > 0)
    {
      this->Evaluator.ReportLoss(this->Node,
        CountFaces(this->NotFinite, " is lost", " are lost") +
          ": a point is not finite or too far away");
    }
    if (this->Crossed > 0)
    {
      this->Evaluator.Warn(this->Node,
        CountFaces(this->Crossed, " has too many corners for its shape, or crosses itself",
          " have too many corners for their shape, or cross themselves") +
          "; the triangles may overlap or extend beyond it: split such faces");
    }
  }

  lms3dVRMLEvaluator& Evaluator;
  lms3dVRMLNodeInContext Node;
  Integers Indices;
  Integers ColorIndices;
  lms3dVRMLColors Colors;
  std::shared_ptr<const lms3dVRMLReals> Coordinates;
  std::size_t PointCount;
  bool HasCoord;

  lms3dMesh Mesh;
  lms3dTriangulator Triangulator;
  std::vector<lms3dVector> Corners;
  std::size_t OutOfRange = 0;
  std::size_t NotFinite = 0;
  std::size_t Crossed = 0;
};
} // namespace

lms3dMesh lms3dMakeFaceSet(lms3dVRMLEvaluator& evaluator, const lms3dVRMLNodeInContext& faceSet)
{
  return FaceSet(evaluator, faceSet).MakeMesh();
}
