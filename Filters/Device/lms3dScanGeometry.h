// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The angles of the device and the directions of its beams.
 *
 * Only this file contains the geometry of the founding paper (Bedkowski, Kretkiewicz and Maslowski,
 * "3D laser range finder simulation based on rotated LMS SICK 200", section 2.1). The sensor frame
 * is right-handed with z up. A beam with elevation alpha in the fan and platform angle beta has the
 * direction
 *
 *     d(alpha, beta) = (cos(alpha) cos(beta), -cos(alpha) sin(beta), sin(alpha)),
 *
 * which is the paper's M = Mz(beta) My(alpha) applied to the column vector (1, 0, 0). Beta turns
 * clockwise, seen from above. Alpha is an elevation, although the paper calls it "horizontal".
 * lms3dPlatform.h adds the other ways to mount the fan.
 */
#ifndef lms3dScanGeometry_h
#define lms3dScanGeometry_h

#include "Device/lms3dPlatform.h"
#include "Pipeline/lms3dSerialNumber.h"

#include <array>
#include <cstdint>
#include <vector>

/// Computes sine and cosine of an angle in degrees. They are exact at each multiple of 90, and
/// equal at 45.
void lms3dSinCosDegrees(double degrees, double& sine, double& cosine);

/// Returns whether an angle is 360 degrees within 1e-6.
bool lms3dIsFullCircle(double extent);

/// A rigid transform from the sensor frame to the world.
struct lms3dPose
{
  /// Metres, world coordinates.
  std::array<double, 3> Position;

  /// The sensor's x, y and z axes in world coordinates, orthonormal.
  std::array<std::array<double, 3>, 3> Axes;

  /// `position` is in metres; `orientation` is in degrees about x, y and z, applied as vtkProp3D
  /// does: RotateZ, RotateX, RotateY.
  static lms3dPose FromOrientation(const double position[3], const double orientation[3]);
};

/// The ranges at which a beam gives a return, metres, both included.
struct lms3dRangeLimits
{
  double Minimum;
  double Maximum;
};

/// The angles of a scan, in degrees.
class lms3dScanGeometry
{
public:
  /**
   * Divides both ranges (degrees) into equal steps, ends included, except the end of a full circle
   * of beta, which would repeat its start. A resolution of 1 gives only the start of the range.
   * Resolutions must be at least 1.
   */
  lms3dScanGeometry(const double alphaRange[2], int alphaResolution, const double betaRange[2],
    int betaResolution, const lms3dPlatform& platform = {});

  /// Takes the angles of an existing scan, degrees. Both must have at least one.
  lms3dScanGeometry(std::vector<double> alphaAngles, std::vector<double> betaAngles,
    const lms3dPlatform& platform = {});

  /// Returns the step of a range as the first constructor divides it, degrees; 0 for a resolution
  /// of 1.
  static double GetStep(const double range[2], int resolution);

  int GetNumberOfBeams() const { return static_cast<int>(this->AlphaAngles.size()); }
  int GetNumberOfTurns() const { return static_cast<int>(this->BetaAngles.size()); }

  /// The size of the grid: the beams of all turns.
  std::int64_t CountBeamsOfAllTurns() const
  {
    return static_cast<std::int64_t>(this->GetNumberOfBeams()) * this->GetNumberOfTurns();
  }

  /// Returns a number that no other geometry has or had, except copies.
  std::uint64_t GetSerialNumber() const { return this->SerialNumber; }

  const lms3dPlatform& GetPlatform() const { return this->Platform; }

  const std::vector<double>& GetAlphaAngles() const { return this->AlphaAngles; }
  const std::vector<double>& GetBetaAngles() const { return this->BetaAngles; }

  ///@{
  /// Returns the angle between neighbouring beams, or turns, degrees. It is 0 if there is only one,
  /// and negative if the angles decrease.
  double GetAlphaStep() const;
  double GetBetaStep() const;
  ///@}

  /// Returns whether the turn after the last would repeat the first.
  bool IsClosed() const;

  /// Returns whether exactly one of alpha and beta decreases, so that the grid is a mirror image.
  /// Not for fans along the axis: their two halves are mirror images of one another.
  bool IsMirrored() const;

  /// Returns whether the beam lies on the platform's axis, so that it is the same in every turn.
  bool IsPole(int beam) const;

  /// Sine and cosine of the elevation above the platform's plane (lms3dPlatform.h), one value for
  /// each beam.
  const std::vector<double>& GetAlphaSines() const { return this->AlphaSines; }
  const std::vector<double>& GetAlphaCosines() const { return this->AlphaCosines; }

  double GetAlphaSine(int beam) const { return this->AlphaSines[beam]; }
  double GetAlphaCosine(int beam) const { return this->AlphaCosines[beam]; }
  double GetBetaSine(int turn) const { return this->BetaSines[turn]; }
  double GetBetaCosine(int turn) const { return this->BetaCosines[turn]; }

private:
  void FillTables();

  std::uint64_t SerialNumber = lms3dMakeSerialNumber();
  lms3dPlatform Platform;
  std::vector<double> AlphaAngles;
  std::vector<double> AlphaSines;
  std::vector<double> AlphaCosines;
  std::vector<double> BetaAngles;
  std::vector<double> BetaSines;
  std::vector<double> BetaCosines;
};

/**
 * The directions of a sensor's beams in world coordinates, of length 1 up to rounding, for a
 * platform that stands still during each fan. A direction is the axis F of the turn's frame
 * (lms3dPlatform.h) times the cosine of the elevation, plus the platform's axis A, "up", times its
 * sine.
 */
class lms3dBeamDirections
{
public:
  /// The geometry must outlive the object.
  lms3dBeamDirections(const lms3dScanGeometry& geometry, const lms3dPose& pose);

  const std::array<double, 3>& GetFanAxis(int turn) const { return this->FanAxes[turn]; }
  const std::array<double, 3>& GetUp() const { return this->Up; }

  std::array<double, 3> GetDirection(int turn, int beam) const
  {
    const std::array<double, 3>& fan = this->FanAxes[turn];
    const double cosine = this->Geometry.GetAlphaCosine(beam);
    const double sine = this->Geometry.GetAlphaSine(beam);
    return { cosine * fan[0] + sine * this->Up[0], cosine * fan[1] + sine * this->Up[1],
      cosine * fan[2] + sine * this->Up[2] };
  }

private:
  const lms3dScanGeometry& Geometry;
  std::vector<std::array<double, 3>> FanAxes;
  const std::array<double, 3> Up;
};

#endif
