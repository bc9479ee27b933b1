// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fixtures/ScanDamage.h"

#include "Fixtures/VectorFixtures.h"

#include "vtkLMS3DRangeErrorFilter.h"
#include "vtkLMS3DScanFilter.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>

namespace
{
/// Turns and numbers of beams, counted from one of them.
using Group = std::vector<std::array<int, 2>>;

constexpr int MinimumStripe = 5;
constexpr int MaximumStripe = 20;
constexpr int LargestRadius = 3;

/// What random numbers are for.
enum class Purpose
{
  Dropout,
  Stray
};

// The random numbers of a beam.
Random MakeRandom(int seed, Purpose purpose, std::size_t beam)
{
  constexpr std::uint64_t NumberOfPurposes = 2;
  Random start(
    NumberOfPurposes * static_cast<std::uint64_t>(seed) + static_cast<std::uint64_t>(purpose));
  return Random(start.GetBits() + beam);
}

Group MakeDisc(int radius)
{
  Group disc;
  for (int turn = -radius; turn <= radius; ++turn)
  {
    for (int number = -radius; number <= radius; ++number)
    {
      if (turn * turn + number * number <= radius * radius)
      {
        disc.push_back({ turn, number });
      }
    }
  }
  return disc;
}

std::vector<Group> MakeStripes()
{
  std::vector<Group> stripes;
  for (int length = MinimumStripe; length <= MaximumStripe; ++length)
  {
    Group inFan;
    Group inTurn;
    for (int i = 0; i < length; ++i)
    {
      inFan.push_back({ 0, i - length / 2 });
      inTurn.push_back({ i - length / 2, 0 });
    }
    stripes.push_back(inFan);
    stripes.push_back(inTurn);
  }
  return stripes;
}

std::vector<Group> MakeGroups(ScanDamage::Shapes shape)
{
  if (shape == ScanDamage::Shapes::Stripes)
  {
    return MakeStripes();
  }
  std::vector<Group> discs;
  const bool isBeam = shape == ScanDamage::Shapes::SingleBeams;
  for (int radius = isBeam ? 0 : 1; radius <= (isBeam ? 0 : LargestRadius); ++radius)
  {
    discs.push_back(MakeDisc(radius));
  }
  return discs;
}

// The share of beams at which groups start, so that the groups, which may overlap, cover a share of
// all.
double GetShareOfStarts(const std::vector<Group>& groups, double share)
{
  double beams = 0.0;
  for (const Group& group : groups)
  {
    beams += static_cast<double>(group.size());
  }
  const bool isSingle = groups.size() == 1;
  return isSingle ? share : -std::log1p(-share) * static_cast<double>(groups.size()) / beams;
}

vtkIdType Count(vtkPolyData* scan, const char* angles)
{
  return scan->GetFieldData()->GetArray(angles)->GetNumberOfTuples();
}

// Moves stray returns towards the sensor.
vtkSmartPointer<vtkPolyData> AddStrays(vtkPolyData* scan, const ScanDamage& damage)
{
  constexpr double NearestShare = 0.1;
  auto strayed = vtkSmartPointer<vtkPolyData>::New();
  strayed->DeepCopy(scan);
  vtkDataArray* matrix = scan->GetFieldData()->GetArray("SensorToWorld");
  const Vector sensor = { matrix->GetTuple1(3), matrix->GetTuple1(7), matrix->GetTuple1(11) };
  vtkDataArray* ranges = strayed->GetPointData()->GetArray("Range");
  vtkDataArray* beams = strayed->GetPointData()->GetArray("BeamId");
  for (vtkIdType i = 0; i < strayed->GetNumberOfPoints(); ++i)
  {
    const auto beam = static_cast<int>(beams->GetTuple1(i));
    if (damage.IsStray(beam))
    {
      Random random = MakeRandom(damage.Seed, Purpose::Stray, static_cast<std::size_t>(beam));
      random.Get();
      const double share = random.Get(NearestShare, 1.0);
      Vector point;
      strayed->GetPoint(i, point.data());
      const Vector to = sensor + share * (point - sensor);
      strayed->GetPoints()->SetPoint(i, to.data());
      ranges->SetTuple1(i, share * ranges->GetTuple1(i));
    }
  }
  return strayed;
}

vtkSmartPointer<vtkPolyData> AddRangeErrors(vtkPolyData* scan, const ScanDamage& damage)
{
  vtkNew<vtkLMS3DRangeErrorFilter> errors;
  errors->SetInputData(scan);
  errors->SetRangeNoise(damage.Noise);
  errors->SetRangeResolution(damage.Steps);
  errors->SetNoiseSeed(damage.Seed);
  errors->Update();
  return errors->GetOutput();
}

void MarkAsWeak(vtkPolyData* scan, const std::vector<bool>& isLost)
{
  vtkDataArray* before = scan->GetFieldData()->GetArray("Status");
  if (!before)
  {
    return;
  }
  const vtkSmartPointer<vtkDataArray> status =
    vtkSmartPointer<vtkDataArray>::Take(before->NewInstance());
  status->DeepCopy(before);
  for (std::size_t beam = 0; beam < isLost.size(); ++beam)
  {
    const auto at = static_cast<vtkIdType>(beam);
    if (isLost[beam] && status->GetTuple1(at) == vtkLMS3DScanFilter::RETURN)
    {
      status->SetTuple1(at, vtkLMS3DScanFilter::TOO_WEAK);
    }
  }
  scan->GetFieldData()->AddArray(status);
}
} // namespace

