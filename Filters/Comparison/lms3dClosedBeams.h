// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The beams of a scan whose gaps its local map closes.
 */
#ifndef lms3dClosedBeams_h
#define lms3dClosedBeams_h

#include <vector>

class vtkFieldData;

class lms3dClosedBeams
{
public:
  /// Reads the field data `ClosedBeamIds` of a local map, and `AlphaAngles` and `BetaAngles` of its
  /// scan. Without them, there are no closed beams.
  lms3dClosedBeams(vtkFieldData* map, vtkFieldData* scan);

  bool IsEmpty() const { return this->IsClosed.empty(); }

  /// Whether one of the four beams around a place is closed. A closed gap reaches up to the beams
  /// around it. Degrees.
  bool AreBeside(double alpha, double beta) const;

private:
  std::vector<double> Alphas;
  std::vector<double> Betas;
  bool IsFullCircle = false;
  /// By turn, then by beam.
  std::vector<bool> IsClosed;
};

#endif
