// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/lms3dAngle.h"
#include "Geometry/lms3dVector.h"
#include "Meshes/lms3dVRMLSpine.h"

#include "VRML/VRMLFixtures.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{

using VRMLGeometry = VRMLScene;
using Texts = std::vector<std::string>;
using Bounds = std::array<double, 6>;

std::string Shape(const std::string& geometry)
{
  return "Shape { geometry " + geometry + " }\n";
}
} // namespace

TEST_F(VRMLGeometry, HasExactBoxes)
{
  const lms3dScene scene = this->Read(Shape("Box { size 2 4 6 }"));
  EXPECT_EQ(GetTriangles(scene).size(), 12u);
  EXPECT_DOUBLE_EQ(GetVolume(scene), 48.0);
  EXPECT_EQ(GetBounds(scene), (Bounds{ -1, -2, -3, 1, 2, 3 }));
}

TEST_F(VRMLGeometry, KeepsTheChordErrorOfSpheres)
{
  for (double error : { 0.1, 0.01, 0.0003 })
  {
    this->Options.ChordError = error;
    const lms3dScene scene = this->Read(Shape("Sphere { radius 2 }"));
    EXPECT_EQ(GetBounds(scene), (Bounds{ -2, -2, -2, 2, 2, 2 }));
    double nearest = 2.0;
    for (const auto& [a, b, c] : GetTriangles(scene))
    {
      EXPECT_NEAR(std::sqrt(lms3dDot(a, a)), 2.0, 1e-14);
      const lms3dVector normal =
        lms3dNormalize(lms3dCross(lms3dSubtract(b, a), lms3dSubtract(c, a)));
      nearest = std::min(nearest, lms3dDot(a, normal));
    }
    EXPECT_GE(nearest, 2.0 - error);
    EXPECT_LE(nearest, 2.0 - 0.5 * error);
  }
}

TEST_F(VRMLGeometry, KeepsTheChordErrorInTheWorld)
{
  const auto count = [this](const std::string& text)
  { return GetTriangles(this->Read(text)).size(); };
  EXPECT_EQ(count("Transform { scale 10 10 10 children " + Shape("Cylinder { radius 0.1 }") + "}"),
    count(Shape("Cylinder { radius 1 }")));
  EXPECT_LT(count(Shape("Cylinder { radius 0.1 }")), count(Shape("Cylinder { radius 1 }")));
}

TEST_F(VRMLGeometry, BoundsTheSidesOfHugeCircles)
{
  const lms3dScene scene = this->Read(Shape("Cylinder { radius 1e9 }"));
  EXPECT_EQ(GetTriangles(scene).size(), 2u * 2048 + 2u * 2046);
  ASSERT_EQ(scene.Messages.size(), 1u);
  EXPECT_EQ(scene.Messages[0].Severity, lms3dMessage::MESSAGE_WARNING);
  EXPECT_NE(scene.Messages[0].Text.find("ChordError"), std::string::npos);
}

TEST_F(VRMLGeometry, HasThePartsOfConesAndCylinders)
{
  const auto area = [this](const std::string& geometry)
  { return GetArea(this->Read(Shape(geometry))); };
  EXPECT_NEAR(area("Cone { bottomRadius 3 height 4 bottom FALSE }"), 15 * lms3dPi, 0.1);
  EXPECT_NEAR(area("Cone { bottomRadius 3 height 4 side FALSE }"), 9 * lms3dPi, 0.1);
  EXPECT_NEAR(area("Cylinder { radius 2 height 5 top FALSE bottom FALSE }"), 20 * lms3dPi, 0.1);
  EXPECT_NEAR(area("Cylinder { radius 2 side FALSE bottom FALSE }"), 4 * lms3dPi, 0.1);
  EXPECT_NEAR(GetVolume(this->Read(Shape("Cylinder { radius 2 height 5 }"))), 20 * lms3dPi, 0.1);
  EXPECT_NEAR(GetVolume(this->Read(Shape("Cone { bottomRadius 3 height 4 }"))), 12 * lms3dPi, 0.1);
}

