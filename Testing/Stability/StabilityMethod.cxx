// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "StabilityMethod.h"

#include "Casting/lms3dAngleSumTest.h"
#include "Casting/lms3dBruteForceCaster.h"
#include "Casting/lms3dRayCaster.h"
#include "Scene/lms3dSceneTriangles.h"

#include <iterator>
#include <memory>

namespace
{
using NewCaster = std::function<std::unique_ptr<lms3dRayCaster>(lms3dTriangleMesh)>;

std::vector<double> CastWith(const lms3dRayCaster& caster, const std::vector<StabilityShot>& shots)
{
  std::vector<double> ranges;
  ranges.reserve(shots.size() * lms3dBeamPacket::Size);
  for (const StabilityShot& shot : shots)
  {
    lms3dBeamPacket packet = MakePacket(shot.Directions);
    const Vector& sensor = shot.Sensor;
    caster.Cast({ { sensor[0], sensor[1], sensor[2] }, lms3dBeamPacket::NoRange }, &packet, 1);
    ranges.insert(ranges.end(), std::begin(packet.Range), std::end(packet.Range));
  }
  return ranges;
}

StabilityMethod MakeMethod(const std::string& name, const NewCaster& newCaster)
{
  return { name,
    [newCaster](const lms3dTriangleMesh& mesh) -> StabilityCaster
    {
      const std::shared_ptr<const lms3dRayCaster> caster =
        newCaster(lms3dCollectTriangles(MakeSurface(mesh)).Mesh);
      return [caster](const std::vector<StabilityShot>& shots) { return CastWith(*caster, shots); };
    } };
}

/// A tolerance of 10 to the power of Exponent.
template <int Exponent>
class ForgivingTest : public lms3dAngleSumTest
{
public:
  explicit ForgivingTest(const lms3dSensorFrameTriangle& triangle)
    : lms3dAngleSumTest(triangle, { std::pow(10.0, Exponent), 0.0 })
  {
  }
};

/// Exactly 2 pi.
class StrictTest : public lms3dAngleSumTest
{
public:
  explicit StrictTest(const lms3dSensorFrameTriangle& triangle)
    : lms3dAngleSumTest(triangle, { 0.0, 0.0 })
  {
  }
};

template <typename TestT>
StabilityMethod MakeAngleSum(const std::string& name)
{
  return MakeMethod(name,
    [](lms3dTriangleMesh mesh)
    { return std::make_unique<lms3dBruteForceCaster<TestT>>(std::move(mesh)); });
}
} // namespace

std::vector<StabilityMethod> GetFilterMethods()
{
  std::vector<StabilityMethod> methods;
  methods.reserve(lms3dRayCaster::GetNumberOfMethods());
  for (int method = 0; method < lms3dRayCaster::GetNumberOfMethods(); ++method)
  {
    methods.push_back(MakeMethod(lms3dRayCaster::GetMethodName(method),
      [method](lms3dTriangleMesh mesh) { return lms3dRayCaster::New(method, std::move(mesh)); }));
  }
  return methods;
}

std::vector<StabilityMethod> GetAngleSumMethods()
{
  return { MakeAngleSum<StrictTest>("sum = 2 pi"),
    MakeAngleSum<ForgivingTest<-12>>("sum within 1e-12"),
    MakeAngleSum<ForgivingTest<-9>>("sum within 1e-9"),
    MakeAngleSum<ForgivingTest<-3>>("sum within 1e-3") };
}