bool ScanDamage::IsStray(int beam) const
{
  return MakeRandom(this->Seed, Purpose::Stray, static_cast<std::size_t>(beam)).Get() <
    this->Strays;
}

std::vector<bool> ScanDamage::FindDropouts(int numberOfBeams, int numberOfTurns) const
{
  const std::vector<Group> groups = MakeGroups(this->Shape);
  const double starts = GetShareOfStarts(groups, this->Dropouts);
  std::vector<bool> isLost(static_cast<std::size_t>(numberOfBeams) * numberOfTurns, false);
  for (std::size_t start = 0; start < isLost.size(); ++start)
  {
    Random random = MakeRandom(this->Seed, Purpose::Dropout, start);
    if (random.Get() >= starts)
    {
      continue;
    }
    const Group& group =
      groups[static_cast<std::size_t>(random.Get() * static_cast<double>(groups.size()))];
    for (const auto& [turns, numbers] : group)
    {
      const int turn = static_cast<int>(start) / numberOfBeams + turns + numberOfTurns;
      const int number = static_cast<int>(start) % numberOfBeams + numbers;
      if (turn >= 0 && number >= 0 && number < numberOfBeams)
      {
        isLost[static_cast<std::size_t>(turn % numberOfTurns) * numberOfBeams + number] = true;
      }
    }
  }
  return isLost;
}

std::string ScanDamage::Describe() const
{
  constexpr std::array<const char*, 3> ShapeNames = { "single beams", "stripes", "blobs" };
  std::ostringstream words;
  words << 100.0 * this->Dropouts << " % lost in "
        << ShapeNames[static_cast<std::size_t>(this->Shape)] << ", " << 100.0 * this->Strays
        << " % strays, noise of " << this->Noise << " m, steps of " << this->Steps << " m, seed "
        << this->Seed;
  return words.str();
}

vtkSmartPointer<vtkPolyData> Keep(
  vtkPolyData* scan, const std::function<bool(vtkIdType number)>& isKept)
{
  auto rest = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  rest->SetPoints(points);
  rest->GetPointData()->CopyAllocate(scan->GetPointData());
  rest->GetFieldData()->ShallowCopy(scan->GetFieldData());
  for (vtkIdType i = 0; i < scan->GetNumberOfPoints(); ++i)
  {
    if (isKept(i))
    {
      rest->GetPointData()->CopyData(
        scan->GetPointData(), i, points->InsertNextPoint(scan->GetPoint(i)));
    }
  }
  return rest;
}

vtkSmartPointer<vtkPolyData> Damage(vtkPolyData* scan, const ScanDamage& damage)
{
  const std::vector<bool> isLost = damage.FindDropouts(
    static_cast<int>(Count(scan, "AlphaAngles")), static_cast<int>(Count(scan, "BetaAngles")));
  const vtkSmartPointer<vtkPolyData> measured = AddRangeErrors(AddStrays(scan, damage), damage);
  vtkDataArray* beams = measured->GetPointData()->GetArray("BeamId");
  vtkSmartPointer<vtkPolyData> rest = Keep(
    measured, [&](vtkIdType i) { return !isLost[static_cast<std::size_t>(beams->GetTuple1(i))]; });
  MarkAsWeak(rest, isLost);
  return rest;
}
