// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Scans as a real device reports them: with beams lost, stray returns, noise and steps.
 */
#ifndef ScanDamage_h
#define ScanDamage_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <functional>
#include <string>
#include <vector>

/**
 * The errors of a device. What happens to a beam depends only on Seed and on the turn and number of
 * the beam, so it does not depend on the other returns of the scan.
 */
struct ScanDamage
{
  /// What is lost together: single beams; stripes of 5 to 20 beams along a fan or along a turn;
  /// discs with radii of 1 to 3 beams.
  enum class Shapes
  {
    SingleBeams,
    Stripes,
    Blobs
  };

  /// The share of all beams without a return.
  double Dropouts = 0.0;
  Shapes Shape = Shapes::SingleBeams;
  /// The share of all beams whose returns come from a random place before the surface, as from
  /// dust.
  double Strays = 0.0;
  /// Metres: RangeNoise and RangeResolution of vtkLMS3DRangeErrorFilter.
  double Noise = 0.0;
  double Steps = 0.0;
  int Seed = 0;

  bool IsStray(int beam) const;
  /// Whether each beam of the grid, turn by turn, is lost.
  std::vector<bool> FindDropouts(int numberOfBeams, int numberOfTurns) const;
  /// One line.
  std::string Describe() const;
};

/// The returns for which `isKept` returns true.
vtkSmartPointer<vtkPolyData> Keep(
  vtkPolyData* scan, const std::function<bool(vtkIdType number)>& isKept);

/// The scan with these errors. If it has the array Status, lost beams are TOO_WEAK there. The
/// mirror must be on the axis.
vtkSmartPointer<vtkPolyData> Damage(vtkPolyData* scan, const ScanDamage& damage);

#endif
