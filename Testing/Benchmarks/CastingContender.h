// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief All that casts beams, for chart A: each the same ones, none with a limit of the range that
 * a scene reaches.
 */
#ifndef CastingContender_h
#define CastingContender_h

#include "ThinnedGrid.h"

#include <functional>
#include <string>
#include <vector>

struct BenchmarkScene;

/// Metres: the scenes end before that.
constexpr double CastingMaximumRange = 1000.0;

/// A scene that is ready to be scanned.
struct CastingScan
{
  std::function<void(const ThinnedGrid&)> Cast;
  /// The ranges of the last cast by the beams' numbers in the whole grid.
  std::function<std::vector<double>(const ThinnedGrid&)> GetRanges;
};

struct CastingContender
{
  std::string Name;
  std::function<CastingScan()> Build;
};

/// The methods of vtkLMS3DScanFilter, and the rivals of the stability suite. The scene has to
/// outlive them.
std::vector<CastingContender> MakeCastingContenders(const BenchmarkScene& scene);

#endif
