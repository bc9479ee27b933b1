// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The nodes that VRML97 has, their fields, and what they mean for surfaces.
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
    GROUP, ///< shows its children, in its own coordinate system: also Anchor, Billboard, Collision
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
    COORDINATE, ///< the points of surfaces and others
    SCRIPT, ///< may declare fields of its own
    OTHER
  };

  Roles Role;
  std::string_view Name;
  /// The names of its fields and events (ISO/IEC 14772-1, chapter 6).
  std::vector<std::string_view> Fields;

  bool IsGeometry() const { return this->Role >= BOX && this->Role <= OTHER_GEOMETRY; }
  /// Whether surfaces may come of it, or of what it holds.
  bool MayShow() const { return this->Role < OTHER_GEOMETRY; }
  /// Whether surfaces may depend on what it holds.
  bool HoldsSurface() const { return this->MayShow() || this->Role == COORDINATE; }
  /// An exposed field x is also known as set_x and x_changed.
  bool HasField(std::string_view name) const;
};

/// Null where VRML97 has no such node.
const lms3dVRMLNodeType* lms3dFindVRMLNodeType(std::string_view name);

/// The message about it: a warning, or an error where it should have shown something.
std::string lms3dExplainUnknownNode(std::string_view name);

/// Whether a field has to do with colours alone: surfaces do not depend on it.
bool lms3dIsVRMLColorField(std::string_view name);

/// Whether any node of VRML97 has such a field.
bool lms3dIsVRMLField(std::string_view name);

#endif
