// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dClientFusedMap.h"

#include "Client/lms3dRemoteFusedMap.h"
#include "lms3dClientActions.h"
#include "lms3dClientFiles.h"

#include <vtkNew.h>
#include <vtkPolyData.h>

#include <iostream>

namespace
{
void Print(const lms3dRemoteFusedMap& map)
{
  const LMS3D::FusedMapHeader& header = map.GetHeader();
  std::cout << "map of " << header.scans << " scans of " << header.scene << ", "
            << header.allTriangles << " triangles: " << (header.isWhole ? "all " : "changed ")
            << header.regions << " regions, " << header.triangles << " triangles, "
            << map.GetReceivedBytes() << " bytes, " << header.seconds * 1e3 << " ms\n";
  if (*header.problem)
  {
    std::cout << "the newest scan is not in the map: " << header.problem << '\n';
  }
  lms3dRequireOutput();
}
} // namespace

void lms3dSaveFusedMap(LMS3D::LaserScanner_ptr scanner, const std::string& file)
{
  lms3dWaitForNextScan(scanner, 0);
  lms3dRemoteFusedMap map;
  map.Update(scanner);
  vtkNew<vtkPolyData> data;
  map.Fill(data);
  lms3dWriteFile(data, file);
  Print(map);
}

// A scan is in the map before it is published.
void lms3dWatchFusedMap(LMS3D::LaserScanner_ptr scanner, CORBA::ULongLong count)
{
  lms3dRemoteFusedMap map;
  CORBA::ULongLong last = 0;
  while (count > 0)
  {
    last = lms3dWaitForNextScan(scanner, last);
    if (map.Update(scanner))
    {
      Print(map);
      --count;
    }
  }
}

void lms3dResetFusedMap(CORBA::ORB_ptr, LMS3D::LaserScanner_ptr scanner)
{
  lms3dPrintFirst(scanner, scanner->resetFusedMap());
}
