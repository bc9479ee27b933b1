// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Scenes, and ways to look at results, that several tests share.
 */
#ifndef SceneFixtures_h
#define SceneFixtures_h

#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTestErrorObserver.h>

#include <array>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;
class vtkLMS3DScanFilter;

using Point = std::array<double, 3>;

/// A closed ball of triangles, its vertices at the radius.
vtkSmartPointer<vtkPolyData> MakeBall(double radius, int resolution = 48);

/// The distance of the nearest of a surface's planes from the origin.
double GetInradius(vtkPolyData* surface);

/// A rectangle over x and y at the height z, as one quadrilateral.
vtkSmartPointer<vtkPolyData> MakeFloor(double halfSize, double z);

vtkSmartPointer<vtkPolyData> MakePolygon(const std::vector<Point>& points);

/// One surface of both.
vtkSmartPointer<vtkPolyData> Join(vtkPolyData* a, vtkPolyData* b);

/// Scales the points of a surface about the origin, then moves them.
void ScaleAndMove(vtkPolyData* surface, double scale, const Point& offset);

/// Data/room.wrl.
vtkSmartPointer<vtkPolyData> ReadRoom();

/// Data/building.wrl.
vtkSmartPointer<vtkPolyData> ReadBuilding();

/// Data/teapot.wrl.
vtkSmartPointer<vtkPolyData> ReadTeapot();

/// A fingerprint of all bytes of an array, or of a data set's points, cells and arrays.
std::uint64_t Hash(vtkDataArray* array);
std::uint64_t Hash(vtkDataSet* data);

///@{
/// A scan of a scene, what it has measured, and where.
vtkSmartPointer<vtkLMS3DScanFilter> MakeScan(vtkDataObject* scene);
void SetGrid(vtkLMS3DScanFilter* scan, int beams, int turns);
vtkDataArray* GetArray(vtkLMS3DScanFilter* scan, const char* name);
double GetRange(vtkLMS3DScanFilter* scan, vtkIdType i);
///@}

///@{
/// What a test does to a filter that has scanned before. Shown by its name.
struct ScanChange
{
  const char* Name;
  void (*Apply)(vtkLMS3DScanFilter*);
};
void PrintTo(const ScanChange& change, std::ostream* os);

extern const ScanChange ToSameSize;
extern const ScanChange ToLarger;
extern const ScanChange ToSmaller;
extern const ScanChange ToNoReturns;
///@}

/// The paper's d(alpha, beta), written down independently of the filter. Degrees.
Point GetPaperDirection(double alpha, double beta);

/// The words of the errors that the algorithm gives in an Update(), empty if there is none.
std::string UpdateAndGetError(vtkAlgorithm* algorithm);

/// The words of the warnings. Fails the test if there is an error.
std::string UpdateAndGetWarning(vtkAlgorithm* algorithm);

/// The number of errors that the algorithm and its executive give if each output is updated, twice
/// and for two times, as ParaView's views do.
int UpdateAllAndCountErrors(vtkAlgorithm* algorithm);

#endif
