// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What an engine reads from a file: shapes, and words on what it could not read.
 */
#ifndef lms3dScene_h
#define lms3dScene_h

#include "lms3dTransform.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

using lms3dPoint = std::array<double, 3>;
using lms3dColor = std::array<std::uint8_t, 3>;

struct lms3dMesh
{
  std::vector<lms3dPoint> Points;
  /// Indices into Points, counter-clockwise where the file says what is front.
  std::vector<std::array<std::int32_t, 3>> Triangles;
  /// One for each triangle, or none at all where the shape's own colour holds.
  std::vector<lms3dColor> Colors;
};

/// A mesh in its place. Shapes may share a mesh.
struct lms3dShape
{
  /// The name that the file gives it, or empty.
  std::string Name;
  lms3dColor Color = { 255, 255, 255 };
  std::uint8_t Opacity = 255;
  /// From the mesh to world coordinates, metres.
  lms3dTransform ToWorld;
  std::shared_ptr<const lms3dMesh> Mesh;
};

struct lms3dMessage
{
  enum Severities
  {
    WARNING = 0,
    ERROR = 1 ///< geometry is lost
  };

  int Severity = ERROR;
  /// Empty where it is not known.
  std::string File;
  /// From 1; 0 where it is not known.
  std::size_t Line = 0;
  std::string Text;
};

struct lms3dScene
{
  std::vector<lms3dShape> Shapes;
  std::vector<lms3dMessage> Messages;
};

#endif
