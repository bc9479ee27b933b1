// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scanning/lms3dServedScene.h"

#include "Common/lms3dLog.h"
#include "vtkVRMLImporterSource.h"

#include <vtkNew.h>

#include <stdexcept>

namespace
{
std::string RemoveFolder(std::string text, const std::filesystem::path& file)
{
  const std::string folder = file.parent_path().string() + "/";
  for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder, at))
  {
    text.erase(at, folder.size());
  }
  return text;
}

void LogIfAny(const std::string& name, const std::string& message)
{
  if (!message.empty())
  {
    lms3dLog(lms3dLogKind::Scenes, "scene " + name + ": " + message);
  }
}

LMS3D::Scene Describe(const std::string& name, vtkPolyData* surface)
{
  double bounds[6];
  surface->GetBounds(bounds);
  LMS3D::Scene scene;
  scene.name = name.c_str();
  scene.triangles = static_cast<CORBA::ULongLong>(surface->GetNumberOfPolys());
  scene.lowest = { bounds[0], bounds[2], bounds[4] };
  scene.highest = { bounds[1], bounds[3], bounds[5] };
  return scene;
}
} // namespace

lms3dServedScenePointer lms3dReadScene(const std::string& name, const std::filesystem::path& file,
  bool isYUp, const lms3dStopTest& isStopped)
{
  vtkNew<vtkVRMLImporterSource> reader;
  lms3dAlgorithmMessages messages(reader);
  reader->SetFileName(file.c_str());
  reader->SetUpAxis(
    isYUp ? vtkVRMLImporterSource::UP_AXIS_Y : vtkVRMLImporterSource::UP_AXIS_AS_IN_FILE);
  lms3dAbortIf(reader, isStopped);
  reader->Update();
  // An aborted reader has no surface, but the file is not at fault.
  if (isStopped())
  {
    throw lms3dReadingStopped();
  }

  const std::string error = RemoveFolder(messages.TakeError(), file);
  const std::string warning = RemoveFolder(messages.TakeWarning(), file);
  if (reader->GetOutput()->GetNumberOfPolys() == 0)
  {
    throw std::runtime_error(error.empty() ? "the file has no surface" : error);
  }
  LogIfAny(name, error);
  LogIfAny(name, warning);
  auto scene = std::make_shared<lms3dServedScene>();
  scene->Surface = reader->GetOutput();
  scene->Description = Describe(name, scene->Surface);
  return scene;
}
