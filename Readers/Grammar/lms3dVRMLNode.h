// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The syntax tree of a VRML97 file: nodes and prototypes as written, not evaluated.
 *
 * The kind of a value follows from its tokens, not from its field, so that unknown nodes and fields
 * can be parsed too. USE refers to the same node object again, so the tree is a directed graph. The
 * document owns all nodes, prototypes and names; pointers and views are valid as long as it exists.
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

/// "IS name": the value comes from this field of the instance of the enclosing prototype.
struct lms3dVRMLReference
{
  std::string_view Name;
};

using lms3dVRMLIntegers = std::vector<std::int32_t>;
using lms3dVRMLReals = std::vector<double>;
using lms3dVRMLStrings = std::vector<std::string>;
using lms3dVRMLNodes = std::vector<const lms3dVRMLNode*>;

/// Numbers are lms3dVRMLIntegers if all of them are integers. "[]" and NULL are empty lists of
/// nodes. A node that cannot be parsed is a null pointer in its list. Events have std::monostate.
using lms3dVRMLValue = std::variant<std::monostate, bool, lms3dVRMLIntegers, lms3dVRMLReals,
  lms3dVRMLStrings, lms3dVRMLNodes, lms3dVRMLReference>;

struct lms3dVRMLField
{
  std::string_view Name;
  std::size_t Line;
  lms3dVRMLValue Value;
};

/// Returns null if no field has this name.
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
  /// Null for an instance of a prototype and for a node that VRML97 does not define.
  const lms3dVRMLNodeType* Type = nullptr;
  /// Null if the node is not an instance.
  const lms3dVRMLPrototype* Prototype = nullptr;
  /// The name after DEF, or empty.
  std::string_view Name;
  std::vector<lms3dVRMLField> Fields;
};

/// A PROTO (with a body) or an EXTERNPROTO (with Urls).
struct lms3dVRMLPrototype
{
  const lms3dVRMLDocument* Document;
  std::size_t Line;
  std::string_view Name;
  /// Fields, exposed fields and events with their default values.
  std::vector<lms3dVRMLField> Interface;
  /// The first node of the body, which alone is shown; null if the body has no node.
  const lms3dVRMLNode* Body = nullptr;
  bool IsExternal = false;
  lms3dVRMLStrings Urls;
};

struct lms3dVRMLDocument
{
  /// The name that messages use.
  std::string FileName;
  /// The folder that relative URLs refer to.
  std::string Folder;
  lms3dVRMLNodes Roots;
  /// The prototypes outside all nodes and other prototypes. If several have the same name, the last
  /// one.
  std::unordered_map<std::string_view, const lms3dVRMLPrototype*> PrototypesByName;
  /// The first PROTO among them (ISO/IEC 14772-1, 4.9.3); null if there is none.
  const lms3dVRMLPrototype* FirstPrototype = nullptr;

  std::deque<lms3dVRMLNode> Nodes;
  std::deque<lms3dVRMLPrototype> Prototypes;
  /// Storage of all names: the std::string_view members refer to it.
  std::unordered_set<std::string> Names;
};

#endif
