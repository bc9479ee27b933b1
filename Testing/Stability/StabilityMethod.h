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

struct StabilityMethod
{
  std::string Name;
  /// The ranges of all beams, shot after shot, in units of their directions' lengths; infinite where
  /// nothing is hit.
  std::function<std::vector<double>(const StabilityCase&)> Cast;
};

/// Those of vtkLMS3DScanFilter, by number, from the scene as the filter takes it.
std::vector<StabilityMethod> GetFilterMethods();

/// The founding paper's sum of angles, as AngleSum, with other tolerances; the first has none.
std::vector<StabilityMethod> GetAngleSumMethods();

#endif
