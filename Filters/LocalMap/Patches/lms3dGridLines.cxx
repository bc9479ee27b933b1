// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Patches/lms3dGridLines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace
{
using Lines = std::vector<lms3dGridLine>;

// Degrees.
constexpr double Pole = 90.0;
constexpr double FullCircle = 360.0;
constexpr double MaximumGap = 120.0;
// How far the halo at a seam lies from the turns on both sides, as a share of the angle between
// these.
constexpr double SeamShare = 0.4;
// For the rounding of angles.
constexpr double AngleTolerance = 1e-6;

// Returns the lines of a scan in growing order.
Lines SortAngles(const std::vector<double>& angles, const char* name)
{
  Lines lines;
  lines.reserve(angles.size());
  for (double angle : angles)
  {
    lines.push_back({ angle, static_cast<int>(lines.size()) });
  }
  if (angles.size() > 1 && angles[1] < angles[0])
  {
    std::reverse(lines.begin(), lines.end());
  }
  const auto falls = [](const lms3dGridLine& a, const lms3dGridLine& b)
  { return !(a.Angle < b.Angle); };
  const auto wrong = std::adjacent_find(lines.begin(), lines.end(), falls);
  if (wrong != lines.end())
  {
    throw std::runtime_error("The scan's " + std::string(name) + " contains " +
      std::to_string(wrong->Angle) + " next to " + std::to_string((wrong + 1)->Angle) +
      "; strictly increasing or strictly decreasing angles are expected.");
  }
  return lines;
}

std::string DescribeRange(const Lines& lines, const char* name)
{
  return "The scan's " + std::string(name) + " reach from " + std::to_string(lines.front().Angle) +
    " to " + std::to_string(lines.back().Angle);
}

// Adds lines of the halo where neighbours are too far apart for a cell: one step from each beam,
// and more in between.
Lines FillGaps(const Lines& lines, double step)
{
  Lines filled;
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    filled.push_back(lines[i]);
    if (i + 1 == lines.size() || lines[i + 1].Angle - lines[i].Angle <= MaximumGap + AngleTolerance)
    {
      continue;
    }
    const double first = lines[i].Angle + (lines[i].ScanIndex >= 0 ? step : 0.0);
    const double last = lines[i + 1].Angle - (lines[i + 1].ScanIndex >= 0 ? step : 0.0);
    const int parts = static_cast<int>(std::ceil((last - first) / MaximumGap));
    for (int part = lines[i].ScanIndex >= 0 ? 0 : 1; part < parts; ++part)
    {
      filled.push_back({ first + part * (last - first) / parts, -1 });
    }
    if (lines[i + 1].ScanIndex >= 0)
    {
      filled.push_back({ last, -1 });
    }
  }
  return filled;
}
} // namespace

std::vector<lms3dGridLine> lms3dAddSeams(
  const std::vector<lms3dGridLine>& lines, int seam, bool isClosed)
{
  const auto isFirst = [&](const lms3dGridLine& line) { return line.ScanIndex >= seam; };
  Lines separated;
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    const bool isLast = i + 1 == lines.size();
    const lms3dGridLine& next = lines[isLast ? 0 : i + 1];
    const double step = next.Angle - lines[i].Angle + (isLast ? FullCircle : 0.0);
    separated.push_back(lines[i]);
    if (lines[i].ScanIndex >= 0 && next.ScanIndex >= 0 && isFirst(lines[i]) != isFirst(next) &&
      (isClosed || !isLast))
    {
      separated.push_back({ lines[i].Angle + SeamShare * step, -1 });
      separated.push_back({ lines[i].Angle + (1.0 - SeamShare) * step, -1 });
    }
  }
  return separated;
}

std::vector<lms3dGridLine> lms3dMakeRowLines(
  const std::vector<double>& angles, double step, bool arePoles)
{
  const double haloStep = std::min(step, MaximumGap / 2);
  Lines lines = SortAngles(angles, "AlphaAngles");
  if (lines.front().Angle < -Pole || lines.back().Angle > Pole)
  {
    throw std::runtime_error(
      DescribeRange(lines, "AlphaAngles") + "; elevations from -90 to 90 degrees are expected.");
  }
  if (!arePoles || lines.front().Angle != -Pole)
  {
    lines.insert(lines.begin(), { std::max(-Pole, lines.front().Angle - haloStep), -1 });
  }
  if (!arePoles || lines.back().Angle != Pole)
  {
    lines.push_back({ std::min(Pole, lines.back().Angle + haloStep), -1 });
  }
  return FillGaps(lines, haloStep);
}

std::vector<lms3dGridLine> lms3dMakeColumnLines(
  const std::vector<double>& angles, double step, bool isClosed)
{
  const double haloStep = std::min(step, MaximumGap / 2);
  Lines lines = SortAngles(angles, "BetaAngles");
  const double gap = FullCircle - (lines.back().Angle - lines.front().Angle);
  if (!isClosed && gap <= AngleTolerance)
  {
    throw std::runtime_error(
      DescribeRange(lines, "BetaAngles") + "; a range of less than 360 degrees is expected.");
  }
  if (!isClosed && gap < 3.0 * haloStep)
  {
    lines.push_back({ lines.back().Angle + gap / 2, -1 });
  }
  else if (!isClosed)
  {
    const double first = lines.front().Angle - haloStep + FullCircle;
    lines.push_back({ lines.back().Angle + haloStep, -1 });
    lines.push_back({ first, -1 });
  }
  return FillGaps(lines, haloStep);
}
