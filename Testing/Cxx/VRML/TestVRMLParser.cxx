// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Grammar/lms3dVRMLContext.h"
#include "Grammar/lms3dVRMLNode.h"
#include "Grammar/lms3dVRMLParser.h"

#include "VRML/VRMLFixtures.h"

#include <string>
#include <vector>

namespace
{
struct Parsed
{
  explicit Parsed(const std::string& text, const lms3dVRMLOptions& options = {})
  {
    const lms3dProgressFunction progress = [](double) { return true; };
    lms3dVRMLContext context(options, progress);
    lms3dVRMLParser(text, this->Document, context).Parse();
    lms3dScene scene;
    scene.Messages = context.Messages.Take();
    this->Messages = GetMessages(scene);
  }

  const lms3dVRMLValue& GetValue(std::size_t root, const char* field) const
  {
    return lms3dFindField(this->Document.Roots.at(root)->Fields, field)->Value;
  }

  lms3dVRMLDocument Document;
  std::vector<std::string> Messages;
};

using Texts = std::vector<std::string>;
} // namespace

TEST(VRMLParser, KeepsValuesAsTheyAre)
{
  const Parsed parsed("IndexedFaceSet { coordIndex [ 0 1, 2 -1 ] ccw FALSE coord NULL }\n"
                      "Transform { translation 1 2.5 3 children [ ] }\n"
                      "WorldInfo { title \"a \\\" b\" info [ \"c\" \"d\" ] }\n");
  EXPECT_EQ(parsed.Messages, Texts());
  ASSERT_EQ(parsed.Document.Roots.size(), 3u);
  EXPECT_EQ(std::get<lms3dVRMLIntegers>(parsed.GetValue(0, "coordIndex")),
    (lms3dVRMLIntegers{ 0, 1, 2, -1 }));
  EXPECT_FALSE(std::get<bool>(parsed.GetValue(0, "ccw")));
  EXPECT_TRUE(std::get<lms3dVRMLNodes>(parsed.GetValue(0, "coord")).empty());
  EXPECT_EQ(
    std::get<lms3dVRMLReals>(parsed.GetValue(1, "translation")), (lms3dVRMLReals{ 1.0, 2.5, 3.0 }));
  EXPECT_TRUE(std::get<lms3dVRMLNodes>(parsed.GetValue(1, "children")).empty());
  EXPECT_EQ(std::get<lms3dVRMLStrings>(parsed.GetValue(2, "title")), lms3dVRMLStrings{ "a \" b" });
  EXPECT_EQ(std::get<lms3dVRMLStrings>(parsed.GetValue(2, "info")), (lms3dVRMLStrings{ "c", "d" }));
}

TEST(VRMLParser, UsesTheSameNodeAgain)
{
  const Parsed parsed("DEF A Group { } USE A DEF A Transform { } USE A");
  EXPECT_EQ(parsed.Messages, Texts());
  ASSERT_EQ(parsed.Document.Roots.size(), 4u);
  EXPECT_EQ(parsed.Document.Roots[1], parsed.Document.Roots[0]);
  EXPECT_EQ(parsed.Document.Roots[3], parsed.Document.Roots[2]);
  EXPECT_NE(parsed.Document.Roots[2], parsed.Document.Roots[0]);
}

TEST(VRMLParser, KeepsNodeNamesOfABodyApart)
{
  const Parsed parsed("DEF A Group { }\nPROTO P [ ] { Group { children [\n"
                      "USE A DEF B Group { } ] } }\nUSE B");
  EXPECT_EQ(parsed.Messages,
    (Texts{ "error 3: USE A: no earlier node has this name",
      "error 4: USE B: no earlier node has this name" }));
}

TEST(VRMLParser, FindsPrototypesOfOuterScopes)
{
  const Parsed parsed("PROTO P [ ] { Group { } }\n"
                      "PROTO Q [ ] { P { } }\nPROTO R [ ] { PROTO S [ ] { Q { } } S { } }\nS { }");
  EXPECT_EQ(parsed.Messages, Texts{ "warning 4: VRML97 has no node S; it is skipped" });
  EXPECT_EQ(parsed.Document.PrototypesByName.size(), 3u);
  EXPECT_EQ(parsed.Document.FirstPrototype->Name, "P");
}

