// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
// Settings that the server refuses. They change nothing.
#include "ClientORB.h"
#include "ServerProcess.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <ostream>
#include <string>

#include <unistd.h>

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

struct BadConfiguration
{
  const char* Name;
  void (*Change)(LMS3D::Configuration&);
  /// A part of the expected reason.
  const char* Word;
};

void PrintTo(const BadConfiguration& bad, std::ostream* os)
{
  *os << bad.Name;
}

using Settings = LMS3D::Configuration;

const BadConfiguration BadConfigurations[] = {
  { "AlphaNaN", [](Settings& c) { c.alpha.start = NaN; }, "alpha.start" },
  { "AlphaBelow", [](Settings& c) { c.alpha.start = -90.5; }, "alpha.start" },
  { "AlphaBeyond", [](Settings& c) { c.alpha.stop = 1e308; }, "alpha.stop" },
  { "AlphaTooNarrow",
    [](Settings& c) {
      c.alpha = { 0.0, 5e-324, 361 };
    },
    "alpha.stop" },
  { "BetaFarAway",
    [](Settings& c) {
      c.beta = { 1e17, 1e17 + 256.0, 360 };
    },
    "beta.start" },
  { "AlphaReversed", [](Settings& c) { c.alpha.stop = -70.0; }, "alpha.stop" },
  { "AlphaEmpty", [](Settings& c) { c.alpha.count = 0; }, "alpha.count" },
  { "BetaInfinite", [](Settings& c) { c.beta.stop = Infinity; }, "beta.stop" },
  { "BetaTooFar", [](Settings& c) { c.beta.stop = 361.0; }, "beta" },
  { "BetaEmpty", [](Settings& c) { c.beta.count = 0; }, "beta.count" },
  { "MinimumNaN", [](Settings& c) { c.minimumRange = NaN; }, "minimumRange" },
  { "MinimumNegative", [](Settings& c) { c.minimumRange = -1.0; }, "minimumRange" },
  { "MinimumAboveMaximum", [](Settings& c) { c.minimumRange = 81.0; }, "minimumRange" },
  { "MaximumZero", [](Settings& c) { c.maximumRange = 0.0; }, "maximumRange" },
  { "MaximumInfinite", [](Settings& c) { c.maximumRange = Infinity; }, "maximumRange" },
  { "ErrorNegative", [](Settings& c) { c.mapError = -0.01; }, "mapError" },
  { "ErrorNaN", [](Settings& c) { c.mapError = NaN; }, "mapError" },
};

// Settings and scan are unchanged.
void ExpectUnchanged(LMS3D::LaserScanner_ptr scanner, const LMS3D::Status& before)
{
  const LMS3D::Status_var after = scanner->getStatus();
  EXPECT_EQ(after->generation, before.generation);
  EXPECT_STREQ(after->problem, "");
}
} // namespace

class ServerRefuses : public testing::TestWithParam<BadConfiguration>
{
};

TEST_P(ServerRefuses, Configuration)
{
  ServerProcess server;
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const LMS3D::Status_var before = scanner->getStatus();
  LMS3D::Configuration configuration = GetCoarseGrid();
  GetParam().Change(configuration);
  try
  {
    scanner->setConfiguration(configuration);
    ADD_FAILURE() << "taken";
  }
  catch (const LMS3D::InvalidArgument& problem)
  {
    EXPECT_NE(std::strstr(problem.reason, GetParam().Word), nullptr) << problem.reason;
  }
  ExpectUnchanged(scanner, before);
}

INSTANTIATE_TEST_SUITE_P(Bad, ServerRefuses, testing::ValuesIn(BadConfigurations),
  [](const auto& bad) { return bad.param.Name; });

TEST(ServerSettings, RefusesMoreBeamsThanFit)
{
  ServerProcess server;
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const LMS3D::Status_var before = scanner->getStatus();
  LMS3D::Configuration configuration = GetCoarseGrid();
  // Their product would be 0 or 1 in 32 bits.
  const CORBA::ULong counts[][2] = { { 65536, 65536 }, { 4294967295u, 4294967295u },
    { 4000001, 1 } };
  for (const auto& count : counts)
  {
    configuration.alpha.count = count[0];
    configuration.beta.count = count[1];
    try
    {
      scanner->setConfiguration(configuration);
      ADD_FAILURE() << count[0] << " x " << count[1] << " was taken";
    }
    catch (const LMS3D::LimitExceeded& problem)
    {
      EXPECT_EQ(problem.limit, 4000000u);
    }
  }
  ExpectUnchanged(scanner, before);
}

