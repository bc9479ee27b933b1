// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVRMLImporterSource.h"

#include "lms3dFile.h"
#include "lms3dSceneOutput.h"
#include "lms3dVRMLReader.h"
#include "lms3dVTKImporterEngine.h"

#include <vtkErrorCode.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkVersionMacros.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <new>

vtkStandardNewMacro(vtkVRMLImporterSource);

namespace
{
constexpr std::size_t LengthOfHeader = 64;

// So many messages are listed in one warning.
constexpr std::size_t MostListed = 20;

bool CanOpen(const std::string& fileName)
{
  return std::ifstream(fileName, std::ios::binary).is_open();
}

bool IsPacked(const std::string& fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  return file.get() == 0x1f && file.get() == 0x8b;
}

std::string ToText(const lms3dMessage& message)
{
  const std::string line = message.Line > 0 ? ":" + std::to_string(message.Line) : "";
  return (message.File.empty() ? "" : message.File + line + ": ") + message.Text;
}
} // namespace

vtkVRMLImporterSource::vtkVRMLImporterSource()
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
  return fileName && lms3dIsRegularFile(fileName) && CanOpen(fileName) &&
      lms3dExplainBeginning(lms3dReadBeginning(fileName, LengthOfHeader)).empty()
    ? 1
    : 0;
}

std::string vtkVRMLImporterSource::GetMessage(int i) const
{
  return i >= 0 && i < this->GetNumberOfMessages() ? this->Messages[i] : std::string();
}

int vtkVRMLImporterSource::GetMessageSeverity(int i) const
{
  return i >= 0 && i < this->GetNumberOfMessages() ? this->Severities[i] : MESSAGE_WARNING;
}

bool vtkVRMLImporterSource::Fail(unsigned long errorCode, const std::string& words)
{
  vtkErrorMacro(<< words);
  this->SetErrorCode(errorCode);
  return false;
}

bool vtkVRMLImporterSource::CheckFile()
{
  if (!this->FileName || !*this->FileName)
  {
    return this->Fail(vtkErrorCode::NoFileNameError, "There is no FileName to read; set one.");
  }
  const std::string fileName = this->FileName;
  if (!lms3dIsRegularFile(fileName))
  {
    return this->Fail(vtkErrorCode::FileNotFoundError,
      fileName + " is not there or is no regular file; check FileName.");
  }
  if (!CanOpen(fileName))
  {
    return this->Fail(vtkErrorCode::CannotOpenFileError,
      fileName + " cannot be opened; check that it may be read.");
  }
  const std::string problem = lms3dExplainBeginning(lms3dReadBeginning(fileName, LengthOfHeader));
  if (!problem.empty())
  {
    return this->Fail(vtkErrorCode::UnrecognizedFileTypeError, fileName + " " + problem + ".");
  }
  if (this->Engine == VTK_IMPORTER && IsPacked(fileName))
  {
    return this->Fail(vtkErrorCode::UnrecognizedFileTypeError,
      fileName + " is packed by gzip, which vtkVRMLImporter cannot read; set the engine VRML97.");
  }
  return true;
}

bool vtkVRMLImporterSource::IsAborted()
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20230111)
  return this->CheckAbort();
#else
  return this->GetAbortExecute() != 0;
#endif
}

lms3dScene vtkVRMLImporterSource::Read()
{
  const auto progress = [this](double done)
  {
    this->UpdateProgress(done);
    return !this->IsAborted();
  };
  if (this->Engine == VTK_IMPORTER)
  {
    return lms3dReadWithVTKImporter(this->FileName, progress);
  }
  lms3dVRMLOptions options;
  options.SceneRoot = this->SceneRoot ? this->SceneRoot : "";
  options.ChordError = this->ChordError;
  options.MaximumInlineDepth = this->MaximumInlineDepth;
  options.MaximumNumberOfNodes = this->MaximumNumberOfNodes;
  options.MaximumNumberOfTriangles = this->MaximumNumberOfTriangles;
  options.MaximumFileSize = this->MaximumFileSize;
  return lms3dReadVRML(this->FileName, options, progress);
}

