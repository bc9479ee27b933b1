// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVRMLImporterSource.h"

#include "Model/lms3dMessageList.h"
#include "Shapes/lms3dVRMLReader.h"
#include "lms3dFileCheck.h"
#include "lms3dSceneOutput.h"
#include "lms3dVTKImporterEngine.h"

#include <vtkDemandDrivenPipeline.h>
#include <vtkErrorCode.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkVersionMacros.h>

#include <algorithm>
#include <cctype>
#include <exception>
#include <filesystem>
#include <new>

vtkStandardNewMacro(vtkVRMLImporterSource);

static_assert(vtkVRMLImporterSource::MESSAGE_WARNING == int(lms3dMessage::MESSAGE_WARNING) &&
    vtkVRMLImporterSource::MESSAGE_ERROR == int(lms3dMessage::MESSAGE_ERROR),
  "Severities pass through unchanged.");

namespace
{
bool IsNamedAsVRML(const char* fileName)
{
  std::string ending = std::filesystem::path(fileName).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return ending == ".wrl" || ending == ".vrml" || ending == ".wrz";
}
} // namespace

struct vtkVRMLImporterSource::Internals
{
  explicit Internals(vtkVRMLImporterSource* self)
    : Self(self)
  {
  }

  bool IsAborted() const;
  lms3dScene Read() const;
  /// Throws lms3dReadFailure if the file has no surface.
  void ReadFile(vtkInformation* output);
  void Execute(vtkInformation* output);
  void Fail(vtkInformation* output, unsigned long errorCode, const std::string& text) const;
  void ReportMessages() const;

  vtkVRMLImporterSource* Self;
  lms3dMessageList Messages;
};

vtkVRMLImporterSource::vtkVRMLImporterSource()
  : Internal(new Internals(this))
{
  this->SetNumberOfInputPorts(0);
}

vtkVRMLImporterSource::~vtkVRMLImporterSource()
{
  delete[] this->FileName;
  delete[] this->SceneRoot;
}

int vtkVRMLImporterSource::CanReadFile(const char* fileName)
{
  try
  {
    lms3dCheckFile(fileName, true);
    return 1;
  }
  catch (const lms3dReadFailure& failure)
  {
    return failure.ErrorCode == vtkErrorCode::UnrecognizedFileTypeError && IsNamedAsVRML(fileName);
  }
  catch (const std::exception&)
  {
    return 0;
  }
}

int vtkVRMLImporterSource::GetNumberOfMessages() const
{
  return this->Internal->Messages.GetSize();
}

std::string vtkVRMLImporterSource::GetMessage(int i) const
{
  return this->Internal->Messages.GetText(i);
}

int vtkVRMLImporterSource::GetMessageSeverity(int i) const
{
  return this->Internal->Messages.GetSeverity(i);
}

bool vtkVRMLImporterSource::Internals::IsAborted() const
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20230111)
  return this->Self->CheckAbort();
#else
  return this->Self->GetAbortExecute() != 0;
#endif
}

lms3dScene vtkVRMLImporterSource::Internals::Read() const
{
  const auto progress = [this](double done)
  {
    this->Self->UpdateProgress(done);
    return !this->IsAborted();
  };
  if (this->Self->Engine == VTK_IMPORTER)
  {
    return lms3dReadWithVTKImporter(this->Self->FileName, progress);
  }
  lms3dVRMLOptions options;
  options.SceneRoot = this->Self->SceneRoot ? this->Self->SceneRoot : "";
  options.ChordError = this->Self->ChordError;
  options.MaximumInlineDepth = this->Self->MaximumInlineDepth;
  options.MaximumNumberOfNodes = this->Self->MaximumNumberOfNodes;
  options.MaximumNumberOfTriangles = this->Self->MaximumNumberOfTriangles;
  options.MaximumMemory = this->Self->MaximumMemory;
  options.MaximumFileSize = this->Self->MaximumFileSize;
  return lms3dReadVRML(this->Self->FileName, options, progress);
}

