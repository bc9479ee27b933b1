// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief An affine map of space, and the maps that VRML's Transform node consists of.
 */
#ifndef lms3dTransform_h
#define lms3dTransform_h

#include <array>

/// A 3 x 4 matrix that maps column vectors: (a * b) applies b first.
class lms3dTransform
{
public:
  /// The identity.
  lms3dTransform() = default;

  static lms3dTransform Translation(const std::array<double, 3>& offset);
  static lms3dTransform Scale(const std::array<double, 3>& factors);
  /// Rotates about the axis (x, y, z) by the fourth number, in radians. Returns the identity if the
  /// axis has no length. The axis need not have length 1.
  static lms3dTransform Rotation(const std::array<double, 4>& axisAndAngle);
  /// The linear map with these columns: the images of the x, y and z axes.
  static lms3dTransform Frame(
    const std::array<double, 3>& x, const std::array<double, 3>& y, const std::array<double, 3>& z);

  lms3dTransform operator*(const lms3dTransform& first) const;
  std::array<double, 3> Apply(const std::array<double, 3>& point) const;

  /// Returns an upper bound of the factor by which the map stretches any vector. For a similarity
  /// the bound is the factor itself.
  double GetLargestScale() const;

  /// Returns whether the map reverses orientation (its determinant is negative).
  bool IsMirror() const;

  /// Returns whether every point with coordinates between -largestCoordinate and largestCoordinate
  /// has a finite image.
  bool IsFinite(double largestCoordinate) const;

private:
  /// The last column is the translation.
  std::array<std::array<double, 4>, 3> Rows = { { { 1, 0, 0, 0 }, { 0, 1, 0, 0 },
    { 0, 0, 1, 0 } } };
};

#endif
