// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A VRML97 file in memory: nodes and prototypes as they are written, nothing evaluated.
 *
 * Values have no types of their own, so that unknown nodes and fields can be read too. What USE
 * names is the same node again. A document owns its nodes; they are as old as it is.
 */
#ifndef lms3dVRMLNode_h
#define lms3dVRMLNode_h

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <variant>
#include <vector>

struct lms3dVRMLDocument;
struct lms3dVRMLNode;
struct lms3dVRMLNodeType;
struct lms3dVRMLPrototype;

/// "IS name": the value is that of the instance's field.
struct lms3dVRMLReference
{
  std::string_view Name;
};

using lms3dVRMLIntegers = std::vector<std::int32_t>;
using lms3dVRMLReals = std::vector<double>;
using lms3dVRMLStrings = std::vector<std::string>;
using lms3dVRMLNodes = std::vector<const lms3dVRMLNode*>;

/// Numbers are integers as long as all of them are. "[]" and NULL are no nodes, a node in a list that
/// cannot be read is null; events have no value at all.
using lms3dVRMLValue = std::variant<std::monostate, bool, lms3dVRMLIntegers, lms3dVRMLReals,
  lms3dVRMLStrings, lms3dVRMLNodes, lms3dVRMLReference>;

struct lms3dVRMLField
{
  std::string_view Name;
  std::size_t Line;
  lms3dVRMLValue Value;
};

/// Null where there is none of this name.
inline const lms3dVRMLField* lms3dFindField(
  const std::vector<lms3dVRMLField>& fields, std::string_view name)
{
  const auto found = std::find_if(fields.begin(), fields.end(),
    [name](const lms3dVRMLField& field) { return field.Name == name; });
  return found == fields.end() ? nullptr : &*found;
}

struct lms3dVRMLNode
{
  const lms3dVRMLDocument* Document;
  std::size_t Line;
  std::string_view TypeName;
  /// Null for an instance of a prototype, and for a node that VRML97 does not have.
  const lms3dVRMLNodeType* Type = nullptr;
  const lms3dVRMLPrototype* Prototype = nullptr;
  /// What DEF calls it, or empty.
  std::string_view Name;
  std::vector<lms3dVRMLField> Fields;
};

/// A PROTO, or an EXTERNPROTO, which has Urls in place of a body.
struct lms3dVRMLPrototype
{
  const lms3dVRMLDocument* Document;
  std::size_t Line;
  std::string_view Name;
  /// Fields, exposed fields and events; the values are the defaults.
  std::vector<lms3dVRMLField> Interface;
  /// The first node of the body, the one that is shown; null where there is none.
  const lms3dVRMLNode* Body = nullptr;
  bool IsExternal = false;
  lms3dVRMLStrings Urls;
};

struct lms3dVRMLDocument
{
  /// As in messages.
  std::string FileName;
  /// Where relative urls begin.
  std::string Folder;
  lms3dVRMLNodes Roots;
  /// Those outside of all nodes and of all other prototypes. The last of a name counts.
  std::unordered_map<std::string_view, const lms3dVRMLPrototype*> PrototypesByName;
  /// The first of them that is no EXTERNPROTO (ISO/IEC 14772-1, 4.9.3).
  const lms3dVRMLPrototype* FirstPrototype = nullptr;

  std::deque<lms3dVRMLNode> Nodes;
  std::deque<lms3dVRMLPrototype> Prototypes;
  /// What all the names here are views of.
  std::unordered_set<std::string> Names;
};

#endif
