// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Where the names of nodes and prototypes hold (ISO/IEC 14772-1, 4.4).
 */
#ifndef lms3dVRMLScope_h
#define lms3dVRMLScope_h

#include "lms3dVRMLNode.h"

#include <string_view>
#include <unordered_map>
#include <variant>

/// That of a file, or that of a prototype's body inside of another.
class lms3dVRMLScope
{
public:
  /// Of a file both are null.
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
  /// The last of this name; null where there is none. Nodes outside of a body are unknown in it,
  /// prototypes are known.
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

  /// Whether IS with this name means an event of the prototype, which has no value.
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