TEST_F(VRMLGeometry, ColoursTriangles)
{
  const std::string square = "coord Coordinate { point [ 0 0 0, 1 0 0, 1 1 0, 0 1 0 ] } "
                             "coordIndex [ 0 1 2 -1 0 2 3 -1 ] ";
  const std::string colors = "color Color { color [ 1 0 0, 0 1 0, 0 0 1, 1 1 1 ] } ";
  using Colors = std::vector<lms3dColor>;
  const auto read = [&](const std::string& more) {
    return this->Read(Shape("IndexedFaceSet { " + square + more + "}")).Shapes.at(0).Mesh->Colors;
  };
  EXPECT_EQ(read(""), Colors());
  EXPECT_EQ(read(colors), (Colors{ { 85, 85, 85 }, { 170, 85, 170 } }));
  EXPECT_EQ(
    read(colors + "colorIndex [ 0 0 0 -1 1 1 1 -1 ]"), (Colors{ { 255, 0, 0 }, { 0, 255, 0 } }));
  EXPECT_EQ(read(colors + "colorPerVertex FALSE"), (Colors{ { 255, 0, 0 }, { 0, 255, 0 } }));
  EXPECT_EQ(read(colors + "colorPerVertex FALSE colorIndex [ 3 2 ]"),
    (Colors{ { 255, 255, 255 }, { 0, 0, 255 } }));
}

TEST_F(VRMLGeometry, LosesSingleFacesOnly)
{
  const lms3dScene scene =
    this->Read("Shape { geometry IndexedFaceSet { coord Coordinate {\n"
               "point [ 0 0 0, 1 0 0, 1 1 0, 0 1 0, 0 nan 0 ] }\n"
               "coordIndex [ 0 1 2 3 -1 0 1 9 -1 0 -5 2 -1 0 1 4 -1 0 1 -1 3 3 3 -1 ] } }");
  EXPECT_DOUBLE_EQ(GetArea(scene), 1.0);
  EXPECT_EQ(scene.Shapes[0].Mesh->Points.size(), 4u);
  EXPECT_EQ(GetMessages(scene),
    (Texts{ "warning 3: \"nan\" is not a finite number",
      "error 2: 2 faces of an IndexedFaceSet are lost: coordIndex is out of "
      "range, the Coordinate has 5 points",
      "error 2: 1 face of an IndexedFaceSet is lost: a point is not finite or too far away" }));
}

TEST_F(VRMLGeometry, CopiesOnlyThePointsOfAShape)
{
  std::string points;
  for (int i = 0; i < 1000; ++i)
  {
    points += std::to_string(i) + " 0 0, " + std::to_string(i) + " 1 0, ";
  }
  const std::string first = Shape("IndexedFaceSet { coord DEF C Coordinate { point [ " + points +
    " ] } coordIndex [ 0 2 3 1 ] }");
  const lms3dScene scene =
    this->Read(first + Shape("IndexedFaceSet { coord USE C coordIndex [ 1996 1998 1999 1997 ] }"));
  ASSERT_EQ(scene.Shapes.size(), 2u);
  EXPECT_EQ(scene.Shapes[1].Mesh->Points.size(), 4u);
  EXPECT_EQ(GetBounds(scene), (Bounds{ 0, 0, 0, 999, 1, 0 }));
  EXPECT_DOUBLE_EQ(GetArea(scene), 2.0);
}

TEST_F(VRMLGeometry, HasElevationGrids)
{
  const std::string grid =
    "ElevationGrid { xDimension 3 zDimension 2 xSpacing 2 zSpacing 3 height ";
  const lms3dScene scene = this->Read(Shape(grid + "[ 1 1 1 1 1 1 ] }"));
  EXPECT_EQ(GetBounds(scene), (Bounds{ 0, 1, 0, 4, 1, 3 }));
  EXPECT_GT(GetVolume(scene), 0.0);
  const lms3dScene part = this->Read(Shape(grid + "[ 5 5 5 5 5 nan ] }"));
  EXPECT_DOUBLE_EQ(GetArea(part), 6.0);
  EXPECT_EQ(GetBounds(part)[1], 5.0);
  const lms3dScene lost = this->Read(Shape(grid + "[ 5 5 5 5 5 ] }"));
  EXPECT_EQ(GetMessages(lost), Texts{ "error 2: an ElevationGrid has 5 heights in place of 6" });
}

