// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The inputs of a fusion, and which of them it has already.
 */
#ifndef lms3dFusionInputs_h
#define lms3dFusionInputs_h

#include <vtkType.h>

#include <cstdint>
#include <set>
#include <vector>

class vtkAlgorithm;
class vtkInformationVector;
class vtkPolyData;

/// A local map and the scan from which it was made.
struct lms3dFusionInput
{
  vtkPolyData* Map;
  vtkPolyData* Scan;
};

/// Returns the inputs of ports 0 and 1. Throws std::runtime_error, with a text for the user, if the
/// ports have different numbers of connections.
std::vector<lms3dFusionInput> lms3dGetFusionInputs(vtkInformationVector** inputVector);

/// Knows a scan by its ranges and its pose.
class lms3dFusionInputs
{
public:
  /// Returns whether the map of the scans so far is not a part of the map of these inputs:
  /// something upstream was modified, or, without time steps, a connection was removed.
  bool BeginNewMap(vtkAlgorithm* filter, const std::vector<lms3dFusionInput>& inputs);

  bool Has(const lms3dFusionInput& input) const;
  void Remember(const lms3dFusionInput& input);
  void Clear();

private:
  std::set<std::uint64_t> Known;
  std::vector<vtkMTimeType> UpstreamTimes;
};

#endif
