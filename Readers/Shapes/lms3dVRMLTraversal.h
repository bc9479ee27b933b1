// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Traverses a scene and collects its visible shapes.
 */
#ifndef lms3dVRMLTraversal_h
#define lms3dVRMLTraversal_h

#include "Evaluation/lms3dVRMLEvaluator.h"
#include "Model/lms3dScene.h"
#include "Model/lms3dTransform.h"

#include <cstddef>
#include <deque>
#include <map>
#include <memory>
#include <string_view>
#include <tuple>
#include <unordered_set>
#include <vector>

class lms3dVRMLContext;
class lms3dVRMLDocumentCache;

/**
 * Visits the nodes depth first, in the order of the file. The stack of open groups is a container,
 * not the call stack, so that deep scenes are safe.
 *
 * The traversal of nodes is in lms3dVRMLTraversal.cxx, of shapes in lms3dVRMLShapes.cxx.
 */
class lms3dVRMLTraversal
{
public:
  /// Both arguments must outlive the traversal.
  lms3dVRMLTraversal(lms3dVRMLContext& context, lms3dVRMLDocumentCache& documents);

  /// Returns the shapes of the scene. Call once.
  std::vector<lms3dShape> CollectShapes(const lms3dVRMLDocument& scene);

private:
  /// What a node inherits from the nodes around it.
  struct InheritedState
  {
    /// From local coordinates to world coordinates.
    lms3dTransform ToWorld;
    /// The nearest name given by DEF.
    std::string_view Name;
    int InlineDepth = 0;
  };

  /// A node or a file whose members are being visited.
  struct Group
  {
    /// The grouping node; for a file the Inline, or no node for the scene itself.
    lms3dVRMLNodeInContext Node;
    std::vector<lms3dVRMLNodeInContext> Members;
    InheritedState State;
    /// The index of the next member to visit.
    std::size_t Next = 0;
    bool IsFile = false;
  };

  void EnterFile(const lms3dVRMLDocument& file, const lms3dVRMLNodeInContext& fileNode,
    const InheritedState& state);
  void Enter(const lms3dVRMLNodeInContext& node, std::vector<lms3dVRMLNodeInContext> members,
    const InheritedState& state);
  void Leave(const Group& group);
  /// Expands an instance and visits the result.
  void Visit(const lms3dVRMLNodeInContext& member, InheritedState state);
  void VisitNode(const lms3dVRMLNodeInContext& node, const InheritedState& state);
  void VisitTransform(const lms3dVRMLNodeInContext& transform, InheritedState state);
  void VisitSwitch(const lms3dVRMLNodeInContext& switchNode, const InheritedState& state);
  void VisitLOD(const lms3dVRMLNodeInContext& lod, const InheritedState& state);
  void VisitInline(const lms3dVRMLNodeInContext& inlineNode, InheritedState state);
  void VisitShape(const lms3dVRMLNodeInContext& shapeNode, const InheritedState& state);
  /// Returns whether the geometry of a Shape can have triangles. Adds a message if it is not a
  /// geometry node.
  bool HasSurface(const lms3dVRMLNodeInContext& geometry);

  /// Triangles is never null. LargestCoordinate is in local coordinates.
  struct Mesh
  {
    std::shared_ptr<const lms3dMesh> Triangles;
    double LargestCoordinate = 0.0;
  };
  /// Makes the mesh, or returns the one that another Shape with the same geometry has made.
  const Mesh& GetMesh(const lms3dVRMLNodeInContext& geometry, const InheritedState& state);
  void SetColor(const lms3dVRMLNodeInContext& shape, lms3dShape& result);

  lms3dVRMLContext& Context;
  lms3dVRMLDocumentCache& Documents;
  lms3dVRMLEvaluator Evaluator;
  std::vector<lms3dShape> Shapes;
  /// The groups around the current node, outermost first.
  std::deque<Group> Groups;
  /// The files and the nodes among them.
  std::vector<const lms3dVRMLDocument*> OpenFiles;
  std::unordered_set<lms3dVRMLNodeInContext, lms3dVRMLNodeInContextHash> OpenNodes;
  /// Keyed by geometry node, the instance that it depends on, and the number of sides.
  std::map<std::tuple<const lms3dVRMLNode*, const lms3dVRMLInstance*, int>, Mesh> Meshes;
};

#endif
