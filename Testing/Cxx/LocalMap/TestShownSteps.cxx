// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks that maps bridge none of the depth steps that the returns show, in scans of all
 * resolutions, without and with noise.
 */
#include "Fixtures/SceneBuilder.h"
#include "LocalMap/MapFixtures.h"
#include "LocalMap/TrueSteps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

#ifndef LMS3D_FEWER_BEAMS
namespace
{
constexpr double DepthStep = 0.1;
// The bound of a map of a scan without noise, metres, and of one with noise, standard deviations.
constexpr double Bound = 0.01;
constexpr double BoundOfNoise = 4.0;
// The number of standard deviations of the noise by which planes must miss the returns, in addition
// to the depth step. If a plane lies nearly across the beams, and ranges are far above the noise,
// the distance of a return from the plane through two others has a standard deviation of 2.4 times
// that of the noise. This is lms3dDepthStep::Deviations times as much.
constexpr double MarginOfNoise = 11.0;
// The error of a return near the sensor is large in inverse range. By this number of standard
// deviations of the noise, each plane must miss the return there (lms3dDepthStep::Deviations).
constexpr double Deviations = 4.5;
// Metres.
constexpr double Noise = 0.005;
constexpr double LargeNoise = 0.02;

MapScene MakeRoomFrom(int place, int beams)
{
  MapScene scene = MakeMapScene("FurnishedRoom");
  Random random(static_cast<std::uint64_t>(place));
  if (place > 0)
  {
    scene.Position = { random.Get(-2.0, 3.0), random.Get(-2.0, 2.0), random.Get(0.6, 2.0) };
  }
  scene.AlphaResolution = beams;
  scene.BetaResolution = beams - 1;
  return scene;
}

/// A wall around a yard in a hall, with battlements and a round tower in each corner.
MapScene MakeCastleFrom(int place, int beams)
{
  SceneBuilder castle;
  castle.AddBox({ -30.0, -30.0, 0.0 }, { 30.0, 30.0, 25.0 });
  for (double side : { -20.0, 20.0 })
  {
    castle.AddBox({ side - 0.5, -20.0, 0.0 }, { side + 0.5, 20.0, 6.0 });
    castle.AddBox({ -20.0, side - 0.5, 0.0 }, { 20.0, side + 0.5, 6.0 });
    for (int merlon = -4; merlon <= 4; ++merlon)
    {
      const double at = 3.5 * merlon;
      castle.AddBox({ side - 0.5, at - 0.9, 6.0 }, { side + 0.5, at + 0.9, 7.2 });
      castle.AddBox({ at - 0.9, side - 0.5, 6.0 }, { at + 0.9, side + 0.5, 7.2 });
    }
    castle.AddCone({ side, side, 0.0 }, 3.0, 3.0, 11.0, 32);
    castle.AddCone({ side, -side, 0.0 }, 3.0, 3.0, 11.0, 32);
  }
  MapScene scene = { castle.GetSurface() };
  Random random(static_cast<std::uint64_t>(place));
  scene.Position = { random.Get(-14.0, 14.0), random.Get(-14.0, 14.0), random.Get(1.0, 9.0) };
  scene.AlphaResolution = beams;
  scene.BetaResolution = beams - 1;
  return scene;
}

// Every other slope. They are many, and only the share that is open counts.
std::vector<TrueSteps::Step> SelectSlopes(const TrueSteps& truth)
{
  std::vector<TrueSteps::Step> slopes;
  for (std::size_t i = 0; i < truth.GetSlopes().size(); i += 2)
  {
    slopes.push_back(truth.GetSlopes()[i]);
  }
  return slopes;
}

// More than by default if the environment variable LMS3D_RANDOM_ROOMS says so.
int GetNumberOfRandomRooms()
{
  constexpr int NumberOfRooms = 300;
  const char* const number = std::getenv("LMS3D_RANDOM_ROOMS");
  return number ? std::atoi(number) : NumberOfRooms;
}

/// Counts over many scans.
struct Count
{
  std::size_t Steps = 0;
  int Bridged = 0;
  std::size_t Slopes = 0;
  int Open = 0;