void vtkVRMLImporterSource::Internals::ReadFile(vtkInformation* output)
{
  auto* surface = vtkPolyData::SafeDownCast(output->Get(vtkDataObject::DATA_OBJECT()));
  const lms3dScene scene = this->Read();
  if (this->IsAborted())
  {
    // Otherwise VTK would regard the output of an aborted execution as up to date.
    output->Set(vtkDemandDrivenPipeline::DATA_NOT_GENERATED(), 1);
    surface->ReleaseData();
    return;
  }
  this->Messages = lms3dMessageList(scene.Messages);
  if (!lms3dHasSurface(scene))
  {
    throw lms3dReadFailure{ vtkErrorCode::FileFormatError,
      std::string(this->Self->FileName) + " has no surface that can be read. " +
        this->Messages.GetMostSevere() };
  }
  lms3dWriteScene(scene, this->Self->UpAxis == UP_AXIS_Y, surface);
  this->ReportMessages();
}

void vtkVRMLImporterSource::Internals::ReportMessages() const
{
  if (this->Messages.HasErrors())
  {
    vtkErrorWithObjectMacro(this->Self,
      << this->Self->FileName << " was not read completely: " << this->Messages.Summarize());
  }
  else if (this->Messages.GetSize() > 0)
  {
    vtkWarningWithObjectMacro(
      this->Self, << this->Self->FileName << " has faults: " << this->Messages.Summarize());
  }
}

void vtkVRMLImporterSource::Internals::Fail(
  vtkInformation* output, unsigned long errorCode, const std::string& text) const
{
  output->Get(vtkDataObject::DATA_OBJECT())->Initialize();
  vtkErrorWithObjectMacro(this->Self, << text);
  this->Self->ErrorCode = errorCode;
}

void vtkVRMLImporterSource::Internals::Execute(vtkInformation* output)
{
  try
  {
    lms3dCheckFile(this->Self->FileName, this->Self->Engine != VTK_IMPORTER);
    this->ReadFile(output);
  }
  catch (const lms3dReadFailure& failure)
  {
    this->Fail(output, failure.ErrorCode, failure.Text);
  }
  catch (const std::bad_alloc&)
  {
    this->Fail(output, vtkErrorCode::UserError,
      std::string(this->Self->FileName) + " needs more memory than there is; lower MaximumMemory.");
  }
  catch (const std::exception& exception)
  {
    this->Fail(output, vtkErrorCode::UserError,
      std::string(this->Self->FileName) + " cannot be read: " + exception.what());
  }
}

int vtkVRMLImporterSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  // Without SetErrorCode(), which modifies the reader, so that every update would run it again.
  this->ErrorCode = vtkErrorCode::NoError;
  this->Internal->Messages = lms3dMessageList();
  vtkInformation* output = outputVector->GetInformationObject(0);
  this->Internal->Execute(output);
  // 1 after an error, too. Otherwise VTK would add an error of its own and read the file again at
  // each update. And with several processes only the first one reads: if its pipeline stopped here,
  // the others would wait forever in the next filter that communicates.
  return 1;
}

void vtkVRMLImporterSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << '\n';
  os << indent << "SceneRoot: " << (this->SceneRoot ? this->SceneRoot : "(none)") << '\n';
  os << indent << "Engine: " << (this->Engine == VRML97 ? "VRML97" : "VTKImporter") << '\n';
  os << indent << "UpAxis: " << (this->UpAxis == UP_AXIS_Y ? "Y" : "AsInFile") << '\n';
  os << indent << "ChordError: " << this->ChordError << '\n';
  os << indent << "MaximumInlineDepth: " << this->MaximumInlineDepth << '\n';
  os << indent << "MaximumNumberOfNodes: " << this->MaximumNumberOfNodes << '\n';
  os << indent << "MaximumNumberOfTriangles: " << this->MaximumNumberOfTriangles << '\n';
  os << indent << "MaximumMemory: " << this->MaximumMemory << '\n';
  os << indent << "MaximumFileSize: " << this->MaximumFileSize << '\n';
  os << indent << "NumberOfMessages: " << this->GetNumberOfMessages() << '\n';
}
