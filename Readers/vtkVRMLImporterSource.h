// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVRMLImporterSource
 * @brief   reads the surfaces of a VRML 2.0 (VRML97) file as one vtkPolyData
 *
 * All shapes of the file become triangles in world coordinates, metres (VRML's unit), ready for
 * vtkLMS3DScanFilter. The cell data are `ShapeId` (int32, the shape's place in the scene, from 0)
 * and `Color` (uint8, red, green, blue, opacity: the diffuse colour, or those of a Color node, and
 * the transparency). The field data `ShapeNames` (strings) has the name of each shape: what DEF
 * calls it, or else the nearest node around it that has a name, outside of prototypes first.
 *
 * @par What is read
 * With the engine VRML97 all of ISO/IEC 14772-1:1997 that makes surfaces: Box, Cone, Cylinder,
 * ElevationGrid, Extrusion, IndexedFaceSet (faces of any number of corners, concave or with holes
 * that a bridge joins to the rim, whatever `convex` says) and Sphere; Transform, Group, Anchor,
 * Billboard (not turned), Collision (without its proxy), Switch, LOD (the first level), Inline, DEF
 * and USE, PROTO and EXTERNPROTO; files packed by gzip; any line ending. Triangles turn
 * counter-clockwise seen from their front. The scene is read as it stands at first: no ROUTE,
 * interpolator or Script is run. Lines, points, text, lights, sounds and textures are read over.
 *
 * @par What is not read
 * is told, never left out in silence: each fault of the file is a message with its file and line,
 * and all the rest is kept. A message is an error where geometry is lost or misplaced, else a
 * warning. After an execution with messages one vtkErrorMacro (if any is an error) or one
 * vtkWarningMacro names the gravest and lists the first 20; the output has what could be read, and
 * the error code is NoError.
 *
 * @par Errors
 * with an empty output: no FileName (vtkErrorCode::NoFileNameError), a file that does not exist or
 * is no regular file (FileNotFoundError), cannot be opened (CannotOpenFileError), is no VRML 2.0
 * file (UnrecognizedFileTypeError; VRML 1.0, X3D, Open Inventor and binary files are named), has no
 * surface (FileFormatError), or needs more memory than there is (UserError). After an abort the
 * output is empty too, without an error or a message.
 *
 * @warning
 * The engine VTKImporter is there for comparison. vtkVRMLImporter reads simple files only: shapes of
 * IndexedFaceSet with explicit values under unnested translations. Default sizes of Box, Sphere,
 * Cone and Cylinder come out at half, centres and orders of scale are lost, PROTO, EXTERNPROTO,
 * Inline and ElevationGrid are not read, all children of Switch and LOD are, USE of a group brings
 * nothing, faces with holes are lost, and malformed files, and many that are not, crash the process.
 * It keeps no names and no lines, and prints syntax errors to the terminal only. It is not thread
 * safe, and two importers that live at once crash the process. ChordError, SceneRoot and the limits
 * mean nothing to it.
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

struct lms3dMessage;
struct lms3dScene;

class VTKLMS3DREADERS_EXPORT vtkVRMLImporterSource : public vtkPolyDataAlgorithm
{
public:
  static vtkVRMLImporterSource* New();
  vtkTypeMacro(vtkVRMLImporterSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Whether the file is there and begins as a VRML 2.0 file, packed by gzip or not: 1 or 0.
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
   * What reads the file: LMS3D's own reader, or vtkVRMLImporter (see the warning above).
   */
  enum Engines
  {
    VRML97 = 0,
    VTK_IMPORTER = 1
  };

  ///@{
  /**
   * What reads the file; the default is VRML97.
   */
  vtkSetClampMacro(Engine, int, VRML97, VTK_IMPORTER);
  vtkGetMacro(Engine, int);
  void SetEngineToVRML97() { this->SetEngine(VRML97); }
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
   * How far the triangles of a Sphere, Cone or Cylinder may be from its true surface, in metres of
   * the world, from 1e-9 on; the default is 0.001. Their points are on it. A circle has 8 sides at
   * least, and 2,048 at most, with a warning where these are too few.
   */
  vtkSetClampMacro(ChordError, double, 1e-9, VTK_DOUBLE_MAX);
  vtkGetMacro(ChordError, double);
  ///@}

  ///@{
  /**
   * The folder that the files of Inline and EXTERNPROTO have to be in or below, links resolved.
   * None by default: the folder of FileName. Nothing is ever fetched from a network.
   */
  vtkSetFilePathMacro(SceneRoot);
  vtkGetFilePathMacro(SceneRoot);
  ///@}

  ///@{
  /**
   * How many Inlines may be inside of each other, and through how many files an EXTERNPROTO may
   * lead, 0 and more; the default is 16.
   */
  vtkSetClampMacro(MaximumInlineDepth, int, 0, 1000);
  vtkGetMacro(MaximumInlineDepth, int);
  ///@}

  ///@{
  /**
   * How many nodes the files may have, and how many may be met when each USE and instance is
   * followed, 0 and more; the default is 20,000,000. What comes first is kept.
   */
  vtkSetClampMacro(MaximumNumberOfNodes, vtkTypeInt64, 0, VTK_TYPE_INT64_MAX);
  vtkGetMacro(MaximumNumberOfNodes, vtkTypeInt64);
  ///@}

  ///@{
  /**
   * How many triangles the output may have, 0 and more; the default is 400,000,000. The shapes that
   * come first are kept. A scene whose geometry could have a million more than that, but has not,
   * since its faces are no surfaces, ends there too.
   */
  vtkSetClampMacro(MaximumNumberOfTriangles, vtkTypeInt64, 0, VTK_TYPE_INT64_MAX);
  vtkGetMacro(MaximumNumberOfTriangles, vtkTypeInt64);
  ///@}

  ///@{
  /**
   * How many bytes all files of the scene may have together, unpacked, 0 and more; the default is
   * 2 GiB. What comes first is kept.
   */
  vtkSetClampMacro(MaximumFileSize, vtkTypeInt64, 0, VTK_TYPE_INT64_MAX);
  vtkGetMacro(MaximumFileSize, vtkTypeInt64);
  ///@}

  /**
   * How grave a message is: of an ERROR geometry is lost or misplaced.
   */
  enum MessageSeverities
  {
    MESSAGE_WARNING = 0,
    MESSAGE_ERROR = 1
  };

  ///@{
  /**
   * What was not read, or not as the file has it, at the last execution, from message 0 on:
   * "file:line: what", without the line, or both, where they are not known. A number out of range
   * gives an empty message and MESSAGE_WARNING.
   */
  int GetNumberOfMessages() const { return static_cast<int>(this->Messages.size()); }
  std::string GetMessage(int i) const;
  int GetMessageSeverity(int i) const;
  ///@}

protected:
  vtkVRMLImporterSource();
  ~vtkVRMLImporterSource() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkVRMLImporterSource(const vtkVRMLImporterSource&) = delete;
  void operator=(const vtkVRMLImporterSource&) = delete;

  bool CheckFile();
  lms3dScene Read();
  bool IsAborted();
  bool ReadFile(vtkInformation* output);
  void KeepMessages(const std::vector<lms3dMessage>& messages);
  std::string GetGravestMessage() const;
  std::string ListMessages() const;
  void SumUpMessages();
  bool Fail(unsigned long errorCode, const std::string& words);

  char* FileName = nullptr;
  char* SceneRoot = nullptr;
  int Engine = VRML97;
  int UpAxis = AS_IN_FILE;
  double ChordError = 0.001;
  int MaximumInlineDepth = 16;
  vtkTypeInt64 MaximumNumberOfNodes = 20000000;
  vtkTypeInt64 MaximumNumberOfTriangles = 400000000;
  vtkTypeInt64 MaximumFileSize = 2147483648;
  std::vector<std::string> Messages;
  std::vector<int> Severities;
};

#endif
