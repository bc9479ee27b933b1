// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Scans with gaps and speckles, and what their maps say about these.
 */
#ifndef GapFixtures_h
#define GapFixtures_h

#include "LocalMap/PlatformFixtures.h"

#include <vector>

/// A beam in the grid of a scan.
struct GapBeam
{
  int Turn;
  int Beam;
};

/**
 * A plane wall 3 m ahead of the sensor, seen by 41 turns of 41 beams, one degree apart. The middle
 * beam of the middle turn meets the wall at a right angle.
 */
class WallScan
{
public:
  static constexpr int Size = 41;
  static constexpr int Middle = Size / 2;
  static constexpr double Distance = 3.0;

  WallScan();

  /// Takes the returns of beams away.
  WallScan& Lose(const std::vector<GapBeam>& beams);
  /// Sets the range of a beam, metres.
  WallScan& Set(const GapBeam& beam, double range);
  double GetRange(const GapBeam& beam) const { return this->Ranges[GetBeamId(beam)]; }
  static int GetBeamId(const GapBeam& beam) { return beam.Turn * Size + beam.Beam; }

  vtkSmartPointer<vtkPolyData> Make() const;

private:
  std::vector<double> Ranges;
};

/// The square of `size` x `size` beams from a beam on.
std::vector<GapBeam> GetSquare(const GapBeam& first, int size);

/// Adds the array Status: `value` for each of the beams, 0 for the others.
void AddStatus(vtkPolyData* scan, const std::vector<int>& beamIds, int value);

/// The same scan with a share of its returns moved along their beams to random ranges. All beams
/// must start at the sensor's position.
vtkSmartPointer<vtkPolyData> AddStrays(vtkPolyData* scan, double share, Random& random);

/// Properties of the filter.
struct GapProperties
{
  int MaximumGapSize = 0;
  int MaximumSpeckleSize = 0;
  bool KeepSpeckles = true;
  double MaximumError = 0.01;
  int NumberOfThreads = 0;
};

vtkSmartPointer<vtkPolyData> MakeMap(vtkPolyData* scan, const GapProperties& properties);

/// All values of a field data array.
std::vector<int> GetFieldValues(vtkPolyData* map, const char* name);

/// How often the ray from the origin in the direction of a beam of a WallScan meets triangles of
/// the map.
int CountHits(vtkPolyData* map, const GapBeam& beam);
/// The sum of the numbers of returns on everything that they can be on.
double CountReturnsOnAll(vtkPolyData* map);

#endif
