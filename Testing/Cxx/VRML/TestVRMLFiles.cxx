// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/lms3dFile.h"
#include "Files/lms3dVRMLHeader.h"
#include "Files/lms3dVRMLUrl.h"
#include "Model/lms3dMessages.h"
#include "Model/lms3dUTF8.h"

#include "FuzzVRMLReader.h"
#include "VRML/VRMLFixtures.h"

#include <zlib.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace
{
using VRMLFiles = VRMLScene;
using Texts = std::vector<std::string>;

void Pack(const std::string& text, const std::string& fileName)
{
  gzFile file = gzopen(fileName.c_str(), "wb");
  gzwrite(file, text.data(), static_cast<unsigned int>(text.size()));
  gzclose(file);
}
} // namespace

TEST_F(VRMLFiles, AreUnpacked)
{
  const std::string name = (this->Folder / "packed.wrl").string();
  const std::string text = "#VRML V2.0 utf8\n" + std::string(1 << 20, ' ') + SquareShape;
  Pack(text, name);
  EXPECT_EQ(lms3dReadFile(name, 1 << 30).Text, text);
  EXPECT_EQ(lms3dReadFile(name, 1 << 30).Problem, "");
  EXPECT_EQ(lms3dReadBeginning(name, 10), "#VRML V2.0");
  EXPECT_EQ(lms3dReadFile(name, 100).Text, text.substr(0, 100));
  EXPECT_NE(lms3dReadFile(name, 100).Problem, "");
  EXPECT_EQ(lms3dReadFile(name, static_cast<std::int64_t>(text.size())).Problem, "");

  std::filesystem::resize_file(name, std::filesystem::file_size(name) - 4);
  EXPECT_EQ(lms3dReadFile(name, 1 << 30).Text, text);
  EXPECT_NE(lms3dReadFile(name, 1 << 30).Problem, "");
}

TEST_F(VRMLFiles, AreRegularAndNotLongerThanAllowed)
{
  const std::string name = this->Write("0123456789");
  EXPECT_EQ(lms3dReadFile(name, 100).Text, "#VRML V2.0 utf8\n0123456789");
  EXPECT_EQ(lms3dReadFile(name, 26).Problem, "");
  EXPECT_EQ(lms3dReadFile(name, 25).Text, "#VRML V2.0 utf8\n012345678");
  EXPECT_NE(lms3dReadFile(name, 25).Problem, "");
  EXPECT_NE(lms3dReadFile(this->Folder.string(), 100).Problem, "");
  EXPECT_NE(lms3dReadFile("/dev/zero", 100).Problem, "");
  EXPECT_NE(lms3dReadFile(name + ".none", 100).Problem, "");
}

TEST_F(VRMLFiles, AreRecognisedByTheirBeginning)
{
  EXPECT_EQ(lms3dExplainBeginning("#VRML V2.0 utf8"), "");
  EXPECT_EQ(lms3dExplainBeginning("\xEF\xBB\xBF#VRML V2.0 utf8"), "");
  for (const auto& [beginning, word] :
    std::vector<std::pair<std::string, std::string>>{ { "#VRML V1.0 ascii", "VRML 1.0" },
      { "#X3D V3.0 utf8", "X3D" }, { "<?xml version", "X3D" }, { "#Inventor V2.1", "Inventor" },
      { std::string("glTF\0\0", 6), "binary" }, { "", "#VRML V2.0" }, { "solid", "#VRML V2.0" } })
  {
    EXPECT_NE(lms3dExplainBeginning(beginning).find(word), std::string::npos) << beginning;
  }
}

TEST(VRMLUrl, HasParts)
{
  const auto path = [](const char* text) { return lms3dVRMLUrl(text).Path; };
  EXPECT_EQ(path("a%20b/c.wrl#D"), "a b/c.wrl");
  EXPECT_EQ(lms3dVRMLUrl("a.wrl#D").Fragment, "D");
  EXPECT_EQ(path("a\\b.wrl"), "a/b.wrl");
  EXPECT_EQ(path("file:///a/b.wrl"), "/a/b.wrl");
  EXPECT_EQ(path("FILE://localhost/a/b.wrl"), "/a/b.wrl");
  EXPECT_EQ(path("file:a.wrl"), "a.wrl");
  EXPECT_EQ(path("file://elsewhere/a.wrl"), "");
  EXPECT_EQ(path("100%"), "100%");
  EXPECT_TRUE(lms3dVRMLUrl("c:/a.wrl").IsFile);
  for (const char* text : { "http://a/b.wrl", "HTTPS:x", "urn:a", "javascript:a", "data:," })
  {
    EXPECT_FALSE(lms3dVRMLUrl(text).IsFile) << text;
  }
}