void vtkVRMLImporterSource::KeepMessages(const std::vector<lms3dMessage>& messages)
{
  for (const lms3dMessage& message : messages)
  {
    this->Messages.push_back(ToText(message));
    this->Severities.push_back(message.Severity);
  }
}

// The first error says more than a warning before it.
std::string vtkVRMLImporterSource::GetGravestMessage() const
{
  const auto gravest = std::max_element(this->Severities.begin(), this->Severities.end());
  return this->GetMessage(static_cast<int>(gravest - this->Severities.begin()));
}

// Whole, for windows such as ParaView's, whose users cannot call GetMessage.
std::string vtkVRMLImporterSource::ListMessages() const
{
  const std::size_t listed = std::min(this->Messages.size(), MostListed);
  std::string list = "\nAll " + std::to_string(this->Messages.size()) + " messages:";
  for (std::size_t i = 0; i < listed; ++i)
  {
    list.append("\n").append(this->Messages[i]);
  }
  if (listed < this->Messages.size())
  {
    list.append("\nand so on, see GetMessage");
  }
  return list;
}

void vtkVRMLImporterSource::SumUpMessages()
{
  if (this->Messages.empty())
  {
    return;
  }
  const std::string words =
    this->GetGravestMessage() + (this->Messages.size() > 1 ? this->ListMessages() : "");
  if (*std::max_element(this->Severities.begin(), this->Severities.end()) == MESSAGE_ERROR)
  {
    vtkErrorMacro(<< this->FileName << " was not read whole: " << words);
  }
  else
  {
    vtkWarningMacro(<< this->FileName << " has faults: " << words);
  }
}

int vtkVRMLImporterSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  this->Messages.clear();
  this->Severities.clear();
  vtkInformation* output = outputVector->GetInformationObject(0);
  if (this->CheckFile() && this->ReadFile(output))
  {
    return 1;
  }
  // Of several processes the first alone reads. If the pipeline stopped here in that one, the others
  // would wait for it in the next filter whose processes talk to one another.
  const auto pieces = vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES();
  return output->Has(pieces) && output->Get(pieces) > 1 ? 1 : 0;
}

bool vtkVRMLImporterSource::ReadFile(vtkInformation* output)
{
  auto* surface = vtkPolyData::SafeDownCast(output->Get(vtkDataObject::DATA_OBJECT()));
  try
  {
    const lms3dScene scene = this->Read();
    if (this->IsAborted())
    {
      // VTK takes for good what a filter leaves, also where it was stopped.
      output->Set(vtkDemandDrivenPipeline::DATA_NOT_GENERATED(), 1);
      surface->ReleaseData();
      return true;
    }
    this->KeepMessages(scene.Messages);
    if (!lms3dHasSurface(scene))
    {
      return this->Fail(vtkErrorCode::FileFormatError,
        std::string(this->FileName) + " has no surface that can be read. " +
          this->GetGravestMessage());
    }
    lms3dWriteScene(scene, this->UpAxis == Y, surface);
  }
  catch (const std::bad_alloc&)
  {
    surface->Initialize();
    return this->Fail(vtkErrorCode::UserError,
      std::string(this->FileName) +
        " needs more memory than there is; lower MaximumNumberOfNodes or "
        "MaximumNumberOfTriangles.");
  }
  this->SumUpMessages();
  return true;
}

void vtkVRMLImporterSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << '\n';
  os << indent << "SceneRoot: " << (this->SceneRoot ? this->SceneRoot : "(none)") << '\n';
  os << indent << "Engine: " << (this->Engine == VRML97 ? "VRML97" : "VTKImporter") << '\n';
  os << indent << "UpAxis: " << (this->UpAxis == Y ? "Y" : "AsInFile") << '\n';
  os << indent << "ChordError: " << this->ChordError << '\n';
  os << indent << "MaximumInlineDepth: " << this->MaximumInlineDepth << '\n';
  os << indent << "MaximumNumberOfNodes: " << this->MaximumNumberOfNodes << '\n';
  os << indent << "MaximumNumberOfTriangles: " << this->MaximumNumberOfTriangles << '\n';
  os << indent << "MaximumFileSize: " << this->MaximumFileSize << '\n';
  os << indent << "NumberOfMessages: " << this->GetNumberOfMessages() << '\n';
}