TEST(VRMLParser, ReadsInterfaces)
{
  const Parsed parsed("PROTO P [ field SFFloat a 1 eventIn SFTime b eventOut SFBool c\n"
                      "  exposedField MFNode d [ Group { } ] field SFNode e NULL ] { Group { } }\n"
                      "EXTERNPROTO Q [ field SFFloat a eventIn SFTime b ] [ \"x\" \"y\" ]\n");
  EXPECT_EQ(parsed.Messages, Texts());
  const lms3dVRMLPrototype& p = parsed.Document.Prototypes[0];
  ASSERT_EQ(p.Interface.size(), 5u);
  EXPECT_EQ(std::get<lms3dVRMLIntegers>(p.Interface[0].Value), lms3dVRMLIntegers{ 1 });
  EXPECT_TRUE(std::holds_alternative<std::monostate>(p.Interface[1].Value));
  EXPECT_EQ(std::get<lms3dVRMLNodes>(p.Interface[3].Value).size(), 1u);
  EXPECT_NE(p.Body, nullptr);
  const lms3dVRMLPrototype& q = parsed.Document.Prototypes[1];
  EXPECT_TRUE(q.IsExternal);
  EXPECT_EQ(q.Urls, (lms3dVRMLStrings{ "x", "y" }));
}

TEST(VRMLParser, SkipsScriptsAndRoutes)
{
  const Parsed parsed("DEF S Script { url \"x\" field SFNode me USE S eventIn SFTime t IS u\n"
                      "  field MFFloat f [ 1 2 ] eventOut SFBool b }\nROUTE S.b TO T.set_x\n");
  EXPECT_EQ(parsed.Messages, Texts());
  EXPECT_EQ(parsed.Document.Roots.size(), 1u);
}

TEST(VRMLParser, ContinuesBehindAFault)
{
  const std::vector<std::pair<std::string, std::string>> faults = {
    { "}", "error 1: \"}\" is not expected here; it is skipped" },
    { "]", "error 1: \"]\" is not expected here; it is skipped" },
    { "7", "error 1: \"7\" is not expected here; it is skipped" },
    { "Box", "error 1: \"Box\" is not expected here; it is skipped" },
    { "DEF A 7", "error 1: DEF A is not followed by a node" },
    { "DEF Group { }", "warning 1: DEF without a name" },
    { "USE A", "error 1: USE A: no earlier node has this name" },
    { "Box { size }", "error 1: a value is missing" },
    { "Cone { height side TRUE }", "error 1: a value is missing before \"side\"" },
    { "Transform { children [ Group { } }", "error 1: ] is missing at the end of a list" },
    { "IndexedFaceSet { coordIndex [ 0 1 ccw TRUE }",
      "error 1: ] is missing at the end of a list" },
    { "Group { Group { } }",
      "warning 1: \"Group\" is in Group where a field is expected; it is read as a child" },
    { "Box { length 3 }", "warning 1: Box has no field \"length\"; it is skipped" },
    { "Group { kids Shape { } }", "error 1: Group has no field \"kids\"; it is skipped" },
    { "Box { size 1 1 1 size 2 2 2 }",
      "warning 1: Box has the field \"size\" twice; the last counts" },
    { "Nurbs { a 1 b [ C { d \"x\" } ] }", "warning 1: VRML97 has no node Nurbs; it is skipped" },
    { "WorldInfo { title \"open\n}", "error 1: the quote that ends a string is missing" },
  };
  for (const auto& [text, message] : faults)
  {
    const Parsed parsed(text + "\nViewpoint { }");
    ASSERT_FALSE(parsed.Messages.empty()) << text;
    EXPECT_EQ(parsed.Messages.front(), message);
    ASSERT_FALSE(parsed.Document.Roots.empty()) << text;
    EXPECT_EQ(parsed.Document.Roots.back()->TypeName, "Viewpoint") << text;
  }
}

