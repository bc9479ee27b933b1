// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What is measured while something grows: building, scanning and mapping.
 */
#ifndef GrowthWork_h
#define GrowthWork_h

#include "ThinnedGrid.h"

#include <functional>
#include <string>
#include <vector>

struct BenchmarkScene;

struct GrowthLimits
{
  /// Milliseconds for which a work is repeated.
  double Budget;
  /// Milliseconds: a default scan that takes longer is one of fewer beams, and what takes longer
  /// than the other is left out.
  double LongScan;
  double LongWork;
};

struct GrowthSetting
{
  /// What grows.
  std::string Against;
  const BenchmarkScene& Scene;
  int Alphas = ThinnedGrid::Alphas;
  int Betas = ThinnedGrid::Betas;
  int Threads = 1;

  double GetBeams() const { return static_cast<double>(this->Alphas) * this->Betas; }

  /// Whether fewer beams may represent the scan: only for a default scan.
  bool MayThin() const { return this->Against != "beams"; }
};

struct GrowthWork
{
  std::string Name;
  std::string Contender;
  /// To be done in a process of its own: gives the beams, milliseconds, and megabytes held and
  /// taken.
  std::function<std::vector<double>(const GrowthSetting&, const GrowthLimits&)> Do;
};

///@{
/// By each of the filter's methods.
std::vector<GrowthWork> GetGrowthBuilds();
std::vector<GrowthWork> GetGrowthScans();
///@}

/// The plain grid and the bounded map of a scan.
std::vector<GrowthWork> GetGrowthMaps();

#endif
