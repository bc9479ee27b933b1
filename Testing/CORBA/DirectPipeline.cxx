// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DirectPipeline.h"

#include "ServerProcess.h"
#include "vtkLMS3DRangeErrorFilter.h"
#include "vtkLMS3DScanFilter.h"
#include "vtkLMS3DSurfaceReconstructionFilter.h"
#include "vtkVRMLImporterSource.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <cmath>

namespace
{
std::vector<double> GetPoints(vtkPolyData* data)
{
  std::vector<double> coordinates;
  coordinates.reserve(3 * static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const double* point = data->GetPoint(i);
    coordinates.insert(coordinates.end(), point, point + 3);
  }
  return coordinates;
}

// A trajectory of one pose gives the scan its time, which selects its errors.
vtkNew<vtkPolyData> MakeTrajectory(const LMS3D::Vector3& position, CORBA::ULongLong time)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(position.x, position.y, position.z);
  vtkNew<vtkDoubleArray> times;
  times->SetName("Time");
  times->InsertNextValue(static_cast<double>(time));
  vtkNew<vtkPolyData> trajectory;
  trajectory->SetPoints(points);
  trajectory->GetPointData()->AddArray(times);
  return trajectory;
}

void SetDevice(const LMS3D::Device& device, vtkLMS3DScanFilter* scanner)
{
  scanner->SetMounting(static_cast<int>(device.mounting));
  scanner->SetAxisOffset(device.axisOffset.x, device.axisOffset.y, device.axisOffset.z);
  scanner->SetTurnRate(device.turnRate);
  scanner->SetBeamDiameter(device.beamDiameter);
  scanner->SetBeamDivergence(device.beamDivergence);
  scanner->SetBeamSamples(static_cast<int>(device.beamSamples));
  scanner->SetPulseLength(device.pulseLength);
  scanner->SetRangeAtTenPercent(device.rangeAtTenPercent);
  scanner->SetReflectanceArray(device.reflectanceArray);
}

bool HasErrors(const LMS3D::Device& device)
{
  return device.rangeBias != 0.0 || device.rangeNoise != 0.0 || device.rangeResolution != 0.0;
}

void SetErrors(const LMS3D::Device& device, vtkLMS3DRangeErrorFilter* errors)
{
  errors->SetRangeBias(device.rangeBias);
  errors->SetRangeNoise(device.rangeNoise);
  errors->SetRangeResolution(device.rangeResolution);
  errors->SetNoiseSeed(device.noiseSeed);
}
} // namespace

DirectPipeline::DirectPipeline(const std::string& scene, const LMS3D::Pose& pose,
  const LMS3D::Configuration& configuration, const LMS3D::Device& device, CORBA::ULongLong number)
{
  vtkNew<vtkVRMLImporterSource> reader;
  reader->SetFileName((std::string(LMS3D_DATA_DIR) + "/" + scene).c_str());
  vtkNew<vtkLMS3DScanFilter> scanner;
  scanner->SetInputConnection(reader->GetOutputPort());
  scanner->SetNumberOfThreads(FilterThreads);
  scanner->SetPosition(pose.position.x, pose.position.y, pose.position.z);
  scanner->SetOrientation(pose.orientation.x, pose.orientation.y, pose.orientation.z);
  scanner->SetAlphaRange(configuration.alpha.start, configuration.alpha.stop);
  scanner->SetAlphaResolution(static_cast<int>(configuration.alpha.count));
  scanner->SetBetaRange(configuration.beta.start, configuration.beta.stop);
  scanner->SetBetaResolution(static_cast<int>(configuration.beta.count));
  scanner->SetMinimumRange(configuration.minimumRange);
  scanner->SetMaximumRange(configuration.maximumRange);
  scanner->SetTrajectoryData(MakeTrajectory(pose.position, number));
  SetDevice(device, scanner);
  vtkNew<vtkLMS3DRangeErrorFilter> errors;
  errors->SetInputConnection(scanner->GetOutputPort());
  errors->SetNumberOfThreads(FilterThreads);
  SetErrors(device, errors);
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> mapper;
  mapper->SetInputConnection(
    HasErrors(device) ? errors->GetOutputPort() : scanner->GetOutputPort());
  mapper->SetNumberOfThreads(FilterThreads);
  mapper->SetMaximumError(configuration.mapError);
  if (HasErrors(device))
  {
    errors->Update();
    this->TakeScan(errors->GetRangeImage(), errors->GetOutput());
  }
  else
  {
    scanner->Update();
    this->TakeScan(scanner->GetRangeImage(), scanner->GetOutput());
  }
  if (configuration.makeMap)
  {
    mapper->Update();
    this->TakeMap(mapper->GetOutput());
  }
}

void DirectPipeline::TakeScan(vtkImageData* image, vtkPolyData* scan)
{
  vtkDataArray* ranges = image->GetPointData()->GetArray("Range");
  vtkDataArray* alphas = scan->GetFieldData()->GetArray("AlphaAngles");
  vtkDataArray* betas = scan->GetFieldData()->GetArray("BetaAngles");
  const vtkIdType beams = alphas->GetNumberOfTuples();
  this->Ranges.reserve(static_cast<std::size_t>(ranges->GetNumberOfTuples()));
  this->Triples.reserve(3 * static_cast<std::size_t>(ranges->GetNumberOfTuples()));
  for (vtkIdType i = 0; i < ranges->GetNumberOfTuples(); ++i)
  {
    const double range = ranges->GetTuple1(i);
    this->Ranges.push_back(std::isnan(range) ? 0.0f : static_cast<float>(range));
    this->Triples.push_back(this->Ranges.back());
    this->Triples.push_back(static_cast<float>(alphas->GetTuple1(i % beams)));
    this->Triples.push_back(static_cast<float>(betas->GetTuple1(i / beams)));
  }
  this->ReturnPoints = GetPoints(scan);
}

void DirectPipeline::TakeMap(vtkPolyData* map)
{
  this->MapPoints = GetPoints(map);
  this->MapTriangles.reserve(3 * static_cast<std::size_t>(map->GetNumberOfPolys()));
  vtkNew<vtkIdList> triangle;
  vtkCellArray* triangles = map->GetPolys();
  for (triangles->InitTraversal(); triangles->GetNextCell(triangle);)
  {
    for (vtkIdType i = 0; i < triangle->GetNumberOfIds(); ++i)
    {
      this->MapTriangles.push_back(static_cast<std::uint32_t>(triangle->GetId(i)));
    }
  }
}
