// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The options and limits of one reading, and its progress function.
 */
#ifndef lms3dVRMLOptions_h
#define lms3dVRMLOptions_h

#include <cstdint>
#include <functional>
#include <string>

/// The defaults are the defaults of vtkVRMLImporterSource, which documents each option. No limit
/// is negative.
struct lms3dVRMLOptions
{
  /// The files of Inline and EXTERNPROTO must be below this folder. If it is empty, the folder of
  /// the scene takes its place.
  std::string SceneRoot;
  /// The maximum distance of the triangles of a Sphere, Cone or Cylinder from its true surface, in
  /// metres of the world.
  double ChordError = 0.001;
  int MaximumInlineDepth = 16;
  /// Limits two counts: of the nodes that the files contain, and of the visits to nodes, where each
  /// USE and each instance counts again.
  std::int64_t MaximumNumberOfNodes = 2'000'000;
  std::int64_t MaximumNumberOfTriangles = 20'000'000;
  /// In bytes: of all that the reader makes from the files, and of the output.
  std::int64_t MaximumMemory = 2'000'000'000;
  /// In bytes; the sum over all files of the scene, unpacked.
  std::int64_t MaximumFileSize = 1'000'000'000;
};

/// Receives the fraction done, 0 to 1. Returns false to stop the reading.
using lms3dProgressFunction = std::function<bool(double)>;

#endif