TEST(VRMLParser, KeepsTheOrderOfNumbersAroundAWord)
{
  const Parsed parsed("Coordinate { point [ 1 2 three 4 ] }");
  const lms3dVRMLReals& point = std::get<lms3dVRMLReals>(parsed.GetValue(0, "point"));
  ASSERT_EQ(point.size(), 4u);
  EXPECT_NE(point[2], point[2]);
  EXPECT_EQ(point[3], 4.0);
  EXPECT_EQ(parsed.Messages, Texts{ "error 1: \"three\" is not expected here; it is skipped" });
}

TEST(VRMLParser, ReportsTheEndOfTheFileOnce)
{
  EXPECT_EQ(Parsed("Group { children [\nGroup { children [ Box { size 1").Messages,
    Texts{ "error 2: the file ends inside Box" });
  EXPECT_EQ(Parsed("PROTO P [ field").Messages.size(), 1u);
}

TEST(VRMLParser, BoundsItsDepth)
{
  std::string text;
  for (int i = 0; i < 5000; ++i)
  {
    text += "Group { children [ ";
  }
  for (int i = 0; i < 5000; ++i)
  {
    text += "] } ";
  }
  const Parsed parsed(text + "\nViewpoint { }");
  EXPECT_EQ(parsed.Messages, Texts{ "error 1: Group is nested too deeply" });
  EXPECT_EQ(parsed.Document.Nodes.size(), lms3dVRMLMaximumDepth + 1u);
  EXPECT_EQ(parsed.Document.Roots.back()->TypeName, "Viewpoint");
}

TEST(VRMLParser, DropsANodeThatIsTooDeep)
{
  std::string text;
  for (int i = 0; i < lms3dVRMLMaximumDepth; ++i)
  {
    text += "Group { children [ ";
  }
  const Parsed parsed(text + "DEF Deep Viewpoint { } USE Deep");
  EXPECT_EQ(parsed.Messages,
    (Texts{ "error 1: Viewpoint is nested too deeply",
      "error 1: USE Deep: no earlier node has this name",
      "error 1: the file ends inside a list" }));
}

TEST(VRMLParser, KeepsTheIndicesAroundANodeThatItCannotRead)
{
  const Parsed parsed("Switch { choice [ USE A, Group { }, NULL, DEF B 7 ] }\nUSE C\nGroup { }");
  const auto& choices = std::get<lms3dVRMLNodes>(parsed.GetValue(0, "choice"));
  ASSERT_EQ(choices.size(), 4u);
  EXPECT_EQ(choices[0], nullptr);
  EXPECT_NE(choices[1], nullptr);
  EXPECT_EQ(choices[2], nullptr);
  EXPECT_EQ(choices[3], nullptr);
  EXPECT_EQ(parsed.Document.Roots.size(), 3u);
}

TEST(VRMLParser, BoundsTheNumberOfNodes)
{
  lms3dVRMLOptions options;
  options.MaximumNumberOfNodes = 3;
  const Parsed parsed("Group { }\nGroup { }\nGroup { }\nGroup { }\nGroup { }", options);
  EXPECT_EQ(parsed.Document.Nodes.size(), 3u);
  ASSERT_EQ(parsed.Messages.size(), 1u);
  EXPECT_NE(parsed.Messages[0].find("error 4"), std::string::npos);
  EXPECT_NE(parsed.Messages[0].find("MaximumNumberOfNodes"), std::string::npos);
}

TEST(VRMLParser, BoundsTheMemoryOfValues)
{
  std::string numbers;
  for (int i = 0; i < 1000; ++i)
  {
    numbers += "1 ";
  }
  const std::string list = "Coordinate { point [ " + numbers + "] }\n";
  lms3dVRMLOptions options;
  options.MaximumMemory = 10'000;
  EXPECT_TRUE(Parsed(list, options).Messages.empty());
  const Parsed parsed(list + list + list + list, options);
  EXPECT_LT(parsed.Document.Nodes.size(), 4u);
  ASSERT_EQ(parsed.Messages.size(), 1u);
  EXPECT_NE(parsed.Messages[0].find("MaximumMemory"), std::string::npos);
}
