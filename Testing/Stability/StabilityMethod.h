// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A ray caster, as the stability suite calls it.
 */
#ifndef StabilityMethod_h
#define StabilityMethod_h

#include "StabilityCase.h"

#include <functional>
#include <string>
#include <vector>

/// Gives the ranges of all beams, shot after shot, in units of their directions' lengths; infinite
/// where nothing is hit.
using StabilityCaster = std::function<std::vector<double>(const std::vector<StabilityShot>&)>;

struct StabilityMethod
{
  std::string Name;
  /// Prepares a scene; what it returns keeps all that it needs.
  std::function<StabilityCaster(const lms3dTriangleMesh&)> Build;

  std::vector<double> Cast(const StabilityCase& scene) const
  {
    return this->Build(scene.Mesh)(scene.Shots);
  }
};

/// The methods of vtkLMS3DScanFilter, by their numbers, for the scene as the filter takes it.
std::vector<StabilityMethod> GetFilterMethods();

/// The founding paper's sum of angles, as AngleSum, with other tolerances; the first has none.
std::vector<StabilityMethod> GetAngleSumMethods();

#endif
