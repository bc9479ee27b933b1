// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dClientActions.h"

#include "Client/lms3dRemoteData.h"
#include "Client/lms3dRemoteScan.h"
#include "lms3dClientFiles.h"

#include <vtkNew.h>
#include <vtkPolyData.h>

#include <chrono>
#include <iostream>
#include <limits>
#include <stdexcept>

namespace
{
constexpr CORBA::ULong WaitMilliseconds = 5000;
constexpr std::chrono::milliseconds Pause(500);

// Waits as long as the server lives and makes scans, because the next scan may take long.
LMS3D::ScanHeader_var WaitForScan(
  LMS3D::LaserScanner_ptr scanner, CORBA::ULongLong after, CORBA::ULongLong generation)
{
  for (;;)
  {
    try
    {
      return lms3dWaitForScan(scanner, after, generation, WaitMilliseconds, Pause);
    }
    catch (const LMS3D::NoScanYet&)
    {
      const LMS3D::Status_var status = scanner->getStatus();
      if (*status->problem)
      {
        throw std::runtime_error(std::string("the server has no scan: ") + status->problem.in());
      }
      if (status->newest < after || status->generation < generation)
      {
        throw std::runtime_error("the server was restarted");
      }
    }
  }
}

// The server drops old scans, so a slow client may have to try again.
lms3dRemoteScan FetchNewest(LMS3D::LaserScanner_ptr scanner)
{
  constexpr int MaximumTries = 5;
  for (int i = 1;; ++i)
  {
    try
    {
      const LMS3D::ScanHeader_var header = WaitForScan(scanner, 0, 0);
      return lms3dFetchScan(scanner, header);
    }
    catch (const LMS3D::ScanGone&)
    {
      if (i == MaximumTries)
      {
        throw;
      }
    }
  }
}
} // namespace

void lms3dRequireOutput()
{
  if (!std::cout.flush())
  {
    throw std::runtime_error("the standard output cannot be written");
  }
}

CORBA::ULongLong lms3dWaitForNextScan(LMS3D::LaserScanner_ptr scanner, CORBA::ULongLong after)
{
  const LMS3D::ScanHeader_var header = WaitForScan(scanner, after, 0);
  return header->number;
}

void lms3dPrintHeader(const LMS3D::ScanHeader& header)
{
  const LMS3D::Vector3& position = header.sensorPose.position;
  std::cout << "scan " << header.number << " (generation " << header.generation << ") of "
            << header.scene << " from " << position.x << ' ' << position.y << ' ' << position.z
            << ": " << header.returns << " of " << header.beams << " beams returned, map of "
            << header.mapTriangles << " triangles, "
            << static_cast<double>(header.endTime - header.startTime) * 1e-6 << " ms\n";
  lms3dRequireOutput();
}

void lms3dPrintFirst(LMS3D::LaserScanner_ptr scanner, CORBA::ULongLong generation)
{
  const LMS3D::ScanHeader_var header = WaitForScan(scanner, 0, generation);
  lms3dPrintHeader(header);
}

void lms3dPrintStatus(CORBA::ORB_ptr, LMS3D::LaserScanner_ptr scanner)
{
  const LMS3D::Status_var status = scanner->getStatus();
  const LMS3D::Scene_var scene = scanner->getScene();
  std::cout << "LMS3D " << status->version << ", " << status->newest << " scans, "
            << status->lateScans << " late, rate " << status->rate << " Hz"
            << (status->isReadOnly ? ", read-only" : "") << '\n'
            << "scene " << scene->name << ", " << scene->triangles << " triangles\n";
  if (*status->problem)
  {
    std::cout << "no scan: " << status->problem << '\n';
  }
  if (status->newest != 0)
  {
    const LMS3D::ScanHeader_var header = scanner->getHeader();
    lms3dPrintHeader(header);
  }
}

void lms3dPrintScenes(CORBA::ORB_ptr, LMS3D::LaserScanner_ptr scanner)
{
  LMS3D::SceneNames_var names = scanner->listScenes();
  for (CORBA::ULong i = 0; i < names->length(); ++i)
  {
    std::cout << names[i] << '\n';
  }
}

void lms3dPrintBeams(CORBA::ORB_ptr, LMS3D::LaserScanner_ptr scanner)
{
  LMS3D::Data_var triples = scanner->fetch();
  std::cout.precision(std::numeric_limits<CORBA::Float>::max_digits10);
  std::cout << "r, m\talpha, deg\tbeta, deg\n";
  for (CORBA::ULong i = 0; i + 2 < triples->length(); i += 3)
  {
    std::cout << triples[i] << '\t' << triples[i + 1] << '\t' << triples[i + 2] << '\n';
  }
}

void lms3dSaveScan(LMS3D::LaserScanner_ptr scanner, const std::vector<std::string>& files)
{
  const lms3dRemoteScan remote = FetchNewest(scanner);
  vtkNew<vtkPolyData> scan;
  lms3dFillScan(remote, scan);
  lms3dWriteFile(scan, files[0]);
  if (files.size() > 1)
  {
    vtkNew<vtkPolyData> map;
    lms3dFillMap(remote, map);
    lms3dWriteFile(map, files[1]);
  }
  lms3dPrintHeader(remote.Header);
}

void lms3dWatchScans(LMS3D::LaserScanner_ptr scanner, CORBA::ULongLong count)
{
  CORBA::ULongLong last = 0;
  for (; count > 0; --count)
  {
    const LMS3D::ScanHeader_var header = WaitForScan(scanner, last, 0);
    lms3dPrintHeader(header);
    last = header->number;
  }
}

void lms3dMoveSensor(LMS3D::LaserScanner_ptr scanner, const LMS3D::Vector3& position,
  const std::optional<LMS3D::Vector3>& orientation)
{
  LMS3D::Pose pose = scanner->getPose();
  pose.position = position;
  pose.orientation = orientation.value_or(pose.orientation);
  lms3dPrintFirst(scanner, scanner->setPose(pose));
}

void lms3dSelectScene(LMS3D::LaserScanner_ptr scanner, const std::string& name)
{
  lms3dPrintFirst(scanner, scanner->selectScene(name.c_str()));
}
