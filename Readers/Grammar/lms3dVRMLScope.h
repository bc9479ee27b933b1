// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The scope of the names of nodes and prototypes (ISO/IEC 14772-1, 4.4).
 */
#ifndef lms3dVRMLScope_h
#define lms3dVRMLScope_h

#include "Grammar/lms3dVRMLNode.h"

#include <string_view>
#include <unordered_map>
#include <variant>

/// The scope of a file, or of the body of a prototype. Does not own nodes, prototypes or names.
class lms3dVRMLScope
{
public:
  /// Both arguments are null for the scope of a file.
  lms3dVRMLScope(const lms3dVRMLScope* outer, const lms3dVRMLPrototype* prototype)
    : Outer(outer)
    , Prototype(prototype)
  {
  }

  void Define(std::string_view name, const lms3dVRMLNode* node) { this->Nodes[name] = node; }
  void Define(std::string_view name, const lms3dVRMLPrototype* prototype)
  {
    this->Prototypes[name] = prototype;
  }

  ///@{
  /// Return the last definition of the name, or null. Prototypes of outer scopes are visible, nodes
  /// are not.
  const lms3dVRMLNode* FindNode(std::string_view name) const
  {
    const auto found = this->Nodes.find(name);
    return found != this->Nodes.end() ? found->second : nullptr;
  }

  const lms3dVRMLPrototype* FindPrototype(std::string_view name) const
  {
    for (const lms3dVRMLScope* scope = this; scope; scope = scope->Outer)
    {
      const auto found = scope->Prototypes.find(name);
      if (found != scope->Prototypes.end())
      {
        return found->second;
      }
    }
    return nullptr;
  }
  ///@}

  /// Returns whether "IS name" refers to an event of the prototype, which has no value.
  bool IsEvent(std::string_view name) const
  {
    const lms3dVRMLField* field =
      this->Prototype ? lms3dFindField(this->Prototype->Interface, name) : nullptr;
    return field && std::holds_alternative<std::monostate>(field->Value);
  }

private:
  const lms3dVRMLScope* Outer;
  const lms3dVRMLPrototype* Prototype;
  std::unordered_map<std::string_view, const lms3dVRMLNode*> Nodes;
  std::unordered_map<std::string_view, const lms3dVRMLPrototype*> Prototypes;
};

#endif
