// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "VRML/VRMLFixtures.h"

#include <string>
#include <vector>

namespace
{
using VRMLPrototypes = VRMLScene;
using Texts = std::vector<std::string>;
using Bounds = std::array<double, 6>;
} // namespace

TEST_F(VRMLPrototypes, TakeValuesOfTheInstanceOrElseDefaults)
{
  const lms3dScene scene = this->Read("PROTO P [ field SFVec3f s 1 1 1 field SFVec3f t 0 0 0 ] {"
                                      "  Transform { translation IS t children Shape {"
                                      "    geometry Box { size IS s } } } }\n"
                                      "P { } P { t 10 0 0 } P { s 2 2 2 t 20 0 0 }");
  EXPECT_EQ(GetMessages(scene), Texts());
  EXPECT_EQ(GetBounds(scene), (Bounds{ -0.5, -1, -1, 21, 1, 1 }));
  EXPECT_DOUBLE_EQ(GetArea(scene), 6 + 6 + 24);
}

TEST_F(VRMLPrototypes, EvaluateDefaultsInTheContextOfTheInstance)
{
  const lms3dScene scene =
    this->Read("PROTO Outer [ field SFVec3f s 1 2 3 ] {\n"
               "  PROTO Inner [ field SFNode g Box { size IS s } ] { Shape { geometry IS g } }\n"
               "  Group { children [ Inner { } ] } }\n"
               "Outer { s 2 4 6 }");
  EXPECT_EQ(GetMessages(scene), Texts());
  EXPECT_DOUBLE_EQ(GetArea(scene), 88.0);
}

TEST_F(VRMLPrototypes, ShowOnlyTheFirstNode)
{
  const lms3dScene scene = this->Read(
    std::string("PROTO P [ ] { ") + SquareShape + " Shape { geometry Box { } } } P { } P { }");
  EXPECT_EQ(GetMessages(scene), Texts());
  EXPECT_DOUBLE_EQ(GetArea(scene), 2.0);
}

TEST_F(VRMLPrototypes, MayContainThemselvesInTheirFields)
{
  const std::string joint = "PROTO Joint [ field SFVec3f t 0 0 0 field MFNode c [ ] ] {"
                            "  Transform { translation IS t children IS c } }\n";
  const lms3dScene scene = this->Read(joint + "Joint { t 1 0 0 c [ Joint { t 1 0 0 c [ " +
    SquareShape + " Joint { t 1 0 0 c " + SquareShape + " } ] } ] }");
  EXPECT_EQ(GetMessages(scene), Texts());
  EXPECT_EQ(GetBounds(scene), (Bounds{ 2, 0, 0, 4, 1, 0 }));
}

TEST_F(VRMLPrototypes, MayNotContainThemselvesInTheirBody)
{
  const lms3dScene scene = this->Read("PROTO P [ field MFNode c [ ] ] { Group { children IS c } }\n"
                                      "DEF A P { c [ USE A " +
    std::string(SquareShape) + " ] }");
  EXPECT_EQ(GetMessages(scene), Texts{ "error 2: Group contains itself" });
  EXPECT_DOUBLE_EQ(GetArea(scene), 1.0);
}

TEST_F(VRMLPrototypes, ShareTheMeshOfANodeThatIsUsedAgain)
{
  const lms3dScene scene =
    this->Read("PROTO P [ ] { Shape { geometry Sphere { } } }\n"
               "DEF A P { } Transform { translation 5 0 0 children USE A }\n"
               "Transform { translation 9 0 0 rotation 0 1 0 1 children USE A }\n"
               "Transform { scale 9 9 9 children USE A }");
  ASSERT_EQ(scene.Shapes.size(), 4u);
  EXPECT_EQ(scene.Shapes[0].Mesh, scene.Shapes[1].Mesh);
  EXPECT_EQ(scene.Shapes[0].Mesh, scene.Shapes[2].Mesh);
  EXPECT_GT(scene.Shapes[3].Mesh->Points.size(), scene.Shapes[0].Mesh->Points.size());
}

