// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The returns of a scan in the grid of beams and turns, for tests that judge maps.
 *
 * It shares no code with the filter that it helps to judge. Points and directions are in axes
 * parallel to the world's, from the sensor.
 */
#ifndef ScanGrid_h
#define ScanGrid_h

#include "Fixtures/CasterFixtures.h"

#include <vtkType.h>

#include <array>
#include <map>
#include <string>
#include <vector>

class vtkPolyData;

class ScanGrid
{
public:
  static constexpr vtkIdType NoReturn = -1;

  /// A place in the grid, turns going round where the grid is closed.
  struct Beam
  {
    int Turn;
    int Number;
  };

  /// The grid that a direction lies in, counted in beams from the first one.
  struct Place
  {
    double Turn;
    double Number;
  };

  explicit ScanGrid(vtkPolyData* scan);

  int GetNumberOfTurns() const { return static_cast<int>(this->Betas.size()); }
  int GetNumberOfBeams() const { return static_cast<int>(this->Alphas.size()); }
  bool IsClosed() const { return this->Closed; }
  bool IsPole(int number) const;

  const std::vector<Vector>& GetPoints() const { return this->Points; }
  double GetRange(vtkIdType number) const { return this->Ranges[number]; }
  vtkIdType GetCellId(vtkIdType number) const { return this->CellIds[number]; }
  const Vector& GetSensor() const { return this->Sensor; }
  /// The number of a beam's return, or NoReturn. Of a pole, which all turns share, that of median
  /// range.
  vtkIdType GetReturn(const Beam& beam) const;
  /// All returns of a beam. For a beam at a pole, the returns of all turns.
  std::vector<vtkIdType> GetReturns(const Beam& beam) const;
  /// The beam that a return came along.
  Beam GetBeam(vtkIdType number) const;
  bool Contains(const Beam& beam) const;

  /// The direction of a place. Places with whole numbers are beams.
  Vector GetDirection(const Place& place) const;
  Place GetPlace(const Vector& direction) const;

  /// The beams that lie less than `steps` steps away along the fan and along the turn: of 1, the
  /// four around a place. Some may be outside of the grid. Straight lines between turns run above
  /// rows of beams, in wide turns by more than a step, and the rows up to them count as well.
  std::vector<Beam> GetBeamsAround(const Place& place, double steps) const;

  /// Radians.
  double GetElevation(int number) const;

  /// Radians between neighbours; that of the other direction where there is one beam, or one turn.
  double GetFanStep() const { return this->FanStep; }
  double GetTurnStep() const { return this->TurnStep; }
  /// The angle between opposite corners of the cells around a beam.
  double GetCellSize(const Beam& beam) const;

  std::string Describe(const Beam& beam) const;

private:
  void ReadReturns(vtkPolyData* scan);
  void JoinPole(int number);

  std::vector<double> Alphas;
  std::vector<double> Betas;
  bool Closed;
  double FanStep;
  double TurnStep;
  double Sag;
  Vector Sensor;
  std::array<Vector, 3> Axes;
  std::vector<Vector> Points;
  std::vector<double> Ranges;
  std::vector<int> BeamIds;
  std::vector<vtkIdType> CellIds;
  std::vector<vtkIdType> Returns;
  std::map<int, std::vector<vtkIdType>> ReturnsOfPoles;
};

#endif
