// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The results of the filters without a server.
 */
#ifndef DirectPipeline_h
#define DirectPipeline_h

#include "Common/lms3dDeviceNames.h"
#include "LMS3DScanner.hh"

#include <cstdint>
#include <string>
#include <vector>

class vtkImageData;
class vtkPolyData;

/// Shares no code with the server.
struct DirectPipeline
{
  /// Scans with the device, as the server makes its scan of a number.
  DirectPipeline(const std::string& scene, const LMS3D::Pose& pose,
    const LMS3D::Configuration& configuration, const LMS3D::Device& device = lms3dGetIdealDevice(),
    CORBA::ULongLong number = 0);

  /// r, alpha, beta of each beam, r 0 without a return.
  std::vector<float> Triples;
  std::vector<float> Ranges;
  std::vector<double> ReturnPoints;
  std::vector<double> MapPoints;
  std::vector<std::uint32_t> MapTriangles;

private:
  void TakeScan(vtkImageData* image, vtkPolyData* scan);
  void TakeMap(vtkPolyData* map);
};

#endif
