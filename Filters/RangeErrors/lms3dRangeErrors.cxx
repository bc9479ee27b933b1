// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RangeErrors/lms3dRangeErrors.h"

#include "Kernels/lms3dPacketKernels.h"
#include "Pipeline/lms3dText.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <cstddef>
#include <cstring>
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

/// Adds the errors of one turn after another. For one thread.
class TurnErrors
{
public:
  TurnErrors(const lms3dRangeErrorSettings& settings, std::uint64_t scan, int beams)
    : Model(MakeModel(settings))
    , Kernels(lms3dGetPacketKernels())
    , Seed(static_cast<std::uint32_t>(settings.Seed))
    , Scan(scan)
    , Beams(beams)
    , Pairs(beams / 2 + beams % 2)
    , Deviates(2 * static_cast<std::size_t>(this->Pairs), 0.0)
  {
  }

  void Add(int turn, double* ranges)
  {
    if (this->Model.Noise > 0.0)
    {
      const auto number = static_cast<std::uint32_t>(turn);
      this->Kernels.DrawNormals({ this->Seed, this->Scan, lms3dEffect::RANGE_NOISE, number },
        this->Pairs, this->Deviates.data());
    }
    this->Kernels.ReportRanges(this->Model, this->Deviates.data(), this->Beams, ranges);
  }

private:
  const lms3dRangeErrorModel Model;
  const lms3dPacketKernels& Kernels;
  const std::uint64_t Seed;
  const std::uint64_t Scan;
  const int Beams;
  const int Pairs;
  std::vector<double> Deviates;
};

// Returns a text if the value is not finite, or is negative although `mayBeNegative` is false.
std::string CheckLength(const char* name, double value, bool mayBeNegative)
{
  if (!std::isfinite(value) || (!mayBeNegative && value < 0.0))
  {
    return lms3dJoinText(name, " is ", value, " m; a finite number",
      (mayBeNegative ? "" : " of 0 or more"), " is expected.");
  }
  return std::string();
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
  const int beams = geometry.GetNumberOfBeams();
  tbb::parallel_for(tbb::blocked_range<int>(0, geometry.GetNumberOfTurns()),
    [&](const tbb::blocked_range<int>& turns)
    {
      TurnErrors errors(settings, scan, beams);
      for (int turn = turns.begin(); turn < turns.end(); ++turn)
      {
        errors.Add(turn, grid + static_cast<std::ptrdiff_t>(turn) * beams);
      }
    });
}

void lms3dAddRangeErrors(
  const lms3dRangeErrorSettings& settings, std::uint64_t scan, int turn, int beams, double* ranges)
{
  TurnErrors(settings, scan, beams).Add(turn, ranges);
}

std::uint64_t lms3dGetScanNumber(double time)
{
  // The sum makes a negative zero positive.
  const double value = time + 0.0;
  std::uint64_t number;
  std::memcpy(&number, &value, sizeof number);
  return number;
}
