// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fixtures/SceneFixtures.h"

#include "vtkLMS3DScanFilter.h"
#include "vtkLMS3DSurfaceReconstructionFilter.h"

#include <vtkCellArray.h>
#include <vtkCommand.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkPoints.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

struct BadProperty
{
  const char* Name;
  void (*Set)(vtkLMS3DScanFilter*);
  /// What the error must speak of.
  const char* Word;
};

void PrintTo(const BadProperty& property, std::ostream* os)
{
  *os << property.Name;
}

const BadProperty BadProperties[] = {
  { "PositionNaN", [](vtkLMS3DScanFilter* s) { s->SetPosition(0.0, NaN, 0.0); }, "Position" },
  { "PositionInfinite", [](vtkLMS3DScanFilter* s) { s->SetPosition(Infinity, 0.0, 0.0); },
    "Position" },
  { "PositionAbsurd", [](vtkLMS3DScanFilter* s) { s->SetPosition(0.0, 0.0, 1e19); }, "Position" },
  { "OrientationNaN", [](vtkLMS3DScanFilter* s) { s->SetOrientation(NaN, 0.0, 0.0); },
    "Orientation" },
  { "AlphaReversed", [](vtkLMS3DScanFilter* s) { s->SetAlphaRange(10.0, -10.0); }, "AlphaRange" },
  { "AlphaEmpty", [](vtkLMS3DScanFilter* s) { s->SetAlphaRange(10.0, 10.0); }, "AlphaRange" },
  { "AlphaBeyondPole", [](vtkLMS3DScanFilter* s) { s->SetAlphaRange(-90.0, 90.5); }, "AlphaRange" },
  { "AlphaNaN", [](vtkLMS3DScanFilter* s) { s->SetAlphaRange(NaN, 10.0); }, "AlphaRange" },
  { "AlphaResolutionZero", [](vtkLMS3DScanFilter* s) { s->SetAlphaResolution(0); },
    "AlphaResolution" },
  { "BetaReversed", [](vtkLMS3DScanFilter* s) { s->SetBetaRange(90.0, 0.0); }, "BetaRange" },
  { "BetaEmpty", [](vtkLMS3DScanFilter* s) { s->SetBetaRange(90.0, 90.0); }, "BetaRange" },
  { "BetaMoreThanACircle", [](vtkLMS3DScanFilter* s) { s->SetBetaRange(0.0, 361.0); },
    "BetaRange" },
  { "BetaInfinite", [](vtkLMS3DScanFilter* s) { s->SetBetaRange(-Infinity, 0.0); }, "BetaRange" },
  { "BetaResolutionNegative", [](vtkLMS3DScanFilter* s) { s->SetBetaResolution(-3); },
    "BetaResolution" },
  { "TooManyBeams",
    [](vtkLMS3DScanFilter* s)
    {
      s->SetAlphaResolution(50000);
      s->SetBetaResolution(50000);
    },
    "at most 2147483647" },
  { "MinimumNegative", [](vtkLMS3DScanFilter* s) { s->SetMinimumRange(-1.0); }, "MinimumRange" },
  { "MinimumNaN", [](vtkLMS3DScanFilter* s) { s->SetMinimumRange(NaN); }, "MinimumRange" },
  { "MinimumAboveMaximum", [](vtkLMS3DScanFilter* s) { s->SetMinimumRange(81.0); },
    "MinimumRange" },
  { "MaximumZero", [](vtkLMS3DScanFilter* s) { s->SetMaximumRange(0.0); }, "MaximumRange" },
  { "MaximumNaN", [](vtkLMS3DScanFilter* s) { s->SetMaximumRange(NaN); }, "MaximumRange" },
};

class EachBadProperty : public testing::TestWithParam<BadProperty>
{
};

void ExpectError(vtkLMS3DScanFilter* scan, const std::string& word)
{
  const std::string error = UpdateAndGetError(scan);
  EXPECT_NE(error.find(word), std::string::npos) << error;
  EXPECT_EQ(scan->GetErrorCode(), vtkErrorCode::UserError);
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(scan->GetRangeImage()->GetNumberOfPoints(), 0);
}

void ExpectBadScene(vtkDataObject* scene, const std::string& word)
{
  vtkNew<vtkLMS3DScanFilter> scan;
  scan->SetInputDataObject(scene);
  for (int method = 0; method < vtkLMS3DScanFilter::GetNumberOfIntersectionMethods(); ++method)
  {
    scan->SetIntersectionMethod(method);
    ExpectError(scan, word);
  }
}
} // namespace

TEST_P(EachBadProperty, GivesAnErrorAndEmptyOutputsAndRecovers)
{
  vtkNew<vtkLMS3DScanFilter> good;
  good->SetInputDataObject(MakeBall(1.0, 8));
  good->SetAlphaResolution(9);
  good->SetBetaResolution(8);
  good->Update();
  ASSERT_EQ(good->GetOutput()->GetNumberOfPoints(), 72);

  // The outputs of the good run must not survive.
  GetParam().Set(good);
  ExpectError(good, GetParam().Word);
}

