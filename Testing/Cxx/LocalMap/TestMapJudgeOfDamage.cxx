// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Breaks the laws for gaps and speckles on purpose and checks that the judge finds the
 * breach.
 */
#include "LocalMap/MapJudgeFixture.h"

#include "vtkLMS3DScanFilter.h"

#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

namespace
{
constexpr int NumberOfBeams = 31;
constexpr double Radius = 2.0;

using RangeOfBeam = std::function<double(int turn, int number)>;

/// A part of a ball, and the plain grid of the scan without errors as its map.
class MapJudgeOfDamage : public MapJudge
{
protected:
  MapJudgeOfDamage()
  {
    this->Scene.Surface = nullptr;
    this->Promise.MaximumGapSize = 1;
    this->SetIdeal([](int, int) { return Radius; });
  }

  void SetIdeal(const RangeOfBeam& getRange)
  {
    this->Ideal = MakeGridScan(getRange);
    this->Scan = this->Ideal;
    this->Promise.Ideal = this->Ideal;
    this->TakeGrid();
  }

  /// Takes returns out of the scan, by BeamId.
  void Lose(const std::set<int>& beams)
  {
    this->Scan = Keep(this->Ideal, [&](vtkIdType number) { return beams.count(number) == 0; });
    this->AddValue<vtkIntArray>(
      "NumberOfReturns", static_cast<double>(this->Scan->GetNumberOfPoints()));
    this->AddValue<vtkIntArray>(
      "NumberOfReturnsOnPatches", static_cast<double>(this->Scan->GetNumberOfPoints()));
    this->AddNumbers("ClosedBeamIds", beams);
    this->AddValue<vtkIntArray>("NumberOfClosedGaps", 1);
  }

  /// Adds numbers to the field data of the map.
  void AddNumbers(const char* name, const std::set<int>& numbers)
  {
    vtkNew<vtkIntArray> array;
    array->SetName(name);
    for (int number : numbers)
    {
      array->InsertNextValue(number);
    }
    this->Map->GetFieldData()->AddArray(array);
  }

  /// Gives the scan the array Status: one value for a beam, RETURN for all others.
  void SetStatus(int beam, int value)
  {
    vtkNew<vtkUnsignedCharArray> status;
    status->SetName("Status");
    status->SetNumberOfTuples(vtkIdType(NumberOfBeams) * NumberOfBeams);
    status->FillValue(vtkLMS3DScanFilter::RETURN);
    status->SetValue(beam, static_cast<unsigned char>(value));
    this->Scan->GetFieldData()->AddArray(status);
  }

  /// Brings the returns of some beams half a metre nearer.
  void BringNearer(const std::set<int>& beams, double length = 0.5)
  {
    this->Scan = MakeGridScan([&](int turn, int number)
      { return beams.count(turn * NumberOfBeams + number) > 0 ? Radius - length : Radius; });
  }

  void ExpectLawful()
  {
    const MapVerdict verdict = this->Judge();
    EXPECT_TRUE(verdict.IsLawful()) << verdict;
  }

  static vtkSmartPointer<vtkPolyData> MakeGridScan(const RangeOfBeam& getRange)
  {
    return MakeScan(
      MakeAngles(-45.0, 45.0, NumberOfBeams), MakeAngles(0.0, 90.0, NumberOfBeams), getRange);
  }

  vtkSmartPointer<vtkPolyData> Ideal;
};

constexpr int Inside = 10 * NumberOfBeams + 8;
} // namespace

TEST_F(MapJudgeOfDamage, LikesAClosedGap)
{
  this->Lose({ Inside, Inside + 2 });
  this->AddValue<vtkIntArray>("NumberOfClosedGaps", 2);
  this->ExpectLawful();
}

TEST_F(MapJudgeOfDamage, SeesWrongFieldDataOfGaps)
{
  this->Lose({ Inside });
  this->ExpectLawful();
  this->AddNumbers("ClosedBeamIds", { Inside, Inside + 2 });
  this->ExpectBreach("closed gap");
  this->AddNumbers("ClosedBeamIds", {});
  this->ExpectBreach("miss");
  this->AddNumbers("ClosedBeamIds", { Inside });
  this->AddValue<vtkIntArray>("NumberOfClosedGaps", 2);
  this->ExpectBreach("closed gap");
}

