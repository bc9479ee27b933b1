// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief An affine map of space, and those that VRML's Transform node is made of.
 */
#ifndef lms3dTransform_h
#define lms3dTransform_h

#include <array>

/// Maps column vectors: (a * b) applies b first.
class lms3dTransform
{
public:
  /// The identity.
  lms3dTransform() = default;

  static lms3dTransform Translation(const std::array<double, 3>& offset);
  static lms3dTransform Scale(const std::array<double, 3>& factors);
  /// About x, y, z by the fourth number, in radians; the identity where the axis has no length.
  static lms3dTransform Rotation(const std::array<double, 4>& axisAndAngle);
  /// Whose columns are the images of the x, y and z axes.
  static lms3dTransform Frame(
    const std::array<double, 3>& x, const std::array<double, 3>& y, const std::array<double, 3>& z);

  lms3dTransform operator*(const lms3dTransform& first) const;
  std::array<double, 3> Apply(const std::array<double, 3>& point) const;

  /// A length that no vector of length 1 exceeds once it is mapped; for similarities, their factor.
  double GetLargestScale() const;

  /// Whether it turns right hands into left hands.
  bool IsMirror() const;

  /// Whether all points with coordinates up to this size have finite images.
  bool IsFinite(double largestCoordinate) const;

private:
  /// The last column is the translation.
  std::array<std::array<double, 4>, 3> Rows = { { { 1, 0, 0, 0 }, { 0, 1, 0, 0 },
    { 0, 0, 1, 0 } } };
};

#endif
