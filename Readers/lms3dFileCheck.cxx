// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dFileCheck.h"

#include "Files/lms3dFile.h"
#include "Files/lms3dVRMLHeader.h"

#include <vtkErrorCode.h>

#include <fstream>

void lms3dCheckFile(const char* fileName, bool isPackedAllowed)
{
  if (!fileName || !*fileName)
  {
    throw lms3dReadFailure{ vtkErrorCode::NoFileNameError,
      "There is no FileName to read; set one." };
  }
  const std::string name = fileName;
  if (!lms3dIsRegularFile(name))
  {
    throw lms3dReadFailure{ vtkErrorCode::FileNotFoundError,
      name + " does not exist or is not a regular file; check FileName." };
  }
  if (!std::ifstream(name, std::ios::binary).is_open())
  {
    throw lms3dReadFailure{ vtkErrorCode::CannotOpenFileError,
      name + " cannot be opened; check its permissions." };
  }
  const std::string problem =
    lms3dExplainBeginning(lms3dReadBeginning(name, lms3dVRMLHeaderLength));
  if (!problem.empty())
  {
    throw lms3dReadFailure{ vtkErrorCode::UnrecognizedFileTypeError, name + " " + problem + "." };
  }
  if (!isPackedAllowed && lms3dIsPackedFile(name))
  {
    throw lms3dReadFailure{ vtkErrorCode::UnrecognizedFileTypeError,
      name + " is packed by gzip, which vtkVRMLImporter cannot read; set the engine VRML97." };
  }
}
