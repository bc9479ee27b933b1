// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The colours that a geometry node has of its own.
 */
#ifndef lms3dVRMLColors_h
#define lms3dVRMLColors_h

#include "lms3dScene.h"
#include "lms3dVRMLEvaluator.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

/// From 0 to 1; beyond, the nearest that there is.
lms3dColor lms3dMakeColor(const std::array<double, 3>& color);

/// The Color node of an ElevationGrid or IndexedFaceSet.
class lms3dVRMLColors
{
public:
  lms3dVRMLColors(lms3dVRMLEvaluator& evaluator, const lms3dVRMLView& geometry);

  /// Whether there is any.
  bool AreGiven() const { return this->Values && this->Values->size() >= 3; }
  bool ArePerVertex() const { return this->PerVertex; }

  /// That of a whole face.
  lms3dColor Get(std::int64_t color);

  /// The mean of three corners.
  lms3dColor GetMean(const std::array<std::int64_t, 3>& colors);

private:
  std::array<double, 3> GetReal(std::int64_t color);
  void TellMissing();

  lms3dVRMLEvaluator& Evaluator;
  lms3dVRMLView Geometry;
  std::shared_ptr<const lms3dVRMLReals> Values;
  bool PerVertex;
  bool HasToldMissing = false;
};

#endif
