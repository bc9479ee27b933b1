// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Makes scenes of triangles alone.
 */
#ifndef SceneBuilder_h
#define SceneBuilder_h

#include "Fixtures/CasterFixtures.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>

/// Collects triangles.
class SceneBuilder
{
public:
  SceneBuilder();

  void AddTriangle(const Vector& a, const Vector& b, const Vector& c);
  /// Corners in their order around.
  void AddQuad(const Vector& a, const Vector& b, const Vector& c, const Vector& d);
  /// Its axes are half as long as the box.
  void AddTurnedBox(const Vector& center, const std::array<Vector, 3>& axes);
  void AddBox(const Vector& low, const Vector& high);
  /// An upright cone, or with a radius at its top a cylinder, with `sides` sides.
  void AddCone(const Vector& foot, double radius, double topRadius, double height, int sides);
  void AddBall(const Vector& center, double radius, int resolution);
  void AddSurface(vtkPolyData* triangles, const Vector& offset);

  vtkSmartPointer<vtkPolyData> GetSurface() const { return this->Surface; }

private:
  vtkIdType AddPoint(const Vector& point);

  vtkSmartPointer<vtkPolyData> Surface;
};

#endif
