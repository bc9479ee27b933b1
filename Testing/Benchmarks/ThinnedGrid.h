// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The beams of a default scan, or a regular selection of them, the same for all casters.
 */
#ifndef ThinnedGrid_h
#define ThinnedGrid_h

#include "StabilityCase.h"

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

struct BenchmarkScene;
class vtkLMS3DScanFilter;

/**
 * With stride n, each n-th elevation of each n-th turn of the default grid; without the zenith if n
 * is above 1, so that the grid consists of whole packets of 4 x 4 beams, which casters cast at
 * once. Its steps are exact in double precision, so that directions equal the whole grid's to the
 * bit.
 */
class ThinnedGrid
{
public:
  static constexpr int Alphas = 361;
  static constexpr int Betas = 360;
  static constexpr std::size_t MaximumBeams = static_cast<std::size_t>(Alphas) * Betas;

  /// The strides that Choose tries.
  static constexpr std::array<int, 3> Strides = { 1, 6, 18 };

  /// 1, or another divisor of 360.
  explicit ThinnedGrid(int stride)
    : Stride(stride)
  {
  }

  int GetStride() const { return this->Stride; }
  int GetAlphaResolution() const { return this->Stride == 1 ? Alphas : Alphas / this->Stride; }
  int GetBetaResolution() const { return Betas / this->Stride; }
  std::size_t GetNumberOfBeams() const;

  /// Returns the finest grid whose cast takes at most `longest` milliseconds, as estimated from the
  /// coarsest grid.
  static ThinnedGrid Choose(double longest, const std::function<void(const ThinnedGrid&)>& cast);

  /// Sets the resolutions of a filter.
  void Apply(vtkLMS3DScanFilter* filter) const;

  /// Returns the indices of the beams in the whole grid, turn by turn.
  std::vector<std::size_t> GetBeams() const;

  /// Packets of 4 x 4 neighbours. Those at the border have some beams more than once.
  std::vector<StabilityShot> MakeShots(const BenchmarkScene& scene) const;

  ///@{
  /// Returns ranges by the beams' indices in the whole grid, NaN for beams that are not selected.
  std::vector<double> SpreadGrid(const double* ranges) const;
  std::vector<double> SpreadShots(const std::vector<double>& ranges) const;
  ///@}

  /// Returns the directions of the whole grid for an upright sensor, as in vtkLMS3DScanFilter.
  static std::vector<Vector> MakeDirections(const BenchmarkScene& scene);

private:
  /// Returns the indices of the beams of all packets.
  std::vector<std::size_t> GetBeamsOfShots() const;

  int Stride;
};

#endif
