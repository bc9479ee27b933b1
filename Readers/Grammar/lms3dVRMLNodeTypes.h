// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The nodes of VRML97, their fields, and whether they affect surfaces.
 */
#ifndef lms3dVRMLNodeTypes_h
#define lms3dVRMLNodeTypes_h

#include <string>
#include <string_view>
#include <vector>

struct lms3dVRMLNodeType
{
  enum Roles
  {
    GROUP, ///< has children, in its own coordinate system: also Anchor, Billboard, Collision
    TRANSFORM,
    SWITCH,
    LOD,
    INLINE,
    SHAPE,
    BOX,
    CONE,
    CYLINDER,
    ELEVATION_GRID,
    EXTRUSION,
    INDEXED_FACE_SET,
    SPHERE,
    OTHER_GEOMETRY, ///< lines, points and text: no surfaces
    COORDINATE, ///< the points of a surface, of lines or of points
    SCRIPT, ///< can declare fields in its body
    OTHER
  };

  Roles Role;
  std::string_view Name;
  /// The names of fields and events (ISO/IEC 14772-1, chapter 6).
  std::vector<std::string_view> Fields;

  bool IsGeometry() const { return this->Role >= BOX && this->Role <= OTHER_GEOMETRY; }
  /// Returns whether the node, or a node below it, can be a surface.
  bool MayHaveSurface() const { return this->Role < OTHER_GEOMETRY; }
  /// Returns whether surfaces can depend on the content of the node.
  bool AffectsSurface() const { return this->MayHaveSurface() || this->Role == COORDINATE; }
  /// Accepts set_x and x_changed as names of an exposed field x.
  bool HasField(std::string_view name) const;
};

/// Returns null if VRML97 has no such node. The result lives as long as the program.
const lms3dVRMLNodeType* lms3dFindVRMLNodeType(std::string_view name);

/// Returns the text of the message about such a node.
std::string lms3dExplainUnknownNode(std::string_view name);

/// Returns whether the field affects colours only, not the shape of a surface.
bool lms3dIsVRMLColorField(std::string_view name);

/// Returns whether any node of VRML97 has a field of this name.
bool lms3dIsVRMLField(std::string_view name);

#endif
