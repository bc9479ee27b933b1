// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The triangles between the two borders along a step.
 */
#ifndef lms3dStepBands_h
#define lms3dStepBands_h

#include "LocalMap/Borders/lms3dBorderRanges.h"

#include <array>
#include <cstdint>
#include <vector>

/**
 * Along a step each side has its own border. The two lie so close that no beam passes between them,
 * and a band of triangles joins them, so that the surface stays whole.
 */
class lms3dOffsetStrips
{
public:
  using Triangle = std::array<std::int32_t, 3>;

  /// Keeps a reference.
  explicit lms3dOffsetStrips(const std::vector<lms3dMapVertex>& vertices)
    : Vertices(vertices)
  {
  }

  /// Between two lines of as many vertices, the first to the left; returns whether all triangles face
  /// the sensor.
  bool AddStrip(const std::vector<std::int32_t>& own, const std::vector<std::int32_t>& other);

  /// Where three or four steps meet in a cell, their bands leave a hole between the junctions.
  void FillHole(const std::vector<std::int32_t>& hole);

  const std::vector<Triangle>& GetTriangles() const { return this->Triangles; }

private:
  void AddQuad(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d);
  void AddTriangle(std::int32_t a, std::int32_t b, std::int32_t c);
  bool IsFacing(std::int32_t a, std::int32_t b, std::int32_t c) const;

  const std::vector<lms3dMapVertex>& Vertices;
  std::vector<Triangle> Triangles;
};

#endif
