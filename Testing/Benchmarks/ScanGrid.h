// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The beams of a default scan, or some of them: so that all casters get the same.
 */
#ifndef ScanGrid_h
#define ScanGrid_h

#include "StabilityCase.h"

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

struct BenchmarkScene;
class vtkLMS3DScanFilter;

/**
 * Every so many-th elevation of every so many-th turn of the default grid, where that is not all of
 * them without the zenith: whole tiles of 4 x 4 beams, since methods cast no less at once. Its steps
 * are exact in double, so that the directions are those of the whole grid to the bit.
 */
class ScanGrid
{
public:
  static constexpr int Alphas = 361;
  static constexpr int Betas = 360;
  static constexpr std::size_t MostBeams = static_cast<std::size_t>(Alphas) * Betas;

  /// What Choose chooses from.
  static constexpr std::array<int, 3> Strides = { 1, 6, 18 };

  /// 1, or another divisor of 360.
  explicit ScanGrid(int stride)
    : Stride(stride)
  {
  }

  int GetStride() const { return this->Stride; }
  int GetAlphaResolution() const { return this->Stride == 1 ? Alphas : Alphas / this->Stride; }
  int GetBetaResolution() const { return Betas / this->Stride; }
  std::size_t GetNumberOfBeams() const;

  /// The finest whose cast takes no longer, in milliseconds, as far as that of the coarsest tells.
  static ScanGrid Choose(double longest, const std::function<void(const ScanGrid&)>& cast);

  /// Lets a filter scan these beams.
  void Apply(vtkLMS3DScanFilter* filter) const;

  /// Their numbers in the whole grid, turn by turn.
  std::vector<std::size_t> GetBeams() const;

  /// Packets of 4 x 4 neighbours. Those at the border have some beams more than once.
  std::vector<StabilityShot> MakeShots(const BenchmarkScene& scene) const;

  ///@{
  /// The ranges by the beams' numbers in the whole grid; not a number for beams that are not here.
  std::vector<double> SpreadGrid(const double* ranges) const;
  std::vector<double> SpreadShots(const std::vector<double>& ranges) const;
  ///@}

  /// Those of the whole grid, for an upright sensor, as vtkLMS3DScanFilter has them.
  static std::vector<Vector> MakeDirections(const BenchmarkScene& scene);

private:
  /// The numbers of the beams of all packets.
  std::vector<std::size_t> GetBeamsOfShots() const;

  int Stride;
};

#endif
