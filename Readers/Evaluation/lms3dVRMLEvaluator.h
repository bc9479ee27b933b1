// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Evaluates nodes and fields: resolves prototypes, their instances and IS.
 *
 * The body of a prototype is not copied for each instance. Instead each node is evaluated in the
 * context of an instance, from which IS takes its values.
 */
#ifndef lms3dVRMLEvaluator_h
#define lms3dVRMLEvaluator_h

#include "Grammar/lms3dVRMLNode.h"

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
class lms3dVRMLDocumentCache;

/// An instance of a prototype, within another instance or outside all prototypes.
struct lms3dVRMLInstance
{
  /// The node that creates the instance and holds its field values.
  const lms3dVRMLNode* Node;
  /// The PROTO with the body; never an EXTERNPROTO.
  const lms3dVRMLPrototype* Prototype;
  /// The instance whose body contains Node; null outside all prototypes.
  const lms3dVRMLInstance* Outer;
  /// The number of instances around this one, itself included.
  int Depth;
};

/// A node in the context of an instance, which is null outside all prototypes. Node is null if
/// there is no node. Owns neither.
struct lms3dVRMLNodeInContext
{
  const lms3dVRMLNode* Node = nullptr;
  const lms3dVRMLInstance* Instance = nullptr;

  bool operator==(const lms3dVRMLNodeInContext& other) const
  {
    return this->Node == other.Node && this->Instance == other.Instance;
  }
};

struct lms3dVRMLNodeInContextHash
{
  std::size_t operator()(const lms3dVRMLNodeInContext& node) const
  {
    return std::hash<const void*>()(node.Node) * 31 + std::hash<const void*>()(node.Instance);
  }
};

/**
 * Owns the instances; pointers to them are valid as long as it exists. The context and the cache
 * must outlive it.
 *
 * The implementation is in three files: instances are in lms3dVRMLEvaluator.cxx, values of fields
 * in lms3dVRMLFieldValues.cxx, and nodes in fields in lms3dVRMLFieldNodes.cxx.
 */
class lms3dVRMLEvaluator
{
public:
  lms3dVRMLEvaluator(lms3dVRMLContext& context, lms3dVRMLDocumentCache& documents)
    : Context(context)
    , Documents(documents)
  {
  }

  /// Replaces an instance by the first node of its body, repeatedly until the node is not an
  /// instance. Returns no node, and adds a message, if that is not possible.
  lms3dVRMLNodeInContext Expand(lms3dVRMLNodeInContext node);

  /// Returns whether the values of the node, or of its child nodes, can differ between instances.
  static bool MayDependOnInstance(const lms3dVRMLNodeInContext& node);

  ///@{
  /// Return the value of a field. The node must not be an instance. If the file does not give the
  /// field, return the fallback. If its value is not of this kind, add a message and return the
  /// fallback. Numbers can be infinite or NaN.
  double GetNumber(const lms3dVRMLNodeInContext& node, std::string_view name, double fallback);
  bool GetBool(const lms3dVRMLNodeInContext& node, std::string_view name, bool fallback);
  template <std::size_t N>
  std::array<double, N> GetVector(const lms3dVRMLNodeInContext& node, std::string_view name,
    const std::array<double, N>& fallback)
  {
    std::array<double, N> vector = fallback;
    this->CopyNumbers(node, name, vector.data(), N);
    return vector;
  }
  ///@}

  ///@{
  /// Return a list, never null. If the file does not give the field, return the fallback, which for
  /// integers is an empty list. If the value is not of this kind, add a message and return an empty
  /// list. GetReals adds a message if the length is not a multiple of `tuple`. GetIntegers replaces
  /// each number that is not an integer by the minimum of std::int32_t.
  std::shared_ptr<const lms3dVRMLReals> GetReals(const lms3dVRMLNodeInContext& node,
    std::string_view name, std::size_t tuple = 1, const lms3dVRMLReals& fallback = {});
  std::shared_ptr<const lms3dVRMLIntegers> GetIntegers(
    const lms3dVRMLNodeInContext& node, std::string_view name);
  /// Returns the nodes without expanding instances. Node is null for a node that was not parsed.
  std::vector<lms3dVRMLNodeInContext> GetNodes(
    const lms3dVRMLNodeInContext& node, std::string_view name);
  ///@}

