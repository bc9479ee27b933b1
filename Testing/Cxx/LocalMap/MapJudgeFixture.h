// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A lawful map that tests break on purpose.
 */
#ifndef MapJudgeFixture_h
#define MapJudgeFixture_h

#include "LocalMap/MapFixtures.h"

#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

/// A ball seen from inside, and its plain grid, which is within 1 cm as well.
class MapJudge : public testing::Test
{
protected:
  using Triangle = std::array<vtkIdType, 3>;

  MapJudge();

  /// Makes the map the plain grid of the scan, with the field data of a bounded map.
  void TakeGrid();

  /// Adds a value to the field data.
  template <typename ArrayT>
  void AddValue(const char* name, double value)
  {
    vtkNew<ArrayT> array;
    array->SetName(name);
    array->InsertNextTuple1(value);
    this->Map->GetFieldData()->AddArray(array);
  }

  /// Adds a point with its arrays, and returns its number.
  vtkIdType AddPoint(const Vector& point);
  Vector GetPoint(vtkIdType number);
  /// Multiplies a point's range by a factor.
  void MovePoint(vtkIdType number, double factor);

  /// Adds a small triangle across the lower pole, or `aside` radians from it, at a share of the
  /// pole's range.
  void AddFacet(double aside, double factor);
  /// Multiplies the range of a return by a factor.
  void MoveReturn(vtkIdType number, double factor);

  /// Judges the map with Triangles as its cells.
  MapVerdict Judge();
  void ExpectBreach(const std::string& law);

  MapScene Scene;
  /// Scene becomes Promise.Scene.
  MapPromise Promise;
  vtkSmartPointer<vtkPolyData> Scan;
  vtkNew<vtkPolyData> Map;
  std::vector<Triangle> Triangles;

private:
  void ReadTriangles();
};

#endif
