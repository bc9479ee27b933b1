// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What libFuzzer calls with each of its inputs.
 */
#include "FuzzVRMLReader.h"

#include <unistd.h>

#include <cstdint>
#include <string>

// Memory rather than a disk, and a folder of its own for each process.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const lms3dFuzzFolder folder(
    std::filesystem::path("/dev/shm") / ("lms3d-" + std::to_string(getpid())));
  folder.Read(reinterpret_cast<const char*>(data), size);
  return 0;
}
