// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/lms3dAngle.h"
#include "Model/lms3dTransform.h"

#include "VRML/VRMLFixtures.h"

#include <cmath>
#include <string>

namespace
{

using VRMLTransforms = VRMLScene;

void ExpectNear(const lms3dPoint& a, const lms3dPoint& b)
{
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(a[i], b[i], 1e-14);
  }
}
} // namespace

TEST(Transform, MapsPoints)
{
  ExpectNear(lms3dTransform::Translation({ 1, 2, 3 }).Apply({ 1, 1, 1 }), { 2, 3, 4 });
  ExpectNear(lms3dTransform::Scale({ 2, 3, -4 }).Apply({ 1, 1, 1 }), { 2, 3, -4 });
  ExpectNear(lms3dTransform::Rotation({ 0, 0, 7, lms3dPi / 2 }).Apply({ 1, 0, 5 }), { 0, 1, 5 });
  ExpectNear(
    lms3dTransform::Rotation({ 1, 1, 1, 2 * lms3dPi / 3 }).Apply({ 1, 2, 3 }), { 3, 1, 2 });
  ExpectNear(lms3dTransform::Rotation({ 0, 0, 0, 1 }).Apply({ 1, 2, 3 }), { 1, 2, 3 });
  ExpectNear((lms3dTransform::Translation({ 1, 0, 0 }) * lms3dTransform::Scale({ 2, 2, 2 }))
               .Apply({ 1, 1, 1 }),
    { 3, 2, 2 });
}

TEST(Transform, BoundsItsLargestScale)
{
  const lms3dTransform turn = lms3dTransform::Rotation({ 1, 2, 3, 0.7 });
  EXPECT_NEAR((turn * lms3dTransform::Scale({ 3, 3, 3 })).GetLargestScale(), 3.0, 1e-12);
  EXPECT_NEAR((turn * lms3dTransform::Scale({ 1, -5, 2 })).GetLargestScale(), 5.0, 1e-12);
  EXPECT_GE((lms3dTransform::Scale({ 1, 5, 2 }) * turn).GetLargestScale(), 5.0 - 1e-12);
  EXPECT_EQ(lms3dTransform::Scale({ 0, 0, 0 }).GetLargestScale(), 0.0);
}

TEST(Transform, DetectsMirrorsAndInfinities)
{
  EXPECT_FALSE(lms3dTransform().IsMirror());
  EXPECT_TRUE(lms3dTransform::Scale({ 1, 1, -1 }).IsMirror());
  EXPECT_FALSE(lms3dTransform::Scale({ 1, -1, -1 }).IsMirror());
  EXPECT_TRUE(lms3dTransform::Scale({ 1e200, 1, 1 }).IsFinite(1e100));
  EXPECT_FALSE(lms3dTransform::Scale({ 1e200, 1, 1 }).IsFinite(1e200));
  EXPECT_FALSE(lms3dTransform::Translation({ 0, std::nan(""), 0 }).IsFinite(1.0));
}

// Computed by hand: (p - c) is rotated to the axes of the scale, scaled, rotated back, rotated,
// moved.
TEST_F(VRMLTransforms, HaveTheOrderOfTheStandard)
{
  const lms3dScene scene = this->Read("Transform { center 1 0 0 rotation 0 0 1 1.5707963267948966\n"
                                      "scale 2 1 1 scaleOrientation 0 0 1 0.7853981633974483\n"
                                      "translation 10 20 30 children " +
    std::string(SquareShape) + "}");
  ASSERT_EQ(scene.Shapes.size(), 1u);
  const lms3dTransform& toWorld = scene.Shapes[0].ToWorld;
  ExpectNear(toWorld.Apply({ 1, 0, 0 }), { 11, 20, 30 });
  ExpectNear(toWorld.Apply({ 2, 0, 0 }), { 10.5, 21.5, 30 });
  ExpectNear(toWorld.Apply({ 1, 1, 0 }), { 9.5, 20.5, 30 });
}

TEST_F(VRMLTransforms, NestAndShear)
{
  const lms3dScene scene = this->Read(
    "Transform { scale 2 1 1 children Transform { rotation 0 0 1 0.7853981633974483 children " +
    std::string(SquareShape) + "} }");
  EXPECT_NEAR(GetArea(scene), 2.0, 1e-12);
  const double root = std::sqrt(0.5);
  ExpectNear(scene.Shapes[0].ToWorld.Apply({ 1, 0, 0 }), { 2 * root, root, 0 });
  ExpectNear(scene.Shapes[0].ToWorld.Apply({ 0, 1, 0 }), { -2 * root, root, 0 });
}

TEST_F(VRMLTransforms, LoseShapesThatAreNotFinite)
{
  const lms3dScene scene = this->Read("Transform { translation 1e400 0 0 children\n" +
    std::string(SquareShape) + "}\nTransform { scale 1e200 1 1 children Transform {\n" +
    "scale 1e200 1 1 children\n" + SquareShape + "} }\n" + SquareShape);
  EXPECT_DOUBLE_EQ(GetArea(scene), 1.0);
  ASSERT_EQ(scene.Messages.size(), 3u);
  EXPECT_EQ(scene.Messages[0].Severity, lms3dMessage::MESSAGE_WARNING);
  EXPECT_EQ(scene.Messages[1].Line, 3u);
  EXPECT_EQ(scene.Messages[2].Line, 7u);
}
