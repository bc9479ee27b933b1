// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A reader, and a file of its own for each test.
 */
#ifndef ImporterFixture_h
#define ImporterFixture_h

#include "vtkVRMLImporterSource.h"

#include <vtkNew.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

/// A scene with a coloured square of 1 m by 2 m.
extern const char* const SquareScene;

class VRMLImporterSource : public testing::Test
{
protected:
  void SetUp() override;
  void TearDown() override;

  void Write(const std::string& text);

  /// Expects an error that contains a text, and no output.
  void ExpectError(unsigned long code, const std::string& text);

  std::filesystem::path File;
  vtkNew<vtkVRMLImporterSource> Reader;
};

#endif
