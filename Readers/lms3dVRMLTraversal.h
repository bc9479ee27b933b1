// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Goes through a scene and collects the shapes that it shows.
 */
#ifndef lms3dVRMLTraversal_h
#define lms3dVRMLTraversal_h

#include "lms3dScene.h"
#include "lms3dTransform.h"
#include "lms3dVRMLEvaluator.h"

#include <cstddef>
#include <deque>
#include <map>
#include <memory>
#include <string_view>
#include <tuple>
#include <unordered_set>
#include <vector>

class lms3dVRMLContext;
class lms3dVRMLLibrary;

/// The way through the nodes is in lms3dVRMLTraversal.cxx, its shapes in lms3dVRMLShapes.cxx.
class lms3dVRMLTraversal
{
public:
  lms3dVRMLTraversal(lms3dVRMLContext& context, lms3dVRMLLibrary& library);

  std::vector<lms3dShape> CollectShapes(const lms3dVRMLDocument& scene);

private:
  /// What a node inherits of those around it.
  struct Place
  {
    lms3dTransform ToWorld;
    /// The nearest name that DEF gives.
    std::string_view Name;
    int InlineDepth = 0;
  };

  /// A node, or a file, whose members are being shown one after the other.
  struct Group
  {
    lms3dVRMLView Node;
    std::vector<lms3dVRMLView> Members;
    Place Around;
    std::size_t Next = 0;
    bool IsFile = false;
  };

  void EnterFile(const lms3dVRMLDocument& file, const lms3dVRMLView& view, const Place& place);
  void Enter(const lms3dVRMLView& node, std::vector<lms3dVRMLView> members, const Place& place);
  void Leave(const Group& group);
  void Show(const lms3dVRMLView& view, Place place);
  void ShowNode(const lms3dVRMLView& node, const Place& place);
  void ShowTransform(const lms3dVRMLView& transform, Place place);
  void ShowSwitch(const lms3dVRMLView& view, const Place& place);
  void ShowLevel(const lms3dVRMLView& lod, const Place& place);
  void ShowInline(const lms3dVRMLView& view, Place place);
  void ShowShape(const lms3dVRMLView& view, const Place& place);
  bool HasSurface(const lms3dVRMLView& geometry);

  struct Mesh
  {
    std::shared_ptr<const lms3dMesh> Triangles;
    double LargestCoordinate = 0.0;
  };
  const Mesh& GetMesh(const lms3dVRMLView& geometry, const Place& place);
  void SetColor(const lms3dVRMLView& shape, lms3dShape& result);

  lms3dVRMLContext& Context;
  lms3dVRMLLibrary& Library;
  lms3dVRMLEvaluator Evaluator;
  std::vector<lms3dShape> Shapes;
  /// What is around the current node, and of that the files, and the nodes.
  std::deque<Group> Groups;
  std::vector<const lms3dVRMLDocument*> OpenFiles;
  std::unordered_set<lms3dVRMLView, lms3dVRMLViewHash> Open;
  /// By geometry node, the instance that it depends on, and number of sides.
  std::map<std::tuple<const lms3dVRMLNode*, const lms3dVRMLInstance*, int>, Mesh> Meshes;
};

#endif
