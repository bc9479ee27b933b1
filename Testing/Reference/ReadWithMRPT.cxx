// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
// Reads scans of an LMS 200 with MRPT's driver, and prints them: a line for each scan, with the
// word "scan" and the ranges in metres, "-" for ranges that the driver calls invalid. (The driver
// prints lines of its own when it tries again.) Arguments: the port, the rate, 1 for millimetres or
// 0, the angle, the resolution in hundredths of a degree, and the number of scans.

#include <mrpt/hwdrivers/CSickLaserSerial.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <thread>

namespace
{
void Print(const mrpt::obs::CObservation2DRangeScan& scan)
{
  std::printf("scan ");
  for (std::size_t i = 0; i < scan.getScanSize(); ++i)
  {
    if (scan.getScanRangeValidity(i))
    {
      std::printf("%.4f ", static_cast<double>(scan.getScanRange(i)));
    }
    else
    {
      std::printf("- ");
    }
  }
  std::printf("\n");
}

int ReadScans(mrpt::hwdrivers::CSickLaserSerial& device, int count)
{
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  while (count > 0 && std::chrono::steady_clock::now() < end)
  {
    bool hasScan = false;
    bool hasFailed = false;
    mrpt::obs::CObservation2DRangeScan scan;
    device.doProcessSimple(hasScan, scan, hasFailed);
    if (hasScan)
    {
      Print(scan);
      --count;
    }
    else
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  return count == 0 ? 0 : 1;
}
} // namespace

int main(int argc, char* argv[])
{
  if (argc != 7)
  {
    std::fprintf(stderr, "usage: readWithMRPT PORT RATE MM ANGLE RESOLUTION SCANS\n");
    return 2;
  }
  try
  {
    mrpt::hwdrivers::CSickLaserSerial device;
    device.setSerialPort(argv[1]);
    device.setBaudRate(std::atoi(argv[2]));
    device.setMillimeterMode(std::string(argv[3]) == "1");
    device.setScanFOV(std::atoi(argv[4]));
    device.setScanResolution(std::atoi(argv[5]));
    return ReadScans(device, std::atoi(argv[6]));
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
