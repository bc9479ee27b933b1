// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dVTKImporterEngine.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCommand.h>
#include <vtkMapper.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTriangleFilter.h>
#include <vtkVRMLImporter.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace
{
// Removes VTK's prefix of source file, line and object: "... (0x5a2b): text".
std::string GetText(const std::string& message)
{
  const std::string endOfPrefix = "): ";
  const std::size_t prefix = message.find(endOfPrefix);
  const std::size_t first = prefix == std::string::npos ? 0 : prefix + endOfPrefix.size();
  const std::size_t last = message.find_last_not_of('\n');
  return last == std::string::npos ? "" : message.substr(first, last + 1 - first);
}

void StoreMessage(vtkObject*, unsigned long, void* clientData, void* callData)
{
  auto* messages = static_cast<std::vector<lms3dMessage>*>(clientData);
  messages->push_back(
    { lms3dMessage::MESSAGE_ERROR, "", 0, GetText(static_cast<const char*>(callData)) });
}

std::uint8_t ToByte(double fraction)
{
  return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(fraction, 0.0, 1.0)));
}

lms3dColor GetColor(vtkProperty* property)
{
  const double* color = property->GetDiffuseColor();
  return { ToByte(color[0]), ToByte(color[1]), ToByte(color[2]) };
}

std::array<double, 3> TransformPoint(vtkMatrix4x4* matrix, const double point[3])
{
  const double in[4] = { point[0], point[1], point[2], 1.0 };
  double out[4];
  matrix->MultiplyPoint(in, out);
  return { out[0], out[1], out[2] };
}

// A polygon or strip of n corners has n - 2 triangles.
vtkIdType CountTriangles(vtkCellArray* cells)
{
  vtkIdType count = 0;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    count += std::max<vtkIdType>(cells->GetCellSize(cell) - 2, 0);
  }
  return count;
}

void AppendTriangles(vtkPolyData* surface, lms3dMesh& mesh)
{
  auto cells = vtkSmartPointer<vtkCellArrayIterator>::Take(surface->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType count;
    const vtkIdType* corners;
    cells->GetCurrentCell(count, corners);
    mesh.Triangles.push_back({ static_cast<std::int32_t>(corners[0]),
      static_cast<std::int32_t>(corners[1]), static_cast<std::int32_t>(corners[2]) });
  }
}

void AppendShape(vtkActor* actor, lms3dScene& scene)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  actor->GetMapper()->Update();
  auto* read = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
  triangles->SetInputData(read);
  triangles->Update();
  vtkPolyData* surface = triangles->GetOutput();

  auto mesh = std::make_shared<lms3dMesh>();
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    mesh->Points.push_back(TransformPoint(actor->GetMatrix(), surface->GetPoint(i)));
  }
  AppendTriangles(surface, *mesh);

  const vtkIdType expected = CountTriangles(read->GetPolys()) + CountTriangles(read->GetStrips());
  const vtkIdType lost = expected - static_cast<vtkIdType>(mesh->Triangles.size());
  if (lost > 0)
  {
    scene.Messages.push_back({ lms3dMessage::MESSAGE_ERROR, "", 0,
      "shape " + std::to_string(scene.Shapes.size()) + ": " + std::to_string(lost) + " of " +
        std::to_string(expected) + " triangles could not be made" });
  }
  lms3dShape shape;
  shape.Color = GetColor(actor->GetProperty());
  shape.Opacity = ToByte(actor->GetProperty()->GetOpacity());
  shape.Mesh = mesh;
  scene.Shapes.push_back(std::move(shape));
}
} // namespace

lms3dScene lms3dReadWithVTKImporter(
  const std::string& fileName, const std::function<bool(double)>& progress)
{
  lms3dScene scene;
  vtkNew<vtkCallbackCommand> keeper;
  keeper->SetCallback(StoreMessage);
  keeper->SetClientData(&scene.Messages);

  // An importer appends to its result when it reads again, so each reading needs a new one.
  vtkNew<vtkVRMLImporter> importer;
  importer->AddObserver(vtkCommand::ErrorEvent, keeper);
  importer->AddObserver(vtkCommand::WarningEvent, keeper);
  importer->SetFileName(fileName.c_str());
  importer->Update();

  vtkActorCollection* actors = importer->GetRenderer()->GetActors();
  const int count = actors->GetNumberOfItems();
  vtkCollectionSimpleIterator it;
  actors->InitTraversal(it);
  while (vtkActor* actor = actors->GetNextActor(it))
  {
    if (actor->GetMapper() && actor->GetMapper()->GetNumberOfInputConnections(0) > 0)
    {
      AppendShape(actor, scene);
    }
    if (!progress(static_cast<double>(scene.Shapes.size()) / count))
    {
      break;
    }
  }
  return scene;
}