TEST(ServerSettings, RefusesInvalidPoses)
{
  ServerProcess server;
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const LMS3D::Status_var before = scanner->getStatus();
  for (const double bad : { NaN, Infinity, -Infinity, 1.1e6 })
  {
    EXPECT_THROW(scanner->setPose(At(0.0, bad, 0.0)), LMS3D::InvalidArgument) << bad;
  }
  LMS3D::Pose turned = At(0.0, 0.0, 1.0);
  for (const double bad : { NaN, -Infinity, 1e308, 1.1e6 })
  {
    turned.orientation.z = bad;
    try
    {
      scanner->setPose(turned);
      ADD_FAILURE() << bad << " degrees were taken";
    }
    catch (const LMS3D::InvalidArgument& problem)
    {
      EXPECT_NE(std::strstr(problem.reason, "within 1e6 degrees"), nullptr) << problem.reason;
    }
  }
  ExpectUnchanged(scanner, before);
}

TEST(ServerSettings, HasOnlyTheScenesOfTheCatalogue)
{
  ServerProcess server;
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const LMS3D::Status_var before = scanner->getStatus();
  const std::string path = std::string(LMS3D_DATA_DIR) + "/room.wrl";
  for (const char* name : { "", ".", "..", "../Data/room.wrl", "./room.wrl", "room", "ROOM.WRL",
         "room.wrl/", "/etc/passwd", path.c_str(), "file:room.wrl" })
  {
    try
    {
      scanner->selectScene(name);
      ADD_FAILURE() << "\"" << name << "\" was taken";
    }
    catch (const LMS3D::NoSuchScene& problem)
    {
      EXPECT_STREQ(problem.name, name);
    }
  }
  ExpectUnchanged(scanner, before);
}

TEST(ServerSettings, KeepsTheSceneIfTheNextIsBroken)
{
  const std::filesystem::path folder =
    std::filesystem::path(testing::TempDir()) / ("lms3d-scenes-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  std::filesystem::copy_file(std::filesystem::path(LMS3D_DATA_DIR) / "room.wrl",
    folder / "room.wrl", std::filesystem::copy_options::overwrite_existing);
  std::ofstream(folder / "broken.wrl") << "#VRML V2.0 utf8\nShape { geometry Box { size 1 ";
  std::ofstream(folder / "empty.wrl") << "no scene at all";
  {
    ServerProcess server({ "--scenes", folder.string() });
    const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
    const LMS3D::Status_var before = scanner->getStatus();
    try
    {
      scanner->selectScene("empty.wrl");
      ADD_FAILURE() << "taken";
    }
    catch (const LMS3D::SceneFailed& problem)
    {
      EXPECT_STREQ(problem.name, "empty.wrl");
      EXPECT_NE(std::strstr(problem.reason, "VRML"), nullptr) << problem.reason;
      EXPECT_EQ(std::strstr(problem.reason, folder.c_str()), nullptr) << problem.reason;
    }
    ExpectUnchanged(scanner, before);
    EXPECT_STREQ(WaitFor(scanner).scene.in(), "room.wrl");
    EXPECT_EQ(server.Terminate(SIGTERM), 0);
  }
  std::filesystem::remove_all(folder);
}

TEST(ServerSettings, ReadOnlyLetsClientsLookOnly)
{
  ServerProcess server({ "--read-only" });
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const LMS3D::Status_var before = scanner->getStatus();
  EXPECT_TRUE(before->isReadOnly);
  EXPECT_THROW(scanner->setPose(At(0.0, 0.0, 1.0)), LMS3D::NotPermitted);
  EXPECT_THROW(scanner->setConfiguration(GetCoarseGrid()), LMS3D::NotPermitted);
  EXPECT_THROW(scanner->selectScene("teapot.wrl"), LMS3D::NotPermitted);
  ExpectUnchanged(scanner, before);
  const LMS3D::Data_var triples = scanner->fetch();
  EXPECT_EQ(triples->length(), 389880u);
}
