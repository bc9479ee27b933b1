// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Scans to map: of scenes, of synthetic ranges, with noise, with misses.
 */
#ifndef MapFixtures_h
#define MapFixtures_h

#include "Fixtures/ScanDamage.h"
#include "LocalMap/MapLaws.h"
#include "LocalMap/MapScenes.h"

#include <cstdint>
#include <functional>
#include <vector>

/// A scan of a scene, with the array Status if a test wants it.
vtkSmartPointer<vtkPolyData> MakeScan(const MapScene& scene, bool hasStatus = false);

/// `getRange` returns the range of each turn and beam, metres, 0 for no return. The sensor is at
/// the origin.
vtkSmartPointer<vtkPolyData> MakeScan(const std::vector<double>& alphas,
  const std::vector<double>& betas, const std::function<double(int turn, int number)>& getRange);

/// `count` angles in equal steps, ends included.
std::vector<double> MakeAngles(double first, double last, int count);

/// The same returns, each moved along its beam by a normally distributed distance of at most 4
/// sigma and half of its range.
vtkSmartPointer<vtkPolyData> AddNoise(vtkPolyData* scan, double sigma, Random& random);

/// The same scan with its turns in reverse order.
vtkSmartPointer<vtkPolyData> ReverseTurns(vtkPolyData* scan);
/// The same scan with the beams of each turn in reverse order.
vtkSmartPointer<vtkPolyData> ReverseFan(vtkPolyData* scan);

vtkSmartPointer<vtkPolyData> MakeMap(
  vtkPolyData* scan, double maximumError, int threads = 0, double depthStep = 0.1);

/// A hash of all arrays of a map.
std::uint64_t HashMap(vtkPolyData* map);

/// Fails the test, with a description, if the map breaks a law.
MapVerdict ExpectLawful(vtkPolyData* scan, vtkPolyData* map, const MapPromise& promise);
MapVerdict ExpectLawful(vtkPolyData* scan, const MapPromise& promise);

/// Fails the test if the surface is not closed.
void ExpectClosed(const MapVerdict& verdict);

#endif
