// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Random scans of 20 scenes with the errors of a device, and the map that each is to have.
 */
#ifndef DamagedScans_h
#define DamagedScans_h

#include "Fixtures/ScanDamage.h"
#include "LocalMap/MapLaws.h"
#include "LocalMap/MapScenes.h"

#include <string>

/// The scenes of GetMapSceneNames(), and random ones.
constexpr int NumberOfDamagedScenes = 20;

/// Everything depends on the seed. Seeds with the same remainder by 20 have the same scene.
struct DamagedScan
{
  explicit DamagedScan(int seed);

  vtkSmartPointer<vtkPolyData> MakeMap() const;
  MapPromise GetPromise() const;
  std::string Describe() const;

  int Seed;
  std::string SceneName;
  MapScene Scene;
  ScanDamage Errors;
  MapPromise Promise;
  vtkSmartPointer<vtkPolyData> Ideal;
  vtkSmartPointer<vtkPolyData> Damaged;
};

/// How far returns were moved along their beams, at most, except stray returns. Metres.
double GetLargestMove(vtkPolyData* ideal, vtkPolyData* damaged, const ScanDamage& errors);

#endif
