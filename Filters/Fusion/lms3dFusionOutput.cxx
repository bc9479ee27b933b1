// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dFusionOutput.h"

#include "Geometry/lms3dTriangleDistance.h"
#include "Pipeline/lms3dArray.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cstddef>

namespace
{
/// The arrays of the output, and where the next region goes.
class Writer
{
public:
  Writer(std::size_t points, std::size_t triangles)
    : Coordinates(lms3dMakeArray<vtkDoubleArray>("Points", points, 3))
    , Connectivity(lms3dMakeArray<vtkIdTypeArray>("Connectivity", 3 * triangles))
    , Offsets(lms3dMakeArray<vtkIdTypeArray>("Offsets", triangles + 1))
    , Normals(lms3dMakeArray<vtkFloatArray>("Normals", triangles, 3))
    , BestScans(lms3dMakeArray<vtkIntArray>("BestScan", triangles))
    , ScanCounts(lms3dMakeArray<vtkIntArray>("ScanCount", triangles))
    , LastScans(lms3dMakeArray<vtkIntArray>("LastScan", triangles))
    , RegionIds(lms3dMakeArray<vtkIntArray>("RegionId", triangles))
    , Revisions(lms3dMakeArray<vtkIntArray>("Revision", triangles))
  {
    lms3dFillOffsets(this->Offsets->GetPointer(0), triangles, 3);
  }

  void Write(const lms3dNumberedMesh& region)
  {
    const lms3dFusedMesh& mesh = *region.Mesh;
    for (std::size_t i = 0; i < mesh.Triangles.size(); ++i)
    {
      this->WriteTriangle(mesh, i);
      this->RegionIds->SetValue(this->Triangle, region.RegionId);
      this->Revisions->SetValue(this->Triangle, region.Revision);
      ++this->Triangle;
    }
    for (const lms3dVector& point : mesh.Points)
    {
      std::copy(point.begin(), point.end(), this->Coordinates->GetPointer(3 * this->Point));
      ++this->Point;
    }
  }

  void MoveTo(vtkPolyData* output) const
  {
    vtkNew<vtkPoints> points;
    points->SetData(this->Coordinates);
    output->SetPoints(points);
    vtkNew<vtkCellArray> polygons;
    polygons->SetData(this->Offsets, this->Connectivity);
    output->SetPolys(polygons);
    output->GetCellData()->SetNormals(this->Normals);
    for (vtkIntArray* array : { this->BestScans.Get(), this->ScanCounts.Get(),
           this->LastScans.Get(), this->RegionIds.Get(), this->Revisions.Get() })
    {
      output->GetCellData()->AddArray(array);
    }
  }

private:
  void WriteTriangle(const lms3dFusedMesh& mesh, std::size_t i)
  {
    const lms3dFusedMesh::Triangle& corners = mesh.Triangles[i];
    vtkIdType* connectivity = this->Connectivity->GetPointer(3 * this->Triangle);
    for (int corner = 0; corner < 3; ++corner)
    {
      connectivity[corner] = this->Point + corners[corner];
    }
    const lms3dVector normal =
      lms3dNormalize(lms3dGetWeightedNormal({ mesh.Points[corners[0]].data(),
        mesh.Points[corners[1]].data(), mesh.Points[corners[2]].data() }));
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Normals->SetTypedComponent(this->Triangle, axis, static_cast<float>(normal[axis]));
    }
    const lms3dSightings& sightings = mesh.Sightings[i];
    this->BestScans->SetValue(this->Triangle, sightings.BestScan);
    this->ScanCounts->SetValue(this->Triangle, sightings.ScanCount);
    this->LastScans->SetValue(this->Triangle, sightings.LastScan);
  }

  const vtkSmartPointer<vtkDoubleArray> Coordinates;
  const vtkSmartPointer<vtkIdTypeArray> Connectivity;
  const vtkSmartPointer<vtkIdTypeArray> Offsets;
  const vtkSmartPointer<vtkFloatArray> Normals;
  const vtkSmartPointer<vtkIntArray> BestScans;
  const vtkSmartPointer<vtkIntArray> ScanCounts;
  const vtkSmartPointer<vtkIntArray> LastScans;
  const vtkSmartPointer<vtkIntArray> RegionIds;
  const vtkSmartPointer<vtkIntArray> Revisions;
  vtkIdType Point = 0;
  vtkIdType Triangle = 0;
};
} // namespace

void lms3dFillFusionOutput(const std::vector<lms3dNumberedMesh>& regions, vtkPolyData* output)
{
  std::size_t points = 0;
  std::size_t triangles = 0;
  for (const lms3dNumberedMesh& region : regions)
  {
    points += region.Mesh->Points.size();
    triangles += region.Mesh->Triangles.size();
  }
  Writer writer(points, triangles);
  for (const lms3dNumberedMesh& region : regions)
  {
    writer.Write(region);
  }
  writer.MoveTo(output);
}

void lms3dAddFusionField(const char* name, const std::vector<int>& values, vtkPolyData* output)
{
  const auto array = lms3dMakeArray<vtkIntArray>(name, values.size());
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  lms3dAddHiddenArray(array, output->GetFieldData());
}

void lms3dAddSensorPositions(const std::vector<lms3dVector>& positions, vtkPolyData* output)
{
  const auto array = lms3dMakeArray<vtkDoubleArray>("SensorPositions", positions.size(), 3);
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    array->SetTypedTuple(static_cast<vtkIdType>(i), positions[i].data());
  }
  lms3dAddHiddenArray(array, output->GetFieldData());
}
