// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Finds the nearest triangle along each beam of a packet.
 */
#ifndef lms3dRayCaster_h
#define lms3dRayCaster_h

#include "lms3dTriangleMesh.h"
#include "lms3dTriangleTest.h"

#include <memory>
#include <utility>

class lms3dRayCaster
{
public:
  /// The numbers are those of vtkLMS3DScanFilter::IntersectionMethods.
  enum class Method
  {
    Exact = 0,
    Fast = 1
  };

  /**
   * Takes the mesh over and builds the acceleration structure, with the threads of the calling TBB
   * arena. Throws std::runtime_error where Embree fails, for want of memory for instance.
   */
  static std::unique_ptr<lms3dRayCaster> New(Method method, lms3dTriangleMesh mesh);

  virtual ~lms3dRayCaster() = default;
  lms3dRayCaster(const lms3dRayCaster&) = delete;
  lms3dRayCaster& operator=(const lms3dRayCaster&) = delete;

  /**
   * Casts the active beams of a packet from `origin`, and fills its Range and Triangle with the
   * nearest hit at a range above 0 and up to `maximumRange`. May be called from many threads.
   */
  virtual void Cast(const double origin[3], double maximumRange, lms3dBeamPacket& packet) const = 0;

  const lms3dTriangleMesh& GetMesh() const { return this->Mesh; }

protected:
  explicit lms3dRayCaster(lms3dTriangleMesh mesh)
    : Mesh(std::move(mesh))
  {
  }

private:
  lms3dTriangleMesh Mesh;
};

#endif
