// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The situations in which ray casters fail, each with the parameter that makes it worse.
 */
#ifndef StabilitySituations_h
#define StabilitySituations_h

#include "StabilityCase.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

struct StabilitySituation
{
  /// What is difficult, as in "slivers", and how much, as in "1e4".
  std::string Name;
  std::string Parameter;
  /// The seed of the random numbers, so that beams are the same in each run.
  std::uint64_t Seed;
  std::function<StabilityCase(Random&, std::size_t)> Make;

  /// The number of packets of 16 beams at the scene.
  StabilityCase MakeCase(std::size_t shots) const;
};

/// In the order of the chart. Documentation/charts/C-stability.md explains each.
const std::vector<StabilitySituation>& GetStabilitySituations();

#endif
