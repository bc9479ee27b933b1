// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVRMLImporterSource.h"

#include "lms3dVTKImporterEngine.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVersionMacros.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

vtkStandardNewMacro(vtkVRMLImporterSource);

namespace
{
const std::string Header = "#VRML V2.0";

bool IsRegularFile(const std::string& fileName)
{
  std::error_code error;
  return std::filesystem::is_regular_file(fileName, error);
}

bool BeginsAsVRML(std::istream& file)
{
  std::string begin(Header.size(), '\0');
  file.read(&begin[0], static_cast<std::streamsize>(begin.size()));
  return file && begin == Header;
}

struct Size
{
  explicit Size(const lms3dScene& scene)
  {
    for (const lms3dShape& shape : scene.Shapes)
    {
      this->Points += static_cast<vtkIdType>(shape.Points.size());
      this->Triangles += static_cast<vtkIdType>(shape.Triangles.size());
    }
  }

  vtkIdType Points = 0;
  vtkIdType Triangles = 0;
};

void AddPoints(const lms3dScene& scene, bool turnYUp, vtkPolyData* surface)
{
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(Size(scene).Points);
  double* out = coordinates->GetPointer(0);
  for (const lms3dShape& shape : scene.Shapes)
  {
    for (const std::array<double, 3>& p : shape.Points)
    {
      const std::array<double, 3> turned = { p[0], -p[2], p[1] };
      out = std::copy_n(turnYUp ? turned.data() : p.data(), 3, out);
    }
  }
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  surface->SetPoints(points);
}

void AddTriangles(const lms3dScene& scene, vtkPolyData* surface)
{
  const vtkIdType count = Size(scene).Triangles;
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(3 * count);
  vtkIdType* out = connectivity->GetPointer(0);
  vtkIdType firstPoint = 0;
  for (const lms3dShape& shape : scene.Shapes)
  {
    for (const std::array<std::int64_t, 3>& triangle : shape.Triangles)
    {
      for (std::int64_t corner : triangle)
      {
        *out++ = firstPoint + corner;
      }
    }
    firstPoint += static_cast<vtkIdType>(shape.Points.size());
  }
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(count + 1);
  for (vtkIdType i = 0; i <= count; ++i)
  {
    offsets->SetValue(i, 3 * i);
  }
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(offsets, connectivity);
  surface->SetPolys(polygons);
}

void AddShapes(const lms3dScene& scene, vtkPolyData* surface)
{
  const vtkIdType count = Size(scene).Triangles;
  vtkNew<vtkIntArray> shapeIds;
  shapeIds->SetName("ShapeId");
  shapeIds->SetNumberOfValues(count);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Color");
  colors->SetNumberOfComponents(4);
  colors->SetNumberOfTuples(count);
  vtkNew<vtkStringArray> names;
  names->SetName("ShapeNames");

  int* shapeId = shapeIds->GetPointer(0);
  unsigned char* color = colors->GetPointer(0);
  for (const lms3dShape& shape : scene.Shapes)
  {
    const int id = static_cast<int>(names->InsertNextValue(shape.Name));
    shapeId = std::fill_n(shapeId, shape.Triangles.size(), id);
    for (std::size_t i = 0; i < shape.Triangles.size(); ++i)
    {
      color = std::copy(shape.Color.begin(), shape.Color.end(), color);
    }
  }
  surface->GetCellData()->AddArray(shapeIds);
  surface->GetCellData()->AddArray(colors);
  surface->GetFieldData()->AddArray(names);
}

std::string Summarize(const std::string& fileName, const std::vector<std::string>& messages)
{
  return fileName + " was not read whole: " + messages.front() +
    (messages.size() > 1 ? " (and " + std::to_string(messages.size() - 1) + " more, see GetMessage)"
                         : "");
}
} // namespace

vtkVRMLImporterSource::vtkVRMLImporterSource()
{
  this->SetNumberOfInputPorts(0);
}

vtkVRMLImporterSource::~vtkVRMLImporterSource()
{
  delete[] this->FileName;
}

int vtkVRMLImporterSource::CanReadFile(const char* fileName)
{
  if (!fileName || !IsRegularFile(fileName))
  {
    return 0;
  }
  std::ifstream file(fileName, std::ios::binary);
  return BeginsAsVRML(file) ? 1 : 0;
}

std::string vtkVRMLImporterSource::GetMessage(int i) const
{
  return i >= 0 && i < this->GetNumberOfMessages() ? this->Messages[i] : std::string();
}

int vtkVRMLImporterSource::Fail(unsigned long errorCode, const std::string& words)
{
  vtkErrorMacro(<< words);
  this->SetErrorCode(errorCode);
  return 0;
}

int vtkVRMLImporterSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  this->Messages.clear();
  if (!this->FileName || !*this->FileName)
  {
    return this->Fail(vtkErrorCode::NoFileNameError, "There is no FileName to read; set one.");
  }
  const std::string fileName = this->FileName;
  if (!IsRegularFile(fileName))
  {
    return this->Fail(vtkErrorCode::FileNotFoundError,
      fileName + " is not there or is no regular file; check FileName.");
  }
  std::ifstream file(fileName, std::ios::binary);
  if (!file)
  {
    return this->Fail(vtkErrorCode::CannotOpenFileError,
      fileName + " cannot be opened; check that it may be read.");
  }
  if (!BeginsAsVRML(file))
  {
    return this->Fail(vtkErrorCode::UnrecognizedFileTypeError,
      fileName + " does not begin with \"" + Header + "\", so it is no VRML 2.0 (VRML97) file.");
  }

  const lms3dScene scene = lms3dReadWithVTKImporter(fileName,
    [this](double done)
    {
      this->UpdateProgress(done);
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20230111)
      return !this->CheckAbort();
#else
      return this->GetAbortExecute() == 0;
#endif
    });
  this->Messages = scene.Messages;
  if (Size(scene).Triangles == 0)
  {
    return this->Fail(vtkErrorCode::FileFormatError,
      fileName + " has no surface that can be read." +
        (this->Messages.empty() ? "" : " " + this->Messages.front()));
  }
  if (!this->Messages.empty())
  {
    vtkWarningMacro(<< Summarize(fileName, this->Messages));
  }

  vtkPolyData* surface = vtkPolyData::GetData(outputVector);
  AddPoints(scene, this->UpAxis == Y, surface);
  AddTriangles(scene, surface);
  AddShapes(scene, surface);
  return 1;
}

void vtkVRMLImporterSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << '\n';
  os << indent << "Engine: VTKImporter\n";
  os << indent << "UpAxis: " << (this->UpAxis == Y ? "Y" : "AsInFile") << '\n';
  os << indent << "NumberOfMessages: " << this->GetNumberOfMessages() << '\n';
}