INSTANTIATE_TEST_SUITE_P(LMS3DScanFilter, EachBadProperty, testing::ValuesIn(BadProperties),
  [](const auto& property) { return property.param.Name; });

TEST(LMS3DScanFilterErrors, AnUnknownMethodChangesNothing)
{
  for (int method : { -1, vtkLMS3DScanFilter::GetNumberOfIntersectionMethods(), 17 })
  {
    vtkNew<vtkLMS3DScanFilter> scan;
    scan->SetIntersectionMethodToFast();
    const vtkMTimeType time = scan->GetMTime();
    vtkNew<vtkTest::ErrorObserver> observer;
    scan->AddObserver(vtkCommand::ErrorEvent, observer);
    scan->SetIntersectionMethod(method);
    const std::string error = observer->GetErrorMessage();
    EXPECT_NE(error.find("IntersectionMethod " + std::to_string(method) +
                ": must be from 0 (Exact)"
                " to 4"),
      std::string::npos)
      << error;
    EXPECT_EQ(scan->GetIntersectionMethod(), vtkLMS3DScanFilter::FAST);
    EXPECT_EQ(scan->GetMTime(), time);
  }
}

TEST(LMS3DScanFilterErrors, RecoverWhenThePropertyIsRepaired)
{
  vtkNew<vtkLMS3DScanFilter> scan;
  scan->SetInputDataObject(MakeBall(1.0, 8));
  scan->SetAlphaResolution(0);
  ExpectError(scan, "AlphaResolution");
  scan->SetAlphaResolution(9);
  EXPECT_EQ(UpdateAndGetError(scan), "");
  EXPECT_EQ(scan->GetErrorCode(), vtkErrorCode::NoError);
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 9 * 360);
}

TEST(LMS3DScanFilterErrors, AreReportedOnceForEachChange)
{
  vtkNew<vtkPolyData> empty;
  vtkNew<vtkLMS3DScanFilter> scan;
  scan->SetInputDataObject(empty);
  EXPECT_EQ(UpdateAllAndCountErrors(scan), 1);
  EXPECT_EQ(UpdateAllAndCountErrors(scan), 0);
  EXPECT_EQ(scan->GetErrorCode(), vtkErrorCode::UserError);
  scan->SetPosition(1.0, 0.0, 0.0);
  EXPECT_EQ(UpdateAllAndCountErrors(scan), 1);
  empty->Modified();
  EXPECT_EQ(UpdateAllAndCountErrors(scan), 1);
}

TEST(LMS3DScanFilterErrors, AreNotRepeatedByAMapOfTheScan)
{
  vtkNew<vtkPolyData> empty;
  vtkNew<vtkLMS3DScanFilter> scan;
  scan->SetInputDataObject(empty);
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> map;
  map->SetInputConnection(scan->GetOutputPort());
  EXPECT_NE(UpdateAndGetError(scan), "");
  EXPECT_EQ(UpdateAllAndCountErrors(map), 0);
  EXPECT_EQ(map->GetErrorCode(), vtkErrorCode::NoError);
  EXPECT_EQ(map->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(LMS3DScanFilterErrors, ASceneWithoutPolygons)
{
  vtkNew<vtkPolyData> empty;
  ExpectBadScene(empty, "no polygons");

  vtkSmartPointer<vtkPolyData> lines = MakeFloor(1.0, -1.0);
  lines->SetLines(lines->GetPolys());
  vtkNew<vtkCellArray> none;
  lines->SetPolys(none);
  ExpectBadScene(lines, "no polygons");
}

TEST(LMS3DScanFilterErrors, ASceneWithoutAFinitePolygon)
{
  for (double bad : { NaN, Infinity, -Infinity, 1e19 })
  {
    ExpectBadScene(MakePolygon({ { 0, 0, 1 }, { 1, 0, bad }, { 0, 1, 1 } }), "not finite");
  }
}

TEST(LMS3DScanFilterErrors, ABadPointThatNoCellUsesIsNone)
{
  vtkSmartPointer<vtkPolyData> ball = MakeBall(1.0, 8);
  ball->GetPoints()->InsertNextPoint(NaN, Infinity, 0.0);
  vtkNew<vtkLMS3DScanFilter> scan;
  scan->SetInputDataObject(ball);
  EXPECT_EQ(UpdateAndGetError(scan), "");
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 361 * 360);
}

TEST(LMS3DScanFilterErrors, ACellWithAPointThatIsNotThere)
{
  vtkSmartPointer<vtkPolyData> ball = MakeBall(1.0, 8);
  const vtkIdType corners[3] = { 0, 1, 100000 };
  ball->GetPolys()->InsertNextCell(3, corners);
  ball->Modified();
  ExpectBadScene(ball, "uses point 100000");
}

TEST(LMS3DScanFilterErrors, APolygonThatCrossesItselfIsFilledWithAWarning)
{
  vtkNew<vtkLMS3DScanFilter> scan;
  // A star that crosses itself.
  scan->SetInputDataObject(
    MakePolygon({ { 0, 3, 1 }, { 2, -3, 1 }, { -3, 1, 1 }, { 3, 1, 1 }, { -2, -3, 1 } }));
  vtkNew<vtkTest::ErrorObserver> observer;
  scan->AddObserver(vtkCommand::WarningEvent, observer);
  for (int method = 0; method < vtkLMS3DScanFilter::GetNumberOfIntersectionMethods(); ++method)
  {
    scan->SetIntersectionMethod(method);
    EXPECT_EQ(UpdateAndGetError(scan), "");
    EXPECT_NE(observer->GetWarningMessage().find("cross themselves: 1."), std::string::npos);
    EXPECT_GT(scan->GetOutput()->GetNumberOfPoints(), 0);
    observer->Clear();
  }
}

// The sides of a triangle bow inwards, so few corners are convex.
TEST(LMS3DScanFilterErrors, APolygonOfTooManyCornersIsNamedAndNothingElseIsLost)
{
  constexpr int count = 30000;
  std::vector<Point> corners;
  for (int i = 0; i < count; ++i)
  {
    const double t = 3.0 * i / count;
    const int side = static_cast<int>(t);
    const double along = t - side;
    const double angle = 2.0 * vtkMath::Pi() * side / 3.0;
    const double next = angle + 2.0 * vtkMath::Pi() / 3.0;
    const double share = 1.0 - 1.2 * along * (1.0 - along);
    corners.push_back({ share * (std::cos(angle) * (1.0 - along) + std::cos(next) * along),
      share * (std::sin(angle) * (1.0 - along) + std::sin(next) * along), 0.5 });
  }
  vtkSmartPointer<vtkPolyData> ball = MakeBall(2.0, 8);
  vtkNew<vtkLMS3DScanFilter> scan;
  scan->SetInputDataObject(Join(ball, MakePolygon(corners)));
  vtkNew<vtkTest::ErrorObserver> observer;
  scan->AddObserver(vtkCommand::WarningEvent, observer);
  EXPECT_EQ(UpdateAndGetError(scan), "");
  EXPECT_NE(observer->GetWarningMessage().find("cross themselves: 1. The first is cell " +
              std::to_string(ball->GetNumberOfCells()) + ". "),
    std::string::npos)
    << observer->GetWarningMessage();
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 361 * 360);
}

