// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Tests with a temporary folder.
 */
#ifndef FolderTest_h
#define FolderTest_h

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

/// Creates a folder for each test, and removes it afterwards.
class FolderTest : public testing::Test
{
protected:
  void SetUp() override { std::filesystem::create_directories(this->Folder); }
  void TearDown() override { std::filesystem::remove_all(this->Folder); }

  /// Writes a file in the folder and returns its path.
  std::string Write(const std::string& name, const std::string& text) const
  {
    std::string file = (this->Folder / name).string();
    std::ofstream(file) << text;
    return file;
  }

  const std::filesystem::path Folder =
    std::filesystem::path(testing::TempDir()) / ("lms3d-folder-" + std::to_string(getpid()));
};

#endif