TEST_F(MapJudgeOfDamage, SeesAClosedGapThatIsTooLarge)
{
  this->Lose({ Inside, Inside + 1 });
  this->ExpectBreach("miss");
  this->Lose({ Inside, Inside + NumberOfBeams });
  this->ExpectBreach("miss");
  this->Promise.MaximumGapSize = 2;
  this->ExpectLawful();
}

TEST_F(MapJudgeOfDamage, LikesAClosedGapThatGoesAroundTheSensorTwice)
{
  constexpr int Turns = 30;
  this->Ideal = MakeScan(MakeAngles(-45.0, 45.0, NumberOfBeams), MakeAngles(0.0, 348.0, Turns),
    [](int, int) { return Radius; });
  this->Promise.Ideal = this->Ideal;
  this->Scan = this->Ideal;
  this->TakeGrid();
  std::set<int> spiral;
  for (int i = 0; i <= 2 * Turns + 10; ++i)
  {
    const int turn = (3 * Turns - i) % Turns;
    const int number = 5 + i / 10;
    spiral.insert({ turn * NumberOfBeams + number, turn * NumberOfBeams + number + 1 });
  }
  this->Promise.MaximumGapSize = static_cast<int>(spiral.size());
  this->Lose(spiral);
  this->ExpectLawful();
}

TEST_F(MapJudgeOfDamage, SeesAClosedGapAtTheEdge)
{
  this->Scan = this->Ideal;
  this->Lose({ 15 * NumberOfBeams });
  // All places around the beam must have surface.
  this->Promise.MaximumGapSize = 9;
  EXPECT_EQ(this->Judge().GetNumberOfBreaches("miss"), 0u);
  this->Lose({ 15 * NumberOfBeams, 15 * NumberOfBeams + 1 });
  this->ExpectBreach("miss");
}

TEST_F(MapJudgeOfDamage, SeesAClosedGapWhereABeamMetNothing)
{
  this->Lose({ Inside });
  this->SetStatus(Inside, vtkLMS3DScanFilter::TOO_WEAK);
  this->ExpectLawful();
  for (int status : { vtkLMS3DScanFilter::NOTHING_MET, vtkLMS3DScanFilter::BEYOND_RANGE })
  {
    this->SetStatus(Inside, status);
    this->ExpectBreach("miss");
  }
}

TEST_F(MapJudgeOfDamage, ExpectsGapsToBeClosedByDefaultOnlyWithStatus)
{
  this->Promise.MaximumGapSize = -1;
  this->Lose({ Inside });
  this->ExpectBreach("miss");
  this->SetStatus(Inside, vtkLMS3DScanFilter::TOO_WEAK);
  this->ExpectLawful();
}

TEST_F(MapJudgeOfDamage, SeesAClosedGapWhereABeamPassed)
{
  this->Lose({ Inside });
  vtkSmartPointer<vtkPolyData> window = MakeGridScan(
    [](int turn, int number) { return turn * NumberOfBeams + number == Inside ? 3.0 : Radius; });
  this->Promise.Ideal = window;
  this->ExpectBreach("passage");
  // Within the bound, and before the surface.
  for (double range : { Radius + 0.009, 1.0 })
  {
    window = MakeGridScan([&](int turn, int number)
      { return turn * NumberOfBeams + number == Inside ? range : Radius; });
    this->Promise.Ideal = window;
    EXPECT_EQ(this->Judge().GetNumberOfBreaches("passage"), 0u) << range;
  }
}