TEST(LMS3DScanFilterErrors, APolygonWithoutAreaIsNone)
{
  vtkSmartPointer<vtkPolyData> scene =
    Join(MakeBall(1.0, 8), MakePolygon({ { 0, 0, 2 }, { 1, 0, 2 }, { 2, 0, 2 }, { 1, 0, 2 } }));
  vtkNew<vtkLMS3DScanFilter> scan;
  scan->SetInputDataObject(scene);
  EXPECT_EQ(UpdateAndGetError(scan), "");
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 361 * 360);
}

TEST(LMS3DScanFilterErrors, PolygonsThatAreHardToCut)
{
  const double thin = 1e-7;
  const std::vector<Point> polygons[] = {
    { { 5, -5, -5 }, { 5, 5, -5 }, { 5, 5, -5 }, { 5, 5, 5 }, { 5, -5, 5 } }, // a point twice
    { { 5, -5, -5 }, { 5, 5, -5 }, { 5, 5, 5 }, { 5, -5, 5 }, { 5, -5, -5 } }, // closed by hand
    { { 5, -5, -5 }, { 5, 5, -5 }, { 5, 5, 0 }, { 5, 5, 5 }, { 5, -5, 5 } }, // a point on a side
    { { 5, -20, -thin }, { 5, 20, -thin }, { 5, 20, thin }, { 5, -20, thin } }, // very thin
  };
  for (const std::vector<Point>& polygon : polygons)
  {
    vtkNew<vtkLMS3DScanFilter> scan;
    scan->SetInputDataObject(MakePolygon(polygon));
    scan->SetAlphaRange(0.0, 0.0);
    scan->SetAlphaResolution(1);
    scan->SetBetaRange(-40.0, 40.0);
    scan->SetBetaResolution(81);
    EXPECT_EQ(UpdateAndGetError(scan), "");
    EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 81);
  }
}

TEST(LMS3DScanFilterErrors, AHoleThatABridgeJoinsToTheRim)
{
  vtkNew<vtkLMS3DScanFilter> scan;
  scan->SetInputDataObject(MakePolygon({ { 5, -9, -9 }, { 5, 9, -9 }, { 5, 9, 9 }, { 5, -9, 9 },
    { 5, -9, -9 }, { 5, -1, -1 }, { 5, -1, 1 }, { 5, 1, 1 }, { 5, 1, -1 }, { 5, -1, -1 } }));
  scan->SetAlphaRange(0.0, 0.0);
  scan->SetAlphaResolution(1);
  scan->SetBetaRange(-30.0, 30.0);
  scan->SetBetaResolution(61);
  EXPECT_EQ(UpdateAndGetError(scan), "");
  // The window is seen under atan(1 / 5), 11.3 degrees, to either side.
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 61 - 23);
}