  void Add(const TrueSteps& truth, vtkPolyData* map, double noise)
  {
    const std::vector<TrueSteps::Step> shown =
      truth.FindShown(DepthStep + MarginOfNoise * noise, Deviations * noise);
    this->Steps += shown.size();
    this->Bridged += truth.CountBridged(map, shown);
    const std::vector<TrueSteps::Step> slopes = SelectSlopes(truth);
    this->Slopes += slopes.size();
    this->Open += truth.CountOpen(map, slopes);
  }

  /// A map of holes bridges no step either.
  void ExpectFewOpen() const
  {
    EXPECT_GT(this->Slopes, 5000U);
    EXPECT_LT(this->Open, 0.2 * static_cast<double>(this->Slopes));
  }
};

class ShownSteps : public testing::Test
{
protected:
  /// Makes maps of a scan without noise and with both noises.
  void AddMaps(const MapScene& scene, std::uint64_t seed)
  {
    const vtkSmartPointer<vtkPolyData> scan = MakeScan(scene);
    const TrueSteps truth(scan, scene.Surface, DepthStep, 0.0);
    this->Ideal.Add(truth, MakeMap(scan, Bound), 0.0);
    for (double sigma : { Noise, LargeNoise })
    {
      Random random(seed);
      (sigma == Noise ? this->Noisy : this->VeryNoisy)
        .Add(truth, MakeMap(AddNoise(scan, sigma, random), BoundOfNoise * sigma), sigma);
    }
  }

  void ExpectNoneOf(std::size_t ideal, std::size_t noisy) const
  {
    EXPECT_GT(this->Ideal.Steps, ideal);
    EXPECT_EQ(this->Ideal.Bridged, 0) << "of " << this->Ideal.Steps;
    EXPECT_GT(this->Noisy.Steps + this->VeryNoisy.Steps, noisy);
    EXPECT_EQ(this->Noisy.Bridged, 0) << "of " << this->Noisy.Steps;
    EXPECT_EQ(this->VeryNoisy.Bridged, 0) << "of " << this->VeryNoisy.Steps;
    this->ExpectFewOpen();
  }

  void ExpectFewOpen() const
  {
    this->Ideal.ExpectFewOpen();
    this->Noisy.ExpectFewOpen();
    this->VeryNoisy.ExpectFewOpen();
  }

  Count Ideal;
  Count Noisy;
  Count VeryNoisy;
};
} // namespace

TEST_F(ShownSteps, OfARoomAreNotBridged)
{
  for (int place = 0; place < 12; ++place)
  {
    this->AddMaps(MakeRoomFrom(place, 181), place);
  }
  this->ExpectNoneOf(1800, 3500);
}

TEST_F(ShownSteps, OfARoomAreNotBridgedInCoarseScans)
{
  for (int place = 0; place < 24; ++place)
  {
    for (int beams : { 46, 61, 91 })
    {
      this->AddMaps(MakeRoomFrom(place, beams), place);
    }
  }
  this->ExpectNoneOf(2000, 4000);
}

TEST_F(ShownSteps, OfACastleAreNotBridged)
{
  for (int place = 0; place < 6; ++place)
  {
    for (int beams : { 46, 91, 181 })
    {
      this->AddMaps(MakeCastleFrom(place, beams), place);
    }
  }
  this->ExpectNoneOf(1500, 3000);
}

// Rooms with balls, boxes and plates in any pose, at 2 to 60 turns of 2 to 61 beams. One sensor is
// nearer to a surface than three standard deviations of the large noise.
TEST_F(ShownSteps, OfRandomRoomsAreNotBridged)
{
  for (int seed = 0; seed < GetNumberOfRandomRooms(); ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed));
    this->AddMaps(MakeRandomMapScene(random), seed);
  }
  this->ExpectNoneOf(600, 1100);
}
#endif
