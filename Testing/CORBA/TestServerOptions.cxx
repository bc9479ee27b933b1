// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FolderTest.h"
#include "Options/lms3dServerOptions.h"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <vector>

namespace
{
using ServerOptions = FolderTest;

std::string GetProblem(const std::vector<std::string>& arguments)
{
  try
  {
    lms3dReadServerOptions(arguments);
    return "none";
  }
  catch (const std::invalid_argument& problem)
  {
    return problem.what();
  }
}

bool Contains(const std::string& text, const std::string& word)
{
  return text.find(word) != std::string::npos;
}
} // namespace

TEST_F(ServerOptions, DefaultsAreSafe)
{
  const lms3dServerOptions options = lms3dReadServerOptions({ "--scenes", "Data" });
  EXPECT_EQ(options.Scenes, "Data");
  EXPECT_EQ(options.Endpoint, "giop:tcp:127.0.0.1:");
  EXPECT_EQ(options.Rate, 10.0);
  EXPECT_EQ(options.Keep, 4);
  EXPECT_FALSE(options.Callbacks);
  EXPECT_FALSE(options.Naming);
}

TEST_F(ServerOptions, TheCommandLineWinsOverTheFile)
{
  const std::string file = this->Write("server.conf",
    "# a comment\n\n  scenes = My Scenes \r\nrate=5\nposition = 0.5 -1 1e1\nread-only\n"
    "connect-to = 10.0.0.1/255.255.255.255\n");
  const lms3dServerOptions options = lms3dReadServerOptions(
    { "--rate", "7.5", "--config", file, "--threads", "2", "-ORBtraceLevel", "10" });
  EXPECT_EQ(options.Scenes, "My Scenes");
  EXPECT_EQ(options.Rate, 7.5);
  EXPECT_EQ(options.Position, (std::array<double, 3>{ 0.5, -1.0, 10.0 }));
  EXPECT_TRUE(options.ReadOnly);
  EXPECT_EQ(options.Threads, 2);
  EXPECT_EQ(options.ConnectTo, std::vector<std::string>{ "10.0.0.1/255.255.255.255" });
  EXPECT_EQ(options.ORBArguments, (std::vector<std::string>{ "-ORBtraceLevel", "10" }));
}

TEST_F(ServerOptions, AFileMayBeginWithAByteOrderMark)
{
  const std::string file = this->Write("windows.conf", "\xEF\xBB\xBFscenes = Data\r\nrate = 5\r\n");
  const lms3dServerOptions options = lms3dReadServerOptions({ "--config", file });
  EXPECT_EQ(options.Scenes, "Data");
  EXPECT_EQ(options.Rate, 5.0);
}

TEST_F(ServerOptions, ARateOfZeroHasAnyNotation)
{
  for (const char* zero : { "0", "0.0", "0e0" })
  {
    EXPECT_EQ(lms3dReadServerOptions({ "--scenes", "Data", "--rate", zero }).Rate, 0.0);
  }
  EXPECT_TRUE(Contains(GetProblem({ "--rate", "0.0005" }), "from 0.001 to 10000"));
}

