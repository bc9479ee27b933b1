// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ClientORB.h"
#include "ServerProcess.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include <unistd.h>

namespace
{
// Each transform contains the one before it twice, so a small file takes seconds to read.
void WriteSceneOfManyNodes(const std::filesystem::path& path)
{
  std::ofstream file(path);
  file << "#VRML V2.0 utf8\nShape { geometry Box { } }\nDEF N0 Group { }\n";
  for (int i = 1; i < 24; ++i)
  {
    file << "DEF N" << i << " Transform { rotation 0 0 1 " << i << " children [ USE N" << i - 1
         << " USE N" << i - 1 << " ] }\n";
  }
}

/// A folder of its own, with a scene that is read at once and one that takes seconds.
class ServerScenes : public testing::Test
{
protected:
  void SetUp() override
  {
    std::filesystem::create_directories(this->Folder);
    std::filesystem::copy_file(
      std::filesystem::path(LMS3D_DATA_DIR) / "room.wrl", this->Folder / "room.wrl");
    WriteSceneOfManyNodes(this->Folder / "large.wrl");
  }
  void TearDown() override { std::filesystem::remove_all(this->Folder); }

  const std::filesystem::path Folder =
    std::filesystem::path(testing::TempDir()) / ("lms3d-large-" + std::to_string(getpid()));
};
} // namespace

// One call reads its scene, and the others wait for their turn.
TEST_F(ServerScenes, FiveClientsSelectAtMostAndDoNotDelayTheEnd)
{
  constexpr int Clients = 8;
  constexpr int Maximum = 5;
  ServerProcess server({ "--scenes", this->Folder.string(), "--scene-nodes", "100000000" });
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  std::atomic<int> refused(0);
  std::atomic<int> cut(0);
  std::vector<std::thread> clients;
  clients.reserve(Clients);
  for (int i = 0; i < Clients; ++i)
  {
    clients.emplace_back(
      [&]
      {
        try
        {
          scanner->selectScene("large.wrl");
        }
        catch (const LMS3D::LimitExceeded& problem)
        {
          refused += problem.limit == Maximum ? 1 : 1000;
        }
        catch (const CORBA::TRANSIENT&)
        {
          ++cut;
        }
        catch (const CORBA::COMM_FAILURE&)
        {
          ++cut;
        }
      });
  }
  for (int i = 0; i < 600 && refused < Clients - Maximum; ++i)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  // Other calls are answered meanwhile.
  EXPECT_STREQ(WaitFor(scanner).scene.in(), "room.wrl");
  server.ExpectPromptEnd();
  for (std::thread& client : clients)
  {
    client.join();
  }
  EXPECT_EQ(refused, Clients - Maximum);
  EXPECT_EQ(cut, Maximum);
}

// Fifty-five names, and the headers, almost fill the smallest message that omniORB allows.
TEST_F(ServerScenes, AListThatDoesNotFitIsRefusedInWords)
{
  const auto add = [this](int first, int last)
  {
    for (int i = first; i <= last; ++i)
    {
      std::ofstream(this->Folder / (std::string(90, 'x') + std::to_string(100000 + i) + ".wrl"));
    }
  };
  const std::vector<std::string> arguments = { "--scenes", this->Folder.string(),
    "-ORBgiopMaxMsgSize", "8192" };
  add(1, 55);
  {
    ServerProcess server(arguments);
    const LMS3D::SceneNames_var names = Connect(server.GetCorbaloc())->listScenes();
    EXPECT_EQ(names->length(), 57u);
  }
  add(56, 200);
  ServerProcess server(arguments);
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  EXPECT_THROW(scanner->listScenes(), CORBA::IMP_LIMIT);
  EXPECT_GT(WaitFor(scanner).number, 0u);
}
