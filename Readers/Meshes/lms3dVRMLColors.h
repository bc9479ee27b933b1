// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The colours of a geometry node's faces or vertices.
 */
#ifndef lms3dVRMLColors_h
#define lms3dVRMLColors_h

#include "Evaluation/lms3dVRMLEvaluator.h"
#include "Model/lms3dScene.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

/// Converts components from 0 to 1 to bytes. Clamps values out of range; NaN becomes 0.
lms3dColor lms3dMakeColor(const std::array<double, 3>& color);

/// The Color node of an ElevationGrid or IndexedFaceSet. The evaluator must outlive it.
class lms3dVRMLColors
{
public:
  lms3dVRMLColors(lms3dVRMLEvaluator& evaluator, const lms3dVRMLNodeInContext& geometry);

  /// Returns whether the node has at least one colour.
  bool AreGiven() const { return this->Values && this->Values->size() >= 3; }
  bool ArePerVertex() const { return this->PerVertex; }

  /// Returns the colour with this index, for a whole face. If the index is out of range, returns
  /// the default diffuse colour of a Material and adds one message for the node.
  lms3dColor Get(std::int64_t color);

  /// Returns the mean of three colours, one for each corner of a triangle.
  lms3dColor GetMean(const std::array<std::int64_t, 3>& colors);

private:
  std::array<double, 3> GetReal(std::int64_t color);
  void ReportMissing();

  lms3dVRMLEvaluator& Evaluator;
  lms3dVRMLNodeInContext Geometry;
  std::shared_ptr<const lms3dVRMLReals> Values;
  bool PerVertex;
  bool HasReportedMissing = false;
};

#endif