TEST(VRMLSpine, RotatesTheFrameOfAStraightSpineByTheSmallestAngle)
{
  const std::vector<lms3dSpineFrame> frames =
    lms3dMakeSpineFrames({ { 0, 0, 0 }, { 0, 0, 1 }, { 0, 0, 1 }, { 0, 0, 3 } });
  ASSERT_EQ(frames.size(), 4u);
  for (const lms3dSpineFrame& frame : frames)
  {
    EXPECT_EQ(frame.X, (lms3dVector{ 1, 0, 0 }));
    EXPECT_EQ(frame.Y, (lms3dVector{ 0, 0, 1 }));
    EXPECT_EQ(frame.Z, (lms3dVector{ 0, -1, 0 }));
  }
}

TEST(VRMLSpine, KeepsItsSideThroughBothBends)
{
  const std::vector<lms3dSpineFrame> frames =
    lms3dMakeSpineFrames({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 2, 1, 0 }, { 3, 1, 0 } });
  for (const lms3dSpineFrame& frame : frames)
  {
    EXPECT_NEAR(frame.Z[2], frames[0].Z[2], 1e-15);
    EXPECT_NEAR(lms3dDot(frame.X, frame.Y), 0.0, 1e-15);
  }
}

TEST(VRMLSpine, HasOneFrameForBothEndsOfAClosedSpine)
{
  const std::vector<lms3dSpineFrame> frames =
    lms3dMakeSpineFrames({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 0, 1 }, { 0, 0, 1 }, { 0, 0, 0 } });
  EXPECT_EQ(frames.front().X, frames.back().X);
  EXPECT_EQ(frames.front().Y, frames.back().Y);
  EXPECT_EQ(frames.front().Y, lms3dNormalize({ 1, 0, -1 }));
}

TEST_F(VRMLGeometry, HasExtrusionsWithOrientationsAndScales)
{
  const lms3dScene turned =
    this->Read(Shape("Extrusion { spine [ 0 0 0, 0 2 0 ] orientation 0 1 0 0.7853981633974483 }"));
  EXPECT_NEAR(GetVolume(turned), 8.0, 1e-12);
  EXPECT_NEAR(GetBounds(turned)[3], std::sqrt(2.0), 1e-12);
  const lms3dScene pyramid =
    this->Read(Shape("Extrusion { spine [ 0 0 0, 0 3 0 ] scale [ 1 1, 0 0 ] }"));
  EXPECT_NEAR(GetVolume(pyramid), 4.0, 1e-12);
  EXPECT_EQ(GetTriangles(pyramid).size(), 6u);
}

TEST_F(VRMLGeometry, RefusesExtrusionsBeyondTheLimit)
{
  std::string points;
  for (int i = 0; i < 2000; ++i)
  {
    points += std::to_string(i) + " 0 ";
  }
  this->Options.MaximumNumberOfTriangles = 1000;
  const lms3dScene scene =
    this->Read(SquareShape + Shape("Extrusion { crossSection [ " + points + "] }"));
  EXPECT_DOUBLE_EQ(GetArea(scene), 1.0);
  ASSERT_EQ(scene.Messages.size(), 1u);
  EXPECT_NE(scene.Messages[0].Text.find("MaximumNumberOfTriangles"), std::string::npos);
}

TEST_F(VRMLGeometry, RefusesShapesBeyondTheMemory)
{
  std::string uses;
  for (int i = 0; i < 100; ++i)
  {
    uses += "USE S ";
  }
  const std::string text = "DEF S " + std::string(SquareShape) + uses;
  EXPECT_DOUBLE_EQ(GetArea(this->Read(text)), 101.0);
  this->Options.MaximumMemory = 20'000;
  const lms3dScene scene = this->Read(text);
  EXPECT_GT(scene.Shapes.size(), 10u);
  EXPECT_LT(scene.Shapes.size(), 90u);
  ASSERT_EQ(scene.Messages.size(), 1u);
  EXPECT_NE(scene.Messages[0].Text.find("MaximumMemory"), std::string::npos);
}
