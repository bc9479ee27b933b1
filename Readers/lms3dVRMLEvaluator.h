// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Finds what the nodes of a scene are and hold, whatever prototypes stand in between.
 *
 * Prototypes are not copied: a node of a body is seen from an instance, where IS finds its values.
 */
#ifndef lms3dVRMLEvaluator_h
#define lms3dVRMLEvaluator_h

#include "lms3dVRMLNode.h"

#include <array>
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

class lms3dVRMLContext;
class lms3dVRMLLibrary;

struct lms3dVRMLInstance
{
  const lms3dVRMLNode* Node;
  const lms3dVRMLPrototype* Prototype;
  /// Where the node is seen from; null outside of all prototypes.
  const lms3dVRMLInstance* Outer;
  int Depth;
};

/// A node, or none, seen from an instance.
struct lms3dVRMLView
{
  const lms3dVRMLNode* Node = nullptr;
  const lms3dVRMLInstance* Instance = nullptr;

  bool operator==(const lms3dVRMLView& other) const
  {
    return this->Node == other.Node && this->Instance == other.Instance;
  }
};

struct lms3dVRMLViewHash
{
  std::size_t operator()(const lms3dVRMLView& view) const
  {
    return std::hash<const void*>()(view.Node) * 31 + std::hash<const void*>()(view.Instance);
  }
};

/// Instances are in lms3dVRMLEvaluator.cxx, the values of fields in lms3dVRMLFieldValues.cxx, the
/// nodes that fields hold in lms3dVRMLFieldNodes.cxx.
class lms3dVRMLEvaluator
{
public:
  lms3dVRMLEvaluator(lms3dVRMLContext& context, lms3dVRMLLibrary& library)
    : Context(context)
    , Library(library)
  {
  }

  /// From an instance to the first node of the body, until it is no instance any more. No node, and
  /// a message, where that cannot be found.
  lms3dVRMLView Enter(lms3dVRMLView view);

  /// Whether the values of a node, and of those that it holds, may be others when it is seen from
  /// another instance.
  static bool MayDependOnInstance(const lms3dVRMLView& view);

  ///@{
  /// A field of a node that is no instance. The fallback is returned where the file does not give the
  /// field; with a message, also where its value is not of that kind. Numbers may be infinite or NaN.
  double GetNumber(const lms3dVRMLView& view, std::string_view name, double fallback);
  bool GetBool(const lms3dVRMLView& view, std::string_view name, bool fallback);
  template <std::size_t N>
  std::array<double, N> GetVector(
    const lms3dVRMLView& view, std::string_view name, const std::array<double, N>& fallback)
  {
    std::array<double, N> vector = fallback;
    this->CopyNumbers(view, name, vector.data(), N);
    return vector;
  }
  ///@}

  ///@{
  /// A list, empty where it is not given; a message where it is not of whole tuples of so many
  /// numbers. An integer that is none becomes the least of all.
  std::shared_ptr<const lms3dVRMLReals> GetReals(const lms3dVRMLView& view, std::string_view name,
    std::size_t tuple = 1, const lms3dVRMLReals& fallback = {});
  std::shared_ptr<const lms3dVRMLIntegers> GetIntegers(
    const lms3dVRMLView& view, std::string_view name);
  /// A node that could not be read is none.
  std::vector<lms3dVRMLView> GetNodes(const lms3dVRMLView& view, std::string_view name);
  ///@}

  /// One of a list of nodes, from 0; none beyond its ends. Lists can be long, and be used often.
  lms3dVRMLView GetNodeAt(const lms3dVRMLView& view, std::string_view name, double place);

  /// A node that is no instance; none where it is not given or not to be found.
  lms3dVRMLView GetNode(const lms3dVRMLView& view, std::string_view name);

  /// One of this type; none, and a message, where another is given.
  lms3dVRMLView GetNode(
    const lms3dVRMLView& view, std::string_view name, std::string_view typeName);

  struct Urls
  {
    lms3dVRMLStrings Strings;
    /// The file that they are written in.
    const lms3dVRMLDocument* Document = nullptr;
  };
  Urls GetUrls(const lms3dVRMLView& view);

  /// Counts triangles that a geometry node may have; false where it is to be left out.
  bool CountWork(const lms3dVRMLView& geometry, std::size_t triangles);

  ///@{
  /// A message about a node.
  void Warn(const lms3dVRMLView& view, const std::string& text);
  void Lose(const lms3dVRMLView& view, const std::string& text);
  ///@}

private:
  struct FoundValue
  {
    /// Null where the file does not give it.
    const lms3dVRMLValue* Value = nullptr;
    const lms3dVRMLInstance* Instance = nullptr;
    const lms3dVRMLDocument* Document = nullptr;
    std::size_t Line = 0;
  };
  FoundValue Find(const lms3dVRMLView& view, std::string_view name);
  struct FoundNodes
  {
    /// Null where there are none.
    const lms3dVRMLNodes* Nodes;
    const lms3dVRMLInstance* Instance;
  };
  FoundNodes FindNodes(const lms3dVRMLView& view, std::string_view name);
  void CopyNumbers(
    const lms3dVRMLView& view, std::string_view name, double* numbers, std::size_t count);
  void RejectKind(
    const lms3dVRMLView& view, std::string_view name, const FoundValue& found, const char* kind);
  /// An error, but a warning where colours alone are lost with the field.
  void Reject(
    std::string_view name, const std::string& file, std::size_t line, const std::string& text);

  lms3dVRMLView EnterInstance(const lms3dVRMLView& view);
  bool IsInside(const lms3dVRMLView& view) const;

  lms3dVRMLContext& Context;
  lms3dVRMLLibrary& Library;
  std::deque<lms3dVRMLInstance> Instances;
  std::unordered_map<lms3dVRMLView, const lms3dVRMLInstance*, lms3dVRMLViewHash> Known;
  ///@{
  /// Lists of the other kind of number, which many nodes may share.
  std::unordered_map<const lms3dVRMLValue*, std::shared_ptr<const lms3dVRMLReals>> AsReals;
  std::unordered_map<const lms3dVRMLValue*, std::shared_ptr<const lms3dVRMLIntegers>> AsIntegers;
  ///@}
};

#endif
