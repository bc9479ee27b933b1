// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The result of reading a file: shapes, and messages about faults.
 */
#ifndef lms3dScene_h
#define lms3dScene_h

#include "Model/lms3dTransform.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

using lms3dPoint = std::array<double, 3>;
/// Red, green, blue.
using lms3dColor = std::array<std::uint8_t, 3>;

/// Triangles in the local coordinates of a geometry node.
struct lms3dMesh
{
  /// Metres. All coordinates are finite.
  std::vector<lms3dPoint> Points;
  /// Indices into Points, counter-clockwise seen from the front.
  std::vector<std::array<std::int32_t, 3>> Triangles;
  /// One colour for each triangle. Empty if the colour of the shape holds for all triangles.
  std::vector<lms3dColor> Colors;
};

/// A mesh placed in the world. Several shapes can share a mesh.
struct lms3dShape
{
  /// UTF-8; empty if the file gives no name.
  std::string Name;
  lms3dColor Color = { 255, 255, 255 };
  std::uint8_t Opacity = 255;
  /// Maps the local coordinates of the mesh to world coordinates, metres.
  lms3dTransform ToWorld;
  /// Never null.
  std::shared_ptr<const lms3dMesh> Mesh;
};

struct lms3dMessage
{
  /// The values equal vtkVRMLImporterSource::MessageSeverities. (ERROR alone is a macro on
  /// Windows.)
  enum Severities
  {
    MESSAGE_WARNING = 0,
    MESSAGE_ERROR = 1 ///< geometry is lost or misplaced
  };

  int Severity = MESSAGE_ERROR;
  /// Empty if the message is not about a file.
  std::string File;
  /// Counted from 1; 0 if the line is not known.
  std::size_t Line = 0;
  /// UTF-8, one line.
  std::string Text;
};

struct lms3dScene
{
  std::vector<lms3dShape> Shapes;
  std::vector<lms3dMessage> Messages;
};

#endif
