// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Scans to map: of scenes, of made-up ranges, with noise, with misses.
 */
#ifndef MapFixtures_h
#define MapFixtures_h

#include "LocalMap/MapLaws.h"
#include "LocalMap/MapScenes.h"

#include <cstdint>
#include <functional>
#include <vector>

vtkSmartPointer<vtkPolyData> MakeScan(const MapScene& scene);

/// The range of each turn and beam; beams of 0 give no return. The sensor is at the origin.
vtkSmartPointer<vtkPolyData> MakeScan(const std::vector<double>& alphas,
  const std::vector<double>& betas, const std::function<double(int turn, int number)>& getRange);

/// So many equal steps, ends included.
std::vector<double> MakeAngles(double first, double last, int count);

/// The same returns, each moved along its beam by a normally distributed distance: at most 4 sigma,
/// and half of its range.
vtkSmartPointer<vtkPolyData> AddNoise(vtkPolyData* scan, double sigma, Random& random);

/// The returns that are to be kept, by their number.
vtkSmartPointer<vtkPolyData> Keep(
  vtkPolyData* scan, const std::function<bool(vtkIdType number)>& isKept);

/// The same scan, told from its last turn to its first.
vtkSmartPointer<vtkPolyData> ReverseTurns(vtkPolyData* scan);
/// The same, each turn told from its last beam to its first.
vtkSmartPointer<vtkPolyData> ReverseFan(vtkPolyData* scan);

vtkSmartPointer<vtkPolyData> MakeMap(
  vtkPolyData* scan, double maximumError, int threads = 0, double depthStep = 0.1);

/// A fingerprint of all that a map has.
std::uint64_t HashMap(vtkPolyData* map);

/// Has the test fail, in words, where the map breaks a law.
MapVerdict ExpectLawful(vtkPolyData* scan, vtkPolyData* map, const MapPromise& promise);
MapVerdict ExpectLawful(vtkPolyData* scan, const MapPromise& promise);

/// Of a surface that all beams of a closed scan meet.
void ExpectClosed(const MapVerdict& verdict);

#endif
