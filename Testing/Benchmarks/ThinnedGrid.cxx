// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ThinnedGrid.h"

#include "Device/lms3dScanGeometry.h"
#include "Scenes.h"
#include "Timer.h"

#include "vtkLMS3DScanFilter.h"

#include <algorithm>
#include <limits>

namespace
{
constexpr int PacketSide = 4;

// Milliseconds: quick casts are repeated, since the first is slower.
constexpr double BudgetOfTrial = 20.0;

constexpr double LowestAlpha = -90.0;
constexpr double HighestAlpha = 90.0;
static_assert(PacketSide * PacketSide == lms3dBeamPacket::Size);

std::vector<double> Spread(const double* ranges, const std::vector<std::size_t>& beams)
{
  std::vector<double> spread(ThinnedGrid::MaximumBeams, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < beams.size(); ++i)
  {
    spread[beams[i]] = ranges[i];
  }
  return spread;
}
} // namespace

std::size_t ThinnedGrid::GetNumberOfBeams() const
{
  return static_cast<std::size_t>(this->GetAlphaResolution()) * this->GetBetaResolution();
}

std::vector<std::size_t> ThinnedGrid::GetBeams() const
{
  std::vector<std::size_t> beams;
  beams.reserve(this->GetNumberOfBeams());
  for (int turn = 0; turn < this->GetBetaResolution(); ++turn)
  {
    for (int beam = 0; beam < this->GetAlphaResolution(); ++beam)
    {
      beams.push_back(static_cast<std::size_t>(turn * Alphas + beam) * this->Stride);
    }
  }
  return beams;
}

ThinnedGrid ThinnedGrid::Choose(double longest, const std::function<void(const ThinnedGrid&)>& cast)
{
  const ThinnedGrid coarsest(Strides.back());
  const double ms = GetBestMilliseconds(BudgetOfTrial, [&] { cast(coarsest); }) /
    static_cast<double>(coarsest.GetNumberOfBeams());
  return ThinnedGrid(*std::find_if(Strides.begin(), Strides.end() - 1,
    [&](int stride)
    { return ms * static_cast<double>(ThinnedGrid(stride).GetNumberOfBeams()) <= longest; }));
}

void ThinnedGrid::Apply(vtkLMS3DScanFilter* filter) const
{
  const double step = (HighestAlpha - LowestAlpha) / (Alphas - 1) * this->Stride;
  const int alphas = this->GetAlphaResolution();
  filter->SetAlphaRange(LowestAlpha, LowestAlpha + step * (alphas - 1));
  filter->SetAlphaResolution(alphas);
  filter->SetBetaResolution(this->GetBetaResolution());
}

std::vector<std::size_t> ThinnedGrid::GetBeamsOfShots() const
{
  const int alphas = this->GetAlphaResolution();
  const int betas = this->GetBetaResolution();
  std::vector<std::size_t> beams;
  for (int row = 0; row < betas; row += PacketSide)
  {
    for (int column = 0; column < alphas; column += PacketSide)
    {
      for (int i = 0; i < lms3dBeamPacket::Size; ++i)
      {
        const int turn = std::min(row + i / PacketSide, betas - 1) * this->Stride;
        const int beam = std::min(column + i % PacketSide, alphas - 1) * this->Stride;
        beams.push_back(static_cast<std::size_t>(turn) * Alphas + beam);
      }
    }
  }
  return beams;
}

std::vector<StabilityShot> ThinnedGrid::MakeShots(const BenchmarkScene& scene) const
{
  const std::vector<Vector> directions = MakeDirections(scene);
  const std::vector<std::size_t> beams = this->GetBeamsOfShots();
  std::vector<StabilityShot> shots(beams.size() / lms3dBeamPacket::Size);
  for (std::size_t i = 0; i < beams.size(); ++i)
  {
    StabilityShot& shot = shots[i / lms3dBeamPacket::Size];
    shot.Sensor = scene.Sensor;
    shot.Directions[i % lms3dBeamPacket::Size] = directions[beams[i]];
  }
  return shots;
}

std::vector<double> ThinnedGrid::SpreadGrid(const double* ranges) const
{
  return Spread(ranges, this->GetBeams());
}

std::vector<double> ThinnedGrid::SpreadShots(const std::vector<double>& ranges) const
{
  return Spread(ranges.data(), this->GetBeamsOfShots());
}

std::vector<Vector> ThinnedGrid::MakeDirections(const BenchmarkScene& scene)
{
  const double alphaRange[2] = { LowestAlpha, HighestAlpha };
  const double betaRange[2] = { 0.0, 360.0 };
  const double upright[3] = { 0.0, 0.0, 0.0 };
  const lms3dScanGeometry geometry(alphaRange, Alphas, betaRange, Betas);
  const lms3dPose pose = lms3dPose::FromOrientation(scene.Sensor.data(), upright);
  const lms3dBeamDirections directions(geometry, pose);
  std::vector<Vector> all(MaximumBeams);
  for (std::size_t beam = 0; beam < MaximumBeams; ++beam)
  {
    all[beam] =
      directions.GetDirection(static_cast<int>(beam / Alphas), static_cast<int>(beam % Alphas));
  }
  return all;
}