TEST_F(ServerOptions, LimitScenes)
{
  const lms3dServerOptions options = lms3dReadServerOptions(
    { "--scenes", "Data", "--scene-triangles", "5000000000", "--scene-memory", "300" });
  EXPECT_EQ(options.SceneTriangles, 5'000'000'000);
  EXPECT_EQ(options.SceneMemory, 300);
}

TEST_F(ServerOptions, SayWhatIsWrongAndWhere)
{
  EXPECT_TRUE(Contains(GetProblem({}), "--scenes"));
  EXPECT_TRUE(Contains(GetProblem({ "--scene" }), "--scene: a value must follow: NAME"));
  EXPECT_TRUE(Contains(GetProblem({ "--speed" }), "was not expected: --speed"));
  EXPECT_TRUE(Contains(GetProblem({ "room.wrl" }), "was not expected: room.wrl"));
  EXPECT_TRUE(Contains(GetProblem({ "--sce", "b", "c" }), "was not expected: --sce"));
  EXPECT_TRUE(Contains(GetProblem({ "--rate", "fast" }), "\"fast\" is not a number from 0"));
  EXPECT_TRUE(Contains(GetProblem({ "--rate", "nan" }), "nan"));
  EXPECT_TRUE(Contains(GetProblem({ "--rate", "-1" }), "-1"));
  EXPECT_TRUE(Contains(GetProblem({ "--rate", "5x" }), "5x"));
  EXPECT_TRUE(Contains(GetProblem({ "--keep", "0" }), "from 1 to 1000"));
  EXPECT_TRUE(Contains(GetProblem({ "--keep", "2.5" }), "2.5"));
  EXPECT_TRUE(
    Contains(GetProblem({ "--position", "0", "1" }), "--position: 3 values must follow: X Y Z"));
  EXPECT_TRUE(Contains(GetProblem({ "--position", "0", "inf", "1" }), "inf"));
  EXPECT_TRUE(Contains(GetProblem({ "--up-axis", "x" }), "neither file nor y"));
  EXPECT_TRUE(Contains(GetProblem({ "-ORBtraceLevel" }), "-ORBtraceLevel: a value must follow"));
  EXPECT_TRUE(Contains(GetProblem({ "--config", "/no/such/file" }), "cannot be read"));
  EXPECT_TRUE(Contains(GetProblem({ "--read-only=yes" }), "--read-only: it takes no value"));
  EXPECT_TRUE(
    Contains(GetProblem({ "--scenes", "Data", "--tls-key", "k.pem" }), "one needs the other"));

  const std::string file = this->Write("bad.conf", "rate = 5\nport = 3\n");
  EXPECT_TRUE(Contains(GetProblem({ "--config", file }),
    file + ":2: \"port = 3\": The following argument was not expected"));
  EXPECT_TRUE(Contains(GetProblem({ "--config", this->Folder.string() }), "cannot be read"));
  const std::string flag = this->Write("flag.conf", "read-only = yes\n");
  EXPECT_TRUE(Contains(
    GetProblem({ "--config", flag }), flag + ":1: \"read-only = yes\": it takes no value"));
  const std::string nested = this->Write("nested.conf", "config = " + file + "\n");
  EXPECT_TRUE(Contains(GetProblem({ "--config", nested }), "was not expected: --config"));
}

TEST_F(ServerOptions, ValuesMayBeNegative)
{
  const lms3dServerOptions options = lms3dReadServerOptions({ "--scenes", "Data", "--position",
    "-1", "0", "-.5", "--orientation", "10", "-20", "-3e1", "-ORBtraceLevel", "-1" });
  EXPECT_EQ(options.Position, (std::array<double, 3>{ -1.0, 0.0, -0.5 }));
  EXPECT_EQ(options.Orientation, (std::array<double, 3>{ 10.0, -20.0, -30.0 }));
  EXPECT_EQ(options.ORBArguments, (std::vector<std::string>{ "-ORBtraceLevel", "-1" }));
}

TEST_F(ServerOptions, AnEqualsSignNeedsAValue)
{
  EXPECT_EQ(GetProblem({ "--scenes", "Data", "--name=", "--read-only" }),
    "--name: a value must follow the \"=\": NAME");
  EXPECT_EQ(GetProblem({ "--scenes", "Data", "--position=", "1", "2", "3" }),
    "--position: a value must follow the \"=\": X Y Z");
  EXPECT_EQ(GetProblem({ "--scenes", "Data", "--config=" }),
    "--config: a value must follow the \"=\": FILE");
  EXPECT_EQ(GetProblem({ "--scenes", "Data", "--no-map=", "5" }), "--no-map: it takes no value");
  EXPECT_TRUE(Contains(GetProblem({ "--scenes", "Data", "--foo=" }), "was not expected: --foo="));

  const lms3dServerOptions options = lms3dReadServerOptions(
    { "--scenes", "--rate=", "--scene=a=", "--name", "--read-only", "--position=1", "-.5", "3" });
  EXPECT_EQ(options.Scenes, "--rate=");
  EXPECT_EQ(options.Scene, "a=");
  EXPECT_EQ(options.Name, "--read-only");
  EXPECT_FALSE(options.ReadOnly);
  EXPECT_EQ(options.Position, (std::array<double, 3>{ 1.0, -0.5, 3.0 }));
}

TEST_F(ServerOptions, NamesAreTakenAsTheyAre)
{
  const std::string file = this->Write("[odd].conf", "scene = -.5.wrl\nior = [a b]\n");
  for (const char* name : { "-.wrl", "-.5.wrl", "[q]", "[a,b]", "{}", "%%", "--", "=" })
  {
    const lms3dServerOptions options = lms3dReadServerOptions(
      { "--scenes", name, "--name", name, "--connect-to", name, "--config", file });
    EXPECT_EQ(options.Scenes, name);
    EXPECT_EQ(options.Name, name);
    EXPECT_EQ(options.ConnectTo, std::vector<std::string>{ name });
    EXPECT_EQ(options.Scene, "-.5.wrl");
    EXPECT_EQ(options.IORFile, "[a b]");
  }
  EXPECT_TRUE(Contains(GetProblem({ "--config", "[q]" }), "\"[q]\" cannot be read"));
  EXPECT_TRUE(Contains(GetProblem({ "--config", file, "q" }), "was not expected: q"));
}

TEST_F(ServerOptions, AFlagInAFileMayHaveAnEqualsSign)
{
  const std::string file = this->Write("flag.conf", "scenes = Data\nread-only =\nno-map=\n");
  const lms3dServerOptions options = lms3dReadServerOptions({ "--config", file });
  EXPECT_TRUE(options.ReadOnly);
  EXPECT_FALSE(options.MakeMap);
}

TEST_F(ServerOptions, TheValuesOfAVectorStandTogether)
{
  EXPECT_TRUE(
    Contains(GetProblem({ "--scenes", "Data", "--position", "1", "--position", "2", "3" }),
      "--position: \"--position\" is not a number"));
  EXPECT_TRUE(
    Contains(GetProblem({ "--scenes", "Data", "--position", "1", "2", "--read-only", "--no-map" }),
      "--position: \"--read-only\" is not a number"));
  EXPECT_TRUE(Contains(
    GetProblem({ "--scenes", "Data", "--position", "1", "2", "3", "4" }), "was not expected: 4"));
  EXPECT_EQ(GetProblem({ "--scenes", "Data", "--position=1", "2" }),
    "--position: 3 values must follow: X Y Z");
}

TEST_F(ServerOptions, TheLastOfRepeatedOptionsHoldsUnlessTheyAdd)
{
  const std::string file = this->Write("twice.conf",
    "scenes = Data\nposition = 1 2 3\nposition = 4 5 6\nconnect-to = a/b\nconnect-to = c/d\n");
  const lms3dServerOptions options = lms3dReadServerOptions({ "--config", file, "--keep", "2",
    "--keep", "3", "--read-only", "--read-only", "--connect-to", "e/f", "--connect-to", "[::1]" });
  EXPECT_EQ(options.Position, (std::array<double, 3>{ 4.0, 5.0, 6.0 }));
  EXPECT_EQ(options.Keep, 3);
  EXPECT_TRUE(options.ReadOnly);
  EXPECT_EQ(options.ConnectTo, (std::vector<std::string>{ "a/b", "c/d", "e/f", "[::1]" }));
  EXPECT_TRUE(Contains(
    GetProblem({ "--scenes", "Data", "--position", "1", "2", "3", "--position", "4", "5" }),
    "3 values must follow"));
}

TEST_F(ServerOptions, NumbersHaveLimitsInFilesToo)
{
  EXPECT_TRUE(Contains(GetProblem({ "--map-error", "1e308" }), "\"1e308\" is not a number from 0"));
  EXPECT_TRUE(Contains(GetProblem({ "--map-error", "1e309" }), "\"1e309\" is not a number from 0"));
  EXPECT_TRUE(Contains(GetProblem({ "--keep", "0x10" }), "\"0x10\" is not a whole number"));
  for (const char* line : { "position = nan 0 0", "position = 1 2", "rate =", "rate", "keep = 0",
         "[server]", "a b = 3", "help" })
  {
    const std::string file = this->Write("bad.conf", std::string("# bad\n") + line + "\n");
    EXPECT_TRUE(Contains(GetProblem({ "--config", file }), file + ":2: \"" + line + "\": "))
      << line;
  }
}

TEST_F(ServerOptions, RemoteEndpointsNeedPermission)
{
  for (const char* endpoint : { "giop:tcp::2810", "giop:tcp:0.0.0.0:2810", "giop:tcp:robot:2810",
         "giop:tcp:[::]:2810", "giop:tcp:128.0.0.1:", "giop:tcp:127.robots.example:2810" })
  {
    EXPECT_TRUE(
      Contains(GetProblem({ "--scenes", "Data", "--endpoint", endpoint }), "--allow-remote"))
      << endpoint;
    EXPECT_EQ(GetProblem({ "--scenes", "Data", "--endpoint", endpoint, "--allow-remote" }), "none");
  }
  for (const char* endpoint : { "giop:tcp:127.0.0.1:2810", "giop:tcp:localhost:2810",
         "giop:tcp:[::1]:", "giop:unix:/run/lms3d" })
  {
    EXPECT_EQ(GetProblem({ "--scenes", "Data", "--endpoint", endpoint }), "none");
  }
}

TEST_F(ServerOptions, TLSAndItsEndpointGoTogether)
{
  EXPECT_TRUE(
    Contains(GetProblem({ "--scenes", "Data", "--tls-key", "k.pem", "--tls-authorities", "a.pem" }),
      "would be served without TLS"));
  EXPECT_TRUE(Contains(
    GetProblem({ "--scenes", "Data", "--endpoint", "giop:ssl:127.0.0.1:" }), "needs --tls-key"));
}

TEST_F(ServerOptions, ALongEndpointIsRefused)
{
  const std::string endpoint = "giop:unix:/" + std::string(200000, 'x');
  EXPECT_TRUE(
    Contains(GetProblem({ "--scenes", "Data", "--endpoint", endpoint }), "other machines"));
}
