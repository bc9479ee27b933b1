// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVRMLImporterSource
 * @brief   reads the surfaces of a VRML 2.0 (VRML97) file as one vtkPolyData
 *
 * The output has the triangles of all shapes in world coordinates, in metres (VRML's unit), ready
 * for vtkLMS3DScanFilter. Triangles are counter-clockwise seen from the front.
 *
 * Cell data:
 * - `ShapeId` (int32): the index of the shape in the scene, from 0.
 * - `Color` (uint8, 4 components): red, green, blue, opacity. They come from the diffuse colour and
 *   the transparency of the Material, or from a Color node.
 *
 * Field data:
 * - `ShapeNames` (strings): the name of each shape. The name is the one given by DEF, or else the
 *   name of the nearest named node around the shape. Names outside prototypes come first.
 *
 * @par Supported nodes
 * The engine VRML97 reads every part of ISO/IEC 14772-1:1997 that makes surfaces:
 * - Box, Cone, Cylinder, ElevationGrid, Extrusion, IndexedFaceSet, Sphere. Faces can have any
 *   number of corners. They can be concave, also if `convex` is TRUE, and can have holes that a
 *   bridge joins to the outline.
 * - Transform, Group, Anchor, Billboard (not rotated), Collision (without its proxy), Switch, LOD
 *   (the first level).
 * - Inline, DEF and USE, PROTO and EXTERNPROTO.
 *
 * Files can be packed by gzip and can have any line ending. The reader shows the initial state of
 * the scene: it runs no ROUTE, interpolator or Script. It ignores lines, points, text, lights,
 * sounds and textures.
 *
 * @par Messages
 * The reader reports each fault of a file in a message with the file and the line, and reads the
 * rest. A message is an error if geometry is lost or misplaced, else a warning. If there are
 * messages, the reader calls vtkErrorMacro (if any message is an error) or vtkWarningMacro once.
 * The text contains the most severe message and the first 20 messages. The output then has the
 * surfaces that could be read, and the error code is NoError.
 *
 * @par Errors
 * After one of these errors the output is empty:
 * - NoFileNameError: FileName is not set.
 * - FileNotFoundError: the file does not exist or is not a regular file.
 * - CannotOpenFileError: the file cannot be opened.
 * - UnrecognizedFileTypeError: the file is not a VRML 2.0 file. The error names VRML 1.0, X3D, Open
 *   Inventor and binary files.
 * - FileFormatError: the file has no surface that can be read.
 * - UserError: the reader runs out of memory or fails in another way. No exception leaves the
 *   reader.
 *
 * vtkErrorCode defines these codes. After an error the reader reads the file again only if the
 * reader was modified. After an abort the output is empty, without an error or a message.
 *
 * @par Limits
 * A short text with nested USEs can stand for a huge scene. The default limits are about ten times
 * what large scenes need. At a limit the reader ends with an error that names it.
 *
 * @warning
 * The engine VTKImporter exists for comparison only. It uses vtkVRMLImporter:
 * - It reads IndexedFaceSets with explicit values under Transforms that are not nested and only
 *   translate.
 * - Box, Sphere, Cone and Cylinder of default size have half their size. Centres and the order of
 *   scales are lost. Faces with holes are lost. USE of a group has no effect.
 * - It ignores PROTO, EXTERNPROTO, Inline and ElevationGrid, and shows all children of Switch and
 *   LOD.
 * - Malformed files, and many correct ones, crash the process. So do two importers that exist at
 *   the same time. The importer is not thread safe.
 * - Messages have no line. Syntax errors appear on the terminal only. Shapes have no names.
 * - ChordError, SceneRoot and the limits have no effect.
 *
 * @sa
 * vtkLMS3DScanFilter vtkVRMLImporter
 */
#ifndef vtkVRMLImporterSource_h
#define vtkVRMLImporterSource_h

#include "vtkLMS3DReadersModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class VTKLMS3DREADERS_EXPORT vtkVRMLImporterSource : public vtkPolyDataAlgorithm
{
public:
  static vtkVRMLImporterSource* New();
  vtkTypeMacro(vtkVRMLImporterSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Returns 1 if the file can be opened and either begins as a VRML 2.0 file, packed by gzip or
   * not, or its name ends with .wrl, .vrml or .wrz in any case. Otherwise returns 0. So an
   * application that chooses its reader by this function, such as ParaView, shows this reader's
   * error for a file that has only the name of a VRML file.
   */
  static int CanReadFile(const char* fileName);

  ///@{
  /**
   * The file to read. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * The values of Engine: LMS3D's own reader, or vtkVRMLImporter (see the warning above).
   */
  enum Engines
  {
    VRML97 = 0,
    VTK_IMPORTER = 1
  };

  ///@{
  /**
   * The implementation that reads the file. Default: VRML97.
   */
  vtkSetClampMacro(Engine, int, VRML97, VTK_IMPORTER);
  vtkGetMacro(Engine, int);
  void SetEngineToVRML97() { this->SetEngine(VRML97); }
  void SetEngineToVTKImporter() { this->SetEngine(VTK_IMPORTER); }
  ///@}

  /**
   * The values of UpAxis. UP_AXIS_AS_IN_FILE leaves the coordinates unchanged. UP_AXIS_Y is for
   * files whose y axis points up, which is the convention of VRML browsers and modellers. It
   * rotates the scene by 90 degrees about x, so that z points up as in the sensor frame: (x, y, z)
   * becomes (x, -z, y).
   */
  enum UpAxes
  {
    UP_AXIS_AS_IN_FILE = 0,
    UP_AXIS_Y = 1
  };

  ///@{
  /**
   * The axis of the file that points up. Default: UP_AXIS_AS_IN_FILE, which never rotates a scene.
   */
  vtkSetClampMacro(UpAxis, int, UP_AXIS_AS_IN_FILE, UP_AXIS_Y);
  vtkGetMacro(UpAxis, int);
  void SetUpAxisToAsInFile() { this->SetUpAxis(UP_AXIS_AS_IN_FILE); }
  void SetUpAxisToY() { this->SetUpAxis(UP_AXIS_Y); }
  ///@}

  ///@{
  /**
   * The maximum distance of the triangles of a Sphere, Cone or Cylinder from its true surface, in
   * metres of the world. The points of the triangles are on the surface. Minimum: 1e-9. Default:
   * 0.001. A circle has between 8 and 2,048 sides; if 2,048 sides are too few, a message says so.
   */
  vtkSetClampMacro(ChordError, double, 1e-9, VTK_DOUBLE_MAX);
  vtkGetMacro(ChordError, double);
  ///@}

  ///@{
  /**
   * The root folder. The files of Inline and EXTERNPROTO must be in this folder or below it, after
   * links are resolved. Default: none, which means the folder of FileName. The reader never
   * accesses a network.
   */
  vtkSetFilePathMacro(SceneRoot);
  vtkGetFilePathMacro(SceneRoot);
  ///@}

  ///@{
  /**
   * The maximum nesting of Inlines, and the maximum number of files in a chain of EXTERNPROTOs.
   * Minimum: 0. Maximum: 1,000. Default: 16.
   */
  vtkSetClampMacro(MaximumInlineDepth, int, 0, 1000);
  vtkGetMacro(MaximumInlineDepth, int);
  ///@}

  ///@{
  /**
   * The maximum number of nodes in the files, and also the maximum number of visits to nodes, where
   * each USE and each instance counts again. The reader keeps the part of the scene before the
   * limit. Minimum: 0. Default: 2,000,000.
   */
  vtkSetClampMacro(MaximumNumberOfNodes, vtkTypeInt64, 0, VTK_TYPE_INT64_MAX);
  vtkGetMacro(MaximumNumberOfNodes, vtkTypeInt64);
  ///@}

  ///@{
  /**
   * The maximum number of triangles in the output. The reader keeps the shapes before the limit.
   * Faces without area count too, beyond an allowance of one million. Minimum: 0. Default:
   * 20,000,000.
   */
  vtkSetClampMacro(MaximumNumberOfTriangles, vtkTypeInt64, 0, VTK_TYPE_INT64_MAX);
  vtkGetMacro(MaximumNumberOfTriangles, vtkTypeInt64);
  ///@}

  ///@{
  /**
   * The maximum memory for nodes, values, meshes and the output, in bytes; released memory counts
   * too. The reader keeps the shapes before the limit; a file that exceeds it before its first
   * shape is made gives no output. Minimum: 0. Default: 2,000,000,000 (2 GB).
   */
  vtkSetClampMacro(MaximumMemory, vtkTypeInt64, 0, VTK_TYPE_INT64_MAX);
  vtkGetMacro(MaximumMemory, vtkTypeInt64);
  ///@}

  ///@{
  /**
   * The maximum size of all files of the scene together, unpacked, in bytes. The reader keeps the
   * part of the scene before the limit. Minimum: 0. Default: 1,000,000,000 (1 GB).
   */
  vtkSetClampMacro(MaximumFileSize, vtkTypeInt64, 0, VTK_TYPE_INT64_MAX);
  vtkGetMacro(MaximumFileSize, vtkTypeInt64);
  ///@}

  /**
   * The severity of a message. MESSAGE_ERROR means that geometry is lost or misplaced.
   */
  enum MessageSeverities
  {
    MESSAGE_WARNING = 0,
    MESSAGE_ERROR = 1
  };

  ///@{
  /**
   * The messages of the last execution, numbered from 0. The form is "file:line: text", or shorter
   * if the line or the file is not known. If the index is out of range, the message is empty and
   * its severity is MESSAGE_WARNING.
   */
  int GetNumberOfMessages() const;
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

  char* FileName = nullptr;
  char* SceneRoot = nullptr;
  int Engine = VRML97;
  int UpAxis = UP_AXIS_AS_IN_FILE;
  double ChordError = 0.001;
  int MaximumInlineDepth = 16;
  vtkTypeInt64 MaximumNumberOfNodes = 2000000;
  vtkTypeInt64 MaximumNumberOfTriangles = 20000000;
  vtkTypeInt64 MaximumMemory = 2000000000;
  vtkTypeInt64 MaximumFileSize = 1000000000;

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
