// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVRMLImporterSource
 * @brief   reads the surfaces of a VRML 2.0 (VRML97) file as one vtkPolyData
 *
 * All shapes of the file become triangles in world coordinates, metres (VRML's unit), ready for
 * vtkLMS3DScanFilter. The cell data are `ShapeId` (int32, the shape's place in the file, from 0)
 * and `Color` (uint8, red, green, blue, opacity: the diffuse colour and the transparency). The
 * field data `ShapeNames` (strings) has the name of each shape.
 *
 * The file is read by vtkVRMLImporter, afresh at each execution.
 *
 * @warning
 * vtkVRMLImporter reads simple files only: shapes of IndexedFaceSet with explicit values under
 * unnested translations. Default sizes of Box, Sphere, Cone and Cylinder come out at half, centres
 * and orders of scale are lost, PROTO, EXTERNPROTO, Inline and ElevationGrid are not read, all
 * children of Switch and LOD are, and malformed files may crash the process. It keeps no names, so
 * each of `ShapeNames` is empty.
 *
 * Errors, with an empty output: no FileName (vtkErrorCode::NoFileNameError), a file that does not
 * exist or is no regular file (FileNotFoundError), cannot be opened (CannotOpenFileError), does not
 * begin with "#VRML V2.0" (UnrecognizedFileTypeError), or has no surface (FileFormatError).
 *
 * What is known not to have been read is kept as messages and reported as one warning: VTK's errors
 * and warnings, among them the first node type that VRML does not have, and polygons that cannot be
 * triangulated. The rest is lost without a message: the importer prints syntax errors to the
 * terminal only and ends there, and passes over VRML's nodes that it does not know (PROTO, Inline,
 * ElevationGrid, ...).
 *
 * @sa
 * vtkLMS3DScanFilter vtkVRMLImporter
 */
#ifndef vtkVRMLImporterSource_h
#define vtkVRMLImporterSource_h

#include "vtkLMS3DReadersModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // For std::string
#include <vector> // For std::vector

class VTKLMS3DREADERS_EXPORT vtkVRMLImporterSource : public vtkPolyDataAlgorithm
{
public:
  static vtkVRMLImporterSource* New();
  vtkTypeMacro(vtkVRMLImporterSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Whether the file is there and begins as a VRML 2.0 file: 1 or 0.
   */
  static int CanReadFile(const char* fileName);

  ///@{
  /**
   * The file to read. None by default.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * What reads the file. VTK_IMPORTER is vtkVRMLImporter.
   */
  enum Engines
  {
    VTK_IMPORTER = 1
  };

  ///@{
  /**
   * What reads the file; the default is VTK_IMPORTER.
   */
  vtkSetClampMacro(Engine, int, VTK_IMPORTER, VTK_IMPORTER);
  vtkGetMacro(Engine, int);
  void SetEngineToVTKImporter() { this->SetEngine(VTK_IMPORTER); }
  ///@}

  /**
   * What UpAxis can be. AS_IN_FILE leaves coordinates as they are. Y says that the file has y up,
   * as VRML browsers and modellers assume, and turns it by 90 degrees about x, so that z is up as
   * in the sensor frame: (x, y, z) becomes (x, -z, y).
   */
  enum UpAxes
  {
    AS_IN_FILE = 0,
    Y = 1
  };

  ///@{
  /**
   * Which axis of the file points up; the default is AS_IN_FILE, which never turns a scene.
   */
  vtkSetClampMacro(UpAxis, int, AS_IN_FILE, Y);
  vtkGetMacro(UpAxis, int);
  void SetUpAxisToAsInFile() { this->SetUpAxis(AS_IN_FILE); }
  void SetUpAxisToY() { this->SetUpAxis(Y); }
  ///@}

  ///@{
  /**
   * What is known not to have been read at the last execution, from message 0 on. A number out of
   * range gives an empty message.
   */
  int GetNumberOfMessages() const { return static_cast<int>(this->Messages.size()); }
  std::string GetMessage(int i) const;
  ///@}

protected:
  vtkVRMLImporterSource();
  ~vtkVRMLImporterSource() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkVRMLImporterSource(const vtkVRMLImporterSource&) = delete;
  void operator=(const vtkVRMLImporterSource&) = delete;

  int Fail(unsigned long errorCode, const std::string& words);

  char* FileName = nullptr;
  int Engine = VTK_IMPORTER;
  int UpAxis = AS_IN_FILE;
  std::vector<std::string> Messages;
};

#endif