  /// Returns one node of a list, counted from 0, or no node if the index is out of range. Faster
  /// than GetNodes for long lists.
  lms3dVRMLNodeInContext GetNodeAt(
    const lms3dVRMLNodeInContext& node, std::string_view name, double index);

  /// Returns the first node of a field that was parsed, expanded. Returns no node if there is none.
  lms3dVRMLNodeInContext GetNode(const lms3dVRMLNodeInContext& node, std::string_view name);

  /// Returns such a node of this type. If it has another type, adds a message and returns no node.
  lms3dVRMLNodeInContext GetNode(
    const lms3dVRMLNodeInContext& node, std::string_view name, std::string_view typeName);

  struct Urls
  {
    lms3dVRMLStrings Strings;
    /// The file that contains the URLs, which relative ones refer to.
    const lms3dVRMLDocument* Document = nullptr;
  };
  /// Returns the value of the field "url".
  Urls GetUrls(const lms3dVRMLNodeInContext& node);

  /// Counts triangles that a geometry node could have. Returns false if the node must be skipped.
  /// See lms3dVRMLContext::CountWork.
  bool CountWork(const lms3dVRMLNodeInContext& geometry, std::size_t triangles);

  /// Counts bytes that are made for a node. Returns false if the limit is exceeded.
  bool CountMemory(const lms3dVRMLNodeInContext& node, std::size_t bytes);

  ///@{
  /// Add a message about a node: a warning, or an error because geometry is lost.
  void Warn(const lms3dVRMLNodeInContext& node, const std::string& text);
  void ReportLoss(const lms3dVRMLNodeInContext& node, const std::string& text);
  ///@}

private:
  struct FoundValue
  {
    /// Null if the file does not give the field.
    const lms3dVRMLValue* Value = nullptr;
    /// The context in which nodes of the value must be evaluated.
    const lms3dVRMLInstance* Instance = nullptr;
    /// The file and line that give the value.
    const lms3dVRMLDocument* Document = nullptr;
    std::size_t Line = 0;
  };
  /// Follows IS to the value.
  FoundValue Find(const lms3dVRMLNodeInContext& node, std::string_view name);
  struct FoundNodes
  {
    /// Null if there are none.
    const lms3dVRMLNodes* Nodes;
    const lms3dVRMLInstance* Instance;
  };
  FoundNodes FindNodes(const lms3dVRMLNodeInContext& node, std::string_view name);
  void CopyNumbers(
    const lms3dVRMLNodeInContext& node, std::string_view name, double* numbers, std::size_t count);
  void RejectKind(const lms3dVRMLNodeInContext& node, std::string_view name,
    const FoundValue& found, const char* kind);
  /// Adds an error; if the field affects colours only, a warning.
  void Reject(
    std::string_view name, const std::string& file, std::size_t line, const std::string& text);

  lms3dVRMLNodeInContext ExpandInstance(const lms3dVRMLNodeInContext& node);
  bool IsInside(const lms3dVRMLNodeInContext& node) const;

  lms3dVRMLContext& Context;
  lms3dVRMLDocumentCache& Documents;
  std::deque<lms3dVRMLInstance> Instances;
  std::unordered_map<lms3dVRMLNodeInContext, const lms3dVRMLInstance*, lms3dVRMLNodeInContextHash>
    KnownInstances;
  ///@{
  /// Converted lists. Many nodes can share one.
  std::unordered_map<const lms3dVRMLValue*, std::shared_ptr<const lms3dVRMLReals>> AsReals;
  std::unordered_map<const lms3dVRMLValue*, std::shared_ptr<const lms3dVRMLIntegers>> AsIntegers;
  ///@}
};

#endif