TEST_F(MapJudgeOfDamage, SeesABridgeToALostReturn)
{
  const auto isHatch = [](int turn, int number)
  { return turn >= 12 && turn < 18 && number >= 12 && number < 18; };
  this->SetIdeal(
    [&](int turn, int number) { return isHatch(turn, number) ? Radius + 0.5 : Radius; });
  this->Lose({ 12 * NumberOfBeams + 14 });
  EXPECT_EQ(this->Judge().GetNumberOfBreaches("bridge"), 0u);
  const auto getVertex = [](int turn, int number)
  { return vtkIdType(turn) * NumberOfBeams + number; };
  this->Triangles.push_back({ getVertex(11, 14), getVertex(12, 14), getVertex(11, 15) });
  this->ExpectBreach("bridge");
  this->Promise.Ideal = nullptr;
  EXPECT_EQ(this->Judge().GetNumberOfBreaches("bridge"), 0u);
}

TEST_F(MapJudgeOfDamage, SeesASpeckleThatIsNeitherKeptNorCounted)
{
  this->BringNearer({ Inside });
  this->Promise.MaximumSpeckleSize = 1;
  this->ExpectBreach("bound");
  this->Promise.KeepSpeckles = false;
  this->ExpectBreach("speckle");
  EXPECT_EQ(this->Judge().GetNumberOfBreaches("bound"), 0u);
  this->AddValue<vtkIntArray>("NumberOfReturnsOnSpeckles", 1.0);
  this->ExpectBreach("speckle");
  this->AddNumbers("SpeckleBeamIds", { Inside });
  this->AddValue<vtkIntArray>(
    "NumberOfReturnsOnPatches", static_cast<double>(this->Scan->GetNumberOfPoints() - 1));
  this->ExpectLawful();
}

TEST_F(MapJudgeOfDamage, SeesASpeckleThatDoesNotStandOut)
{
  this->Promise.MaximumSpeckleSize = 1;
  this->AddValue<vtkIntArray>("NumberOfReturnsOnSpeckles", 1.0);
  this->AddNumbers("SpeckleBeamIds", { Inside });
  this->ExpectBreach("speckle");
}

TEST_F(MapJudgeOfDamage, SeesASpeckleWithoutAPlaneAroundIt)
{
  constexpr double Height = 0.08;
  this->Promise.MaximumSpeckleSize = 1;
  this->AddValue<vtkIntArray>("NumberOfReturnsOnSpeckles", 1.0);
  this->AddNumbers("SpeckleBeamIds", { Inside });
  this->BringNearer({ Inside }, Height);
  EXPECT_EQ(this->Judge().GetNumberOfBreaches("speckle"), 0u);
  constexpr int Beside = Inside + NumberOfBeams;
  this->BringNearer({ Inside, Beside - 1, Beside, Beside + 1 }, Height);
  this->ExpectBreach("speckle");
}

TEST_F(MapJudgeOfDamage, SeesAHoleBehindASpeckle)
{
  this->BringNearer({ Inside });
  this->Promise.MaximumSpeckleSize = 1;
  this->Promise.KeepSpeckles = false;
  this->AddValue<vtkIntArray>("NumberOfReturnsOnSpeckles", 1.0);
  this->AddNumbers("SpeckleBeamIds", { Inside });
  EXPECT_EQ(this->Judge().GetNumberOfBreaches("hole"), 0u);
  const auto isAtSpeckle = [](const Triangle& triangle)
  { return std::find(triangle.begin(), triangle.end(), Inside) != triangle.end(); };
  this->Triangles.erase(std::remove_if(this->Triangles.begin(), this->Triangles.end(), isAtSpeckle),
    this->Triangles.end());
  this->ExpectBreach("hole");
}

TEST_F(MapJudgeOfDamage, SeesAThingThatIsTooLargeForASpeckle)
{
  this->BringNearer({ Inside, Inside + 1 + NumberOfBeams });
  this->Promise.MaximumSpeckleSize = 1;
  this->Promise.KeepSpeckles = false;
  this->AddValue<vtkIntArray>("NumberOfReturnsOnSpeckles", 2.0);
  this->AddNumbers("SpeckleBeamIds", { Inside, Inside + 1 + NumberOfBeams });
  this->ExpectBreach("speckle");
  this->Promise.MaximumSpeckleSize = 2;
  EXPECT_EQ(this->Judge().GetNumberOfBreaches("speckle"), 0u);
}
