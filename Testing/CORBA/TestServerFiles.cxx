// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Announcement/lms3dObjectAddresses.h"
#include "Announcement/lms3dReferenceFile.h"
#include "FolderTest.h"
#include "Scanning/lms3dSceneCatalogue.h"
#include "Scanning/lms3dServedScene.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>
#include <vector>

#include <sys/stat.h>

using ServerFiles = FolderTest;

TEST_F(ServerFiles, TheCatalogueHasTheFoldersScenesAlone)
{
  std::filesystem::create_directories(this->Folder / "below.wrl");
  this->Write("b.WRL", "");
  this->Write("a.vrml", "");
  this->Write("c.wrz", "");
  this->Write("notes.txt", "");
  this->Write("d.wrl.bak", "");
  this->Write("below.wrl/e.wrl", "");
  this->Write(std::string(130, 'x') + ".wrl", "");
  this->Write("\xc3\xa9.wrl", "");
  const lms3dSceneCatalogue catalogue(this->Folder);
  EXPECT_EQ(catalogue.GetNames(), (std::vector<std::string>{ "a.vrml", "b.WRL", "c.wrz" }));
  ASSERT_NE(catalogue.Find("b.WRL"), nullptr);
  EXPECT_EQ(*catalogue.Find("b.WRL"), this->Folder / "b.WRL");
  EXPECT_EQ(catalogue.Find("b.wrl"), nullptr);
  EXPECT_EQ(catalogue.Find("below.wrl/e.wrl"), nullptr);

  // Clients cannot select files that appear later.
  this->Write("late.wrl", "");
  EXPECT_EQ(catalogue.Find("late.wrl"), nullptr);
}

TEST_F(ServerFiles, ACatalogueNeedsScenes)
{
  EXPECT_THROW(lms3dSceneCatalogue("/no/such/folder"), std::runtime_error);
  EXPECT_THROW(lms3dSceneCatalogue(this->Folder), std::runtime_error);
}

TEST_F(ServerFiles, ScenesAreReadWithinTheirLimits)
{
  const std::string box = "Shape { geometry Box { } }\n";
  const std::string file = this->Write("two.wrl", "#VRML V2.0 utf8\n" + box + box);
  const auto countTriangles = [&file](const lms3dSceneReading& reading)
  { return lms3dReadScene("two.wrl", file, reading, [] { return false; })->Description.triangles; };
  EXPECT_EQ(countTriangles({}), 24u);
  lms3dSceneReading few;
  few.MaximumNumberOfTriangles = 20;
  EXPECT_EQ(countTriangles(few), 12u);
  lms3dSceneReading little;
  little.MaximumMemory = 10;
  EXPECT_THROW(countTriangles(little), std::runtime_error);
}

TEST_F(ServerFiles, TheReferenceFileIsThereAsLongAsTheServer)
{
  const std::string file = (this->Folder / "scanner.ior").string();
  {
    const lms3dReferenceFile reference(file, "IOR:00");
    std::string line;
    std::getline(std::ifstream(file), line);
    EXPECT_EQ(line, "IOR:00");
    // It has the permissions of the user's other files.
    const std::string usual = this->Write("usual", "");
    EXPECT_EQ(
      std::filesystem::status(file).permissions(), std::filesystem::status(usual).permissions());
  }
  EXPECT_FALSE(std::filesystem::exists(file));
  {
    const lms3dReferenceFile reference(file, "IOR:00");
    this->Write("scanner.ior", "IOR:11\n");
  }
  EXPECT_TRUE(std::filesystem::exists(file)) << "another server's file was removed";
  EXPECT_THROW(lms3dReferenceFile("/no/such/folder/x.ior", "IOR:00"), std::runtime_error);
}

TEST_F(ServerFiles, TheReferenceFileReplacesFilesAlone)
{
  const std::string pipe = (this->Folder / "pipe").string();
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::string link = (this->Folder / "link").string();
  std::filesystem::create_symlink("/dev/null", link);
  for (const std::string& name : { pipe, link, this->Folder.string() })
  {
    EXPECT_THROW(lms3dReferenceFile(name, "IOR:00"), std::runtime_error) << name;
  }
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
  EXPECT_TRUE(std::filesystem::is_symlink(link));
}

TEST_F(ServerFiles, ServersMayWriteTheSameReferenceFileAtOnce)
{
  const std::string file = (this->Folder / "scanner.ior").string();
  constexpr int Servers = 8;
  std::vector<std::thread> servers;
  servers.reserve(Servers);
  for (int i = 0; i < Servers; ++i)
  {
    servers.emplace_back(
      [&file, i]
      {
        for (int j = 0; j < 200; ++j)
        {
          EXPECT_NO_THROW(lms3dReferenceFile(file, "IOR:" + std::to_string(i)));
        }
      });
  }
  for (std::thread& server : servers)
  {
    server.join();
  }
  const lms3dReferenceFile last(file, "IOR:last");
  std::string line;
  std::getline(std::ifstream(file), line);
  EXPECT_EQ(line, "IOR:last");
  const std::filesystem::directory_iterator files(this->Folder);
  EXPECT_EQ(std::distance(begin(files), end(files)), 1) << "a temporary file was left";
}

TEST(ObjectAddresses, CorbalocsNameTheirVersion)
{
  EXPECT_EQ(lms3dGetCorbaloc({ "giop:unix:/run/x", "giop:tcp:127.0.0.1:2810" }, "LMS3D"),
    "corbaloc:iiop:1.2@127.0.0.1:2810/LMS3D");
  EXPECT_EQ(
    lms3dGetCorbaloc({ "giop:ssl:[::1]:2810" }, "LMS3D"), "corbaloc:ssliop:1.2@[::1]:2810/LMS3D");
  EXPECT_EQ(lms3dGetCorbaloc({ "giop:unix:/run/x" }, "LMS3D"), "");
}
