// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The function that libFuzzer calls with each input.
 */
#include "FuzzVRMLReader.h"

#include <unistd.h>

#include <cstdint>
#include <string>

// Uses memory, not a disk. Each process has its own folder.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const lms3dFuzzFolder folder(
    std::filesystem::path("/dev/shm") / ("lms3d-" + std::to_string(getpid())));
  folder.Read(reinterpret_cast<const char*>(data), size);
  return 0;
}