TEST_F(VRMLPrototypes, ShareTheMeshOfABodyThatDoesNotDependOnTheInstance)
{
  const std::string body =
    "{ Shape { geometry IndexedFaceSet { ccw IS c coordIndex [ 0 1 2 ]"
    " coord Coordinate { point [ 0 0 0, 1 0 0, 0 1 0, 3 0 0 ] } color IS d } } }\n";
  const auto read = [&](std::string text, const std::string& is)
  {
    text.replace(text.find(is), is.size(), "");
    return this->Read("PROTO P [ field SFBool c TRUE field SFNode d NULL ] " + text +
      "P { } P { c FALSE d Color { color [ 1 0 0, 0 1 0, 0 0 1 ] } }");
  };
  std::string shared = body;
  shared.replace(shared.find("ccw IS c"), 8, "");
  const lms3dScene scene = read(shared, "color IS d");
  ASSERT_EQ(scene.Shapes.size(), 2u);
  EXPECT_EQ(scene.Shapes[0].Mesh, scene.Shapes[1].Mesh);
  for (const char* is : { "ccw IS c", "color IS d" })
  {
    const lms3dScene apart = read(body, is);
    ASSERT_EQ(apart.Shapes.size(), 2u);
    EXPECT_NE(apart.Shapes[0].Mesh, apart.Shapes[1].Mesh);
  }
}

TEST_F(VRMLPrototypes, DoNotShareAMeshWhoseCoordinatesDependOnTheInstance)
{
  const lms3dScene scene =
    this->Read("PROTO C [ field SFNode n NULL ] { Coordinate { point [ 0 0 0, 1 0 0, 0 1 0 ] } }\n"
               "PROTO D [ field MFVec3f p [ ] ] { Coordinate { point IS p } }\n"
               "PROTO E [ field SFNode n NULL ] { Shape { geometry IndexedFaceSet {"
               "  coordIndex [ 0 1 2 ] coord C { n Group { } } } } }\n"
               "PROTO F [ field MFVec3f p [ ] ] { Shape { geometry IndexedFaceSet {"
               "  coordIndex [ 0 1 2 ] coord D { p IS p } } } }\n"
               "E { } F { p [ 0 0 0, 2 0 0, 0 2 0 ] } F { p [ 0 0 0, 4 0 0, 0 4 0 ] }");
  EXPECT_EQ(GetMessages(scene), Texts());
  EXPECT_DOUBLE_EQ(GetArea(scene), 0.5 + 2 + 8);
}

TEST_F(VRMLPrototypes, ReportMissingFields)
{
  EXPECT_EQ(GetMessages(this->Read("PROTO P [ ] { Shape { geometry Box { size IS s } } }\nP { }")),
    Texts{ "error 2: IS s: PROTO P has no such field" });
  EXPECT_EQ(GetMessages(this->Read("Shape { geometry Box {\nsize IS s } }")),
    Texts{ "error 2: IS s is outside a PROTO" });
  EXPECT_EQ(GetMessages(this->Read("PROTO P [ ] { Group { } }\nP { x 1 }")),
    Texts{ "warning 3: P has no field \"x\"; it is skipped" });
}

TEST_F(VRMLPrototypes, KeepDefaultsOfFieldsThatAreEvents)
{
  const lms3dScene scene =
    this->Read("PROTO P [ eventIn SFVec3f s ] { Shape { geometry Box { size IS s } } } P { }");
  EXPECT_EQ(GetMessages(scene), Texts());
  EXPECT_DOUBLE_EQ(GetArea(scene), 24.0);
}

TEST_F(VRMLPrototypes, ComeFromOtherFiles)
{
  this->Write("PROTO A [ ] { Shape { geometry Box { } } }\n"
              "PROTO B [ field SFVec3f s 1 1 1 ] { Shape { geometry Box { size IS s } } }",
    "lib/boxes.wrl");
  this->Write("EXTERNPROTO C [ ] \"lib/boxes.wrl#B\"", "more.wrl");
  const std::string text =
    "EXTERNPROTO X [ field SFVec3f s ] [ \"none.wrl\" \"lib/boxes.wrl#B\" ]\n";
  EXPECT_DOUBLE_EQ(GetArea(this->Read(text + "X { s 2 2 2 } X { }")), 30.0);
  EXPECT_DOUBLE_EQ(GetArea(this->Read("EXTERNPROTO X [ ] \"lib/boxes.wrl\" X { }")), 24.0);
  EXPECT_DOUBLE_EQ(GetArea(this->Read("EXTERNPROTO X [ ] \"more.wrl#C\" X { }")), 6.0);
  EXPECT_EQ(
    GetMessages(this->Read("EXTERNPROTO X [ ] [ \"none.wrl\" \"more.wrl#D\" ]\nX { } X { }")),
    Texts{ "error 2: EXTERNPROTO X is lost: \"none.wrl\" does not exist or is not a regular file; "
           "\"more.wrl#D\" has no such PROTO" });
}
