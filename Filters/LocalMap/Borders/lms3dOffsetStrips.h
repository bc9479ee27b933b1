// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The strips of triangles that close the surface along offsets.
 */
#ifndef lms3dOffsetStrips_h
#define lms3dOffsetStrips_h

#include "LocalMap/Borders/lms3dBorderRanges.h"

#include <array>
#include <cstdint>
#include <vector>

/**
 * Along an offset (see lms3dBorderGates), each side has its own border. The two lie so close
 * together that no beam passes between them. A strip of triangles joins them, so that the surface
 * has no gap.
 */
class lms3dOffsetStrips
{
public:
  /// Numbers of vertices, counter-clockwise as the sensor sees them.
  using Triangle = std::array<std::int32_t, 3>;

  /// Keeps a reference to the vertices of the map.
  explicit lms3dOffsetStrips(const std::vector<lms3dMapVertex>& vertices)
    : Vertices(vertices)
  {
  }

  /// Adds the triangles between two borders of equally many vertices in the same order, the first
  /// border to the left of the second. Returns false if a triangle faces away from the sensor: the
  /// strip is flipped there.
  bool AddStrip(const std::vector<std::int32_t>& own, const std::vector<std::int32_t>& other);

  /// Closes the hole of three or four vertices, counter-clockwise, that strips leave in a cell
  /// where they meet. Smaller holes need no triangle.
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
