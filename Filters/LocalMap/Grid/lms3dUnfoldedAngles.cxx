// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Grid/lms3dUnfoldedAngles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

namespace
{
constexpr double Pole = 90.0;
constexpr double HalfCircle = 180.0;
// For the rounding of angles.
constexpr double AngleTolerance = 1e-6;
constexpr int NoBeam = -1;
// The step around a single beam, which has no step of its own.
constexpr double DefaultStep = 1.0;

void CheckMonotonic(const std::vector<double>& angles, const char* name)
{
  for (std::size_t i = 1; i < angles.size(); ++i)
  {
    if (!((angles[i] - angles[i - 1]) * (angles.back() - angles.front()) > 0.0))
    {
      throw std::runtime_error("The scan's " + std::string(name) + " contains " +
        std::to_string(angles[i - 1]) + " next to " + std::to_string(angles[i]) +
        "; strictly increasing or strictly decreasing angles are expected.");
    }
  }
}

double GetStep(const std::vector<double>& angles)
{
  return angles.size() < 2
    ? 0.0
    : (angles.back() - angles.front()) / static_cast<double>(angles.size() - 1);
}
} // namespace

lms3dUnfoldedAngles::lms3dUnfoldedAngles(
  const std::vector<double>& alphas, const std::vector<double>& betas)
{
  CheckMonotonic(alphas, "AlphaAngles");
  CheckMonotonic(betas, "BetaAngles");
  this->MakeRows(alphas);
  const double step = std::abs(GetStep(alphas));
  this->MakeTurns(betas, step > 0.0 ? step : DefaultStep);
}

bool lms3dUnfoldedAngles::IsRepeated(double turned)
{
  return turned >= HalfCircle - AngleTolerance;
}

// Pairs the beams of both halves from the pole outwards.
void lms3dUnfoldedAngles::MakeRows(const std::vector<double>& alphas)
{
  std::array<std::vector<int>, 2> outwards;
  int pole = NoBeam;
  for (std::size_t i = 0; i < alphas.size(); ++i)
  {
    const int beam = static_cast<int>(i);
    if (std::abs(alphas[i]) <= AngleTolerance)
    {
      pole = beam;
    }
    else
    {
      outwards[alphas[i] > 0.0 ? 0 : 1].push_back(beam);
    }
  }
  for (std::vector<int>& beams : outwards)
  {
    std::sort(beams.begin(), beams.end(),
      [&](int a, int b) { return std::abs(alphas[a]) > std::abs(alphas[b]); });
  }
  const std::size_t rows = std::max(outwards[0].size(), outwards[1].size());
  for (std::vector<int>& beams : outwards)
  {
    beams.insert(beams.begin(), rows - beams.size(), NoBeam);
  }
  this->AreHalvesEqual = true;
  for (std::size_t row = 0; row < rows; ++row)
  {
    const int first = outwards[0][row] != NoBeam ? outwards[0][row] : outwards[1][row];
    const int second = outwards[1][row] != NoBeam ? outwards[1][row] : first;
    const double a = std::abs(alphas[first]);
    const double b = std::abs(alphas[second]);
    const bool areEqual = std::abs(a - b) <= AngleTolerance;
    this->AreHalvesEqual = this->AreHalvesEqual && areEqual;
    this->Alphas.push_back(Pole - (areEqual ? a : 0.5 * (a + b)));
  }
  this->Beams = std::move(outwards);
  if (pole != NoBeam)
  {
    this->Alphas.push_back(Pole);
    this->Beams[0].push_back(pole);
    this->Beams[1].push_back(pole);
  }
}

// Turns without returns take the place of missing turns. If the turns do not close the circle,
// there is at least one on either side.
void lms3dUnfoldedAngles::MakeTurns(const std::vector<double>& betas, double stepOfSingleTurn)
{
  std::vector<double> half;
  for (double beta : betas)
  {
    if (!IsRepeated(std::abs(beta - betas.front())))
    {
      half.push_back(beta);
    }
  }
  double step = GetStep(half);
  if (step == 0.0)
  {
    const double wanted = betas.size() > 1 ? betas[1] - betas[0] : stepOfSingleTurn;
    step = HalfCircle / std::max(1.0, std::round(HalfCircle / wanted));
  }
  const double direction = step > 0.0 ? 1.0 : -1.0;
  const double gap = HalfCircle - std::abs(half.back() - half.front());
  const double missing = std::round(gap / std::abs(step)) - 1.0;
  const bool isWhole = std::abs(gap - (missing + 1.0) * std::abs(step)) <= AngleTolerance;
  const int fillers = static_cast<int>(std::max(isWhole ? 0.0 : 1.0, missing));
  const double last = half.back();
  for (int i = 1; i <= fillers; ++i)
  {
    half.push_back(last + direction * gap * i / (fillers + 1));
  }
  this->TurnsOfHalf = static_cast<int>(half.size());
  this->Betas = half;
  for (double beta : half)
  {
    this->Betas.push_back(beta + direction * HalfCircle);
  }
}
