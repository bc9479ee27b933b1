// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RangeErrors/lms3dRangeErrors.h"

#include "Kernels/lms3dPacketKernels.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <cstddef>
#include <sstream>
#include <vector>

namespace
{
lms3dRangeErrorModel MakeModel(const lms3dRangeErrorSettings& settings)
{
  lms3dRangeErrorModel model = { settings.Bias, settings.Noise, settings.Resolution > 0.0,
    settings.Resolution, 1.0 };
  const double stepsPerMetre = std::rint(1.0 / settings.Resolution);
  if (model.HasSteps && 1.0 / stepsPerMetre == settings.Resolution)
  {
    model.StepNumerator = 1.0;
    model.StepDenominator = stepsPerMetre;
  }
  return model;
}

// Returns a text if the value is not finite, or is negative although `mayBeNegative` is false.
std::string CheckLength(const char* name, double value, bool mayBeNegative)
{
  std::ostringstream error;
  if (!std::isfinite(value) || (!mayBeNegative && value < 0.0))
  {
    error << name << " is " << value << " m; a finite number"
          << (mayBeNegative ? "" : " of 0 or more") << " is expected.";
  }
  return error.str();
}
} // namespace

std::string lms3dFindRangeErrorProblem(const lms3dRangeErrorSettings& settings)
{
  for (const std::string& error : { CheckLength("RangeBias", settings.Bias, true),
         CheckLength("RangeNoise", settings.Noise, false),
         CheckLength("RangeResolution", settings.Resolution, false) })
  {
    if (!error.empty())
    {
      return error;
    }
  }
  return std::string();
}

void lms3dAddRangeErrors(const lms3dRangeErrorSettings& settings, std::uint64_t scan,
  const lms3dScanGeometry& geometry, double* grid)
{
  const lms3dPacketKernels& kernels = lms3dGetPacketKernels();
  const lms3dRangeErrorModel model = MakeModel(settings);
  const int beams = geometry.GetNumberOfBeams();
  const int pairs = beams / 2 + beams % 2;
  const std::uint64_t seed = static_cast<std::uint32_t>(settings.Seed);
  tbb::parallel_for(tbb::blocked_range<int>(0, geometry.GetNumberOfTurns()),
    [&](const tbb::blocked_range<int>& turns)
    {
      std::vector<double> deviates(2 * static_cast<std::size_t>(pairs), 0.0);
      for (int turn = turns.begin(); turn < turns.end(); ++turn)
      {
        if (model.Noise > 0.0)
        {
          const auto number = static_cast<std::uint32_t>(turn);
          kernels.DrawNormals(
            { seed, scan, lms3dEffect::RANGE_NOISE, number }, pairs, deviates.data());
        }
        kernels.ReportRanges(
          model, deviates.data(), beams, grid + static_cast<std::ptrdiff_t>(turn) * beams);
      }
    });
}
