// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A journey through Data/building.wrl, whose local maps are joined to one map.
 */
#ifndef FusionJourney_h
#define FusionJourney_h

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <memory>
#include <vector>

class VisibleScene;
class vtkLMS3DMapFusion;
class vtkLMS3DScanFilter;
class vtkLMS3DSurfaceReconstructionFilter;

/// Milliseconds for each pose, the mean over some poses.
struct FusionTimes
{
  double Scan = 0.0;
  double Map = 0.0;
  double Fusion = 0.0;
  double SlowestFusion = 0.0;
};

struct FusionSizes
{
  vtkIdType Triangles;
  vtkIdType TrianglesOfAllMaps;
  /// What the part of the scene that the beams hit needs (VisibleScene).
  vtkIdType TrianglesOfScene;
  /// The share of what some of the poses see that is within 1 cm of the map.
  double Completeness;
  double CompletenessOfAllMaps;
  /// What the CORBA server sends to a client that has the map before the last pose, and to a new
  /// client: 12 bytes for each point and each triangle, and for each region that changed.
  double ChangedBytes;
  double Bytes;
};

class FusionJourney
{
public:
  /// Maps and fusion within 1 cm. Throws std::runtime_error if the files in Data cannot be read.
  explicit FusionJourney(int threads);
  ~FusionJourney();
  FusionJourney(const FusionJourney&) = delete;
  FusionJourney& operator=(const FusionJourney&) = delete;

  /// Drives until the map has a number of poses. The times are the means over the poses on the way.
  FusionTimes DriveTo(int poses);

  FusionSizes Measure();

private:
  void DriveOneStep(FusionTimes& sum);
  double GetCompleteness(vtkPolyData* map) const;

  vtkSmartPointer<vtkPolyData> Scene;
  std::unique_ptr<VisibleScene> Visible;
  vtkNew<vtkLMS3DScanFilter> Sensor;
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> Mapper;
  vtkNew<vtkLMS3DMapFusion> Fusion;
  std::vector<vtkSmartPointer<vtkPolyData>> Maps;
  /// The scans of a few poses.
  std::vector<vtkSmartPointer<vtkPolyData>> Views;
  int RevisionBefore = 0;
};

#endif
