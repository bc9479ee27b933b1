// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/lms3dTriangulator.h"
#include "Geometry/lms3dVector.h"
#include "Meshes/lms3dVRMLGeometry.h"
#include "Meshes/lms3dVRMLSpine.h"
#include "Model/lms3dTransform.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace
{
class Extrusion
{
public:
  Extrusion(lms3dVRMLEvaluator& evaluator, const lms3dVRMLNodeInContext& node)
    : Evaluator(evaluator)
    , Node(node)
    , CrossSection(
        evaluator.GetReals(node, "crossSection", 2, { 1, 1, 1, -1, -1, -1, -1, 1, 1, 1 }))
    , Spine(evaluator.GetReals(node, "spine", 3, { 0, 0, 0, 0, 1, 0 }))
    , Scale(evaluator.GetReals(node, "scale", 2, { 1, 1 }))
    , Orientation(evaluator.GetReals(node, "orientation", 4, { 0, 0, 1, 0 }))
    , Corners(this->CrossSection->size() / 2)
    , Sections(this->Spine->size() / 3)
  {
  }

  lms3dMesh MakeMesh()
  {
    lms3dMesh mesh;
    if (!this->Check())
    {
      return mesh;
    }
    this->AddPoints(mesh);
    this->AddSides(mesh);
    this->AddCap("beginCap", 0, mesh);
    this->AddCap("endCap", this->Sections - 1, mesh);
    if (!this->Evaluator.GetBool(this->Node, "ccw", true))
    {
      lms3dFlip(mesh);
    }
    return mesh;
  }

private:
  bool Check()
  {
    if (this->Corners < 2 || this->Sections < 2)
    {
      this->Evaluator.ReportLoss(
        this->Node, "an Extrusion needs two points or more of spine and of crossSection");
      return false;
    }
    // The number of triangles can be far larger than the file, and the lists longer than the spine.
    const std::size_t quadrilaterals = (this->Corners - 1) * (this->Sections - 1);
    const std::size_t values = (this->Scale->size() + this->Orientation->size()) / 6;
    if (!this->Evaluator.CountWork(this->Node, std::max(2 * quadrilaterals, values)))
    {
      return false;
    }
    for (const auto& list : { this->CrossSection, this->Spine, this->Scale, this->Orientation })
    {
      if (!std::all_of(list->begin(), list->end(), [](double x) { return std::isfinite(x); }))
      {
        this->Evaluator.ReportLoss(this->Node, "an Extrusion has numbers that are not finite");
        return false;
      }
    }
    this->CheckCount("scale", this->Scale->size() / 2);
    this->CheckCount("orientation", this->Orientation->size() / 4);
    return true;
  }

  // A single value holds for the whole spine.
  void CheckCount(const char* name, std::size_t count)
  {
    if (count != 1 && count < this->Sections)
    {
      this->Evaluator.ReportLoss(this->Node,
        std::string(name) + " of Extrusion has fewer values than the spine has points; the last " +
          "one is used for the rest");
    }
  }

  lms3dVector GetSpinePoint(std::size_t section) const
  {
    const double* point = this->Spine->data() + 3 * section;
    return { point[0], point[1], point[2] };
  }

  std::array<double, 2> GetScale(std::size_t section) const
  {
    const std::size_t count = this->Scale->size() / 2;
    if (count == 0)
    {
      return { 1, 1 };
    }
    const double* scale = this->Scale->data() + 2 * std::min(section, count - 1);
    return { scale[0], scale[1] };
  }

  lms3dTransform GetOrientation(std::size_t section) const
  {
    const std::size_t count = this->Orientation->size() / 4;
    if (count == 0)
    {
      return {};
    }
    const double* turn = this->Orientation->data() + 4 * std::min(section, count - 1);
    return lms3dTransform::Rotation({ turn[0], turn[1], turn[2], turn[3] });
  }

  // The cross-section is scaled, then rotated, then placed in the plane across the spine.
  void AddPoints(lms3dMesh& mesh) const
  {
    std::vector<lms3dVector> spine;
    spine.reserve(this->Sections);
    for (std::size_t section = 0; section < this->Sections; ++section)
    {
      spine.push_back(this->GetSpinePoint(section));
    }
    const std::vector<lms3dSpineFrame> frames = lms3dMakeSpineFrames(spine);
    for (std::size_t section = 0; section < this->Sections; ++section)
    {
      const lms3dSpineFrame& frame = frames[section];
      const std::array<double, 2> scale = this->GetScale(section);
      const lms3dTransform toPlace = lms3dTransform::Translation(spine[section]) *
        lms3dTransform::Frame(frame.X, frame.Y, frame.Z) * this->GetOrientation(section) *
        lms3dTransform::Scale({ scale[0], 1, scale[1] });
      for (std::size_t corner = 0; corner < this->Corners; ++corner)
      {
        const double* point = this->CrossSection->data() + 2 * corner;
        mesh.Points.push_back(toPlace.Apply({ point[0], 0, point[1] }));
      }
    }
  }

  void AddSides(lms3dMesh& mesh) const
  {
    const std::int32_t corners = static_cast<std::int32_t>(this->Corners);
    const std::int32_t sections = static_cast<std::int32_t>(this->Sections);
    for (std::int32_t section = 0; section + 1 < sections; ++section)
    {
      for (std::int32_t corner = 0; corner + 1 < corners; ++corner)
      {
        const std::int32_t i = section * corners + corner;
        lms3dAddQuadrilateral({ i, i + 1, i + corners + 1, i + corners }, mesh);
      }
    }
  }

  // An open cross-section gets caps, too. The triangles of the triangulator face along the spine.
  void AddCap(const char* name, std::size_t section, lms3dMesh& mesh)
  {
    if (!this->Evaluator.GetBool(this->Node, name, true))
    {
      return;
    }
    const auto first = mesh.Points.begin() + static_cast<std::ptrdiff_t>(section * this->Corners);
    std::vector<lms3dVector> corners(first, first + static_cast<std::ptrdiff_t>(this->Corners));
    if (corners.front() == corners.back())
    {
      corners.pop_back();
    }
    if (!this->Triangulator.Cut(corners))
    {
      this->Evaluator.Warn(this->Node,
        "the crossSection of an Extrusion has too many corners for its shape, or crosses itself, "
        "in a "
        "cap; the triangles may overlap or extend beyond the cap");
    }
    const std::int32_t offset = static_cast<std::int32_t>(section * this->Corners);
    for (lms3dTriangulator::Triangle triangle : this->Triangulator.GetTriangles())
    {
      if (section == 0)
      {
        std::swap(triangle[1], triangle[2]);
      }
      mesh.Triangles.push_back(
        { offset + triangle[0], offset + triangle[1], offset + triangle[2] });
    }
  }

  lms3dVRMLEvaluator& Evaluator;
  lms3dVRMLNodeInContext Node;
  std::shared_ptr<const lms3dVRMLReals> CrossSection;
  std::shared_ptr<const lms3dVRMLReals> Spine;
  std::shared_ptr<const lms3dVRMLReals> Scale;
  std::shared_ptr<const lms3dVRMLReals> Orientation;
  std::size_t Corners;
  std::size_t Sections;
  lms3dTriangulator Triangulator;
};
} // namespace

lms3dMesh lms3dMakeExtrusion(lms3dVRMLEvaluator& evaluator, const lms3dVRMLNodeInContext& extrusion)
{
  return Extrusion(evaluator, extrusion).MakeMesh();
}