TEST_F(VRMLFiles, StayBelowTheSceneRoot)
{
  this->Write(SquareShape, "above.wrl");
  const std::string scene =
    this->Write(SquareShape + std::string("Inline {\nurl \"../above.wrl\" }"), "scenes/scene.wrl");
  const auto read = [&]
  { return lms3dReadVRML(scene, this->Options, [](double) { return true; }); };
  EXPECT_EQ(GetMessages(read()),
    Texts{ "error 3: an Inline is lost: \"../above.wrl\" is not below SceneRoot "
           "(on the command line --scene-root)" });
  EXPECT_DOUBLE_EQ(GetArea(read()), 1.0);
  this->Options.SceneRoot = this->Folder.string();
  EXPECT_EQ(GetMessages(read()), Texts());
  EXPECT_DOUBLE_EQ(GetArea(read()), 2.0);
}

TEST_F(VRMLFiles, MayNotContainThemselves)
{
  const lms3dScene scene = this->Read(SquareShape + std::string("Inline { url \"scene.wrl\" }"));
  EXPECT_EQ(
    GetMessages(scene), Texts{ "error 3: an Inline is lost: its file contains the Inline" });
  EXPECT_DOUBLE_EQ(GetArea(scene), 1.0);
}

TEST_F(VRMLFiles, StopAfterAnAbort)
{
  std::string text;
  for (int i = 0; i < 1000; ++i)
  {
    text += SquareShape;
  }
  double last = 0.0;
  const auto stopAtHalf = [&last](double share)
  {
    EXPECT_GE(share, last);
    last = share;
    return share < 0.5;
  };
  const lms3dScene scene = lms3dReadVRML(this->Write(text), this->Options, stopAtHalf);
  EXPECT_TRUE(scene.Shapes.empty());
  EXPECT_TRUE(scene.Messages.empty());
  EXPECT_GE(last, 0.5);
  EXPECT_LT(last, 0.6);
}

TEST(Messages, AreUniqueWithTheHighestSeverity)
{
  lms3dMessages messages;
  messages.AddWarning("a", 1, "x");
  messages.AddError("a", 2, "x");
  messages.AddError("a", 1, "x");
  messages.AddWarning("a", 2, "x");
  const std::vector<lms3dMessage> taken = messages.Take();
  ASSERT_EQ(taken.size(), 2u);
  EXPECT_EQ(taken[0].Severity, lms3dMessage::MESSAGE_ERROR);
  EXPECT_EQ(taken[1].Severity, lms3dMessage::MESSAGE_ERROR);
}

TEST(Messages, AreAThousandAtMost)
{
  lms3dMessages messages;
  for (std::size_t i = 0; i < 5000; ++i)
  {
    messages.AddWarning("a", i, "x");
  }
  messages.AddError("a", 1, std::string(1000000, 'y'));
  const std::vector<lms3dMessage> taken = messages.Take();
  ASSERT_EQ(taken.size(), 1001u);
  EXPECT_EQ(taken.back().Severity, lms3dMessage::MESSAGE_ERROR);
  EXPECT_NE(taken.back().Text.find("1 more errors and 4000 more warnings"), std::string::npos);
}

TEST(VRMLFuzz, ReadsItsCorpus)
{
  const lms3dFuzzFolder folder(std::filesystem::path(testing::TempDir()) / "VRMLFuzz");
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(LMS3D_FUZZ_DIR))
  {
    std::ifstream file(entry.path(), std::ios::binary);
    const std::string text{ std::istreambuf_iterator<char>(file),
      std::istreambuf_iterator<char>() };
    folder.Read(text.data(), text.size());
    ++count;
  }
  EXPECT_GT(count, 0u);
}

TEST(UTF8, KeepsValidTextAndReadsTheRestAsLatin1)
{
  const std::string valid = "a\xC3\xA4\xE2\x82\xAC\xF0\x9F\x98\x80";
  EXPECT_EQ(lms3dToUTF8(valid), valid);
  EXPECT_EQ(lms3dToUTF8("W\xE4nde"), "W\xC3\xA4nde");
  EXPECT_EQ(lms3dToUTF8("\xC3"), "\xC3\x83");
  for (const char* bytes : { "\xC0\x80", "\xED\xA0\x80", "\xE0\x80\x80", "\xF5\x80\x80\x80" })
  {
    EXPECT_EQ(lms3dToUTF8(bytes).size(), 2 * std::string(bytes).size());
  }
  EXPECT_EQ(lms3dCutUTF8(valid, 2), "a");
  EXPECT_EQ(lms3dCutUTF8(valid, 3), "a\xC3\xA4");
  EXPECT_EQ(lms3dCutUTF8(valid, 100), valid);
}
