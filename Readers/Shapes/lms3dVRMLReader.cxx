// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes/lms3dVRMLReader.h"

#include "Evaluation/lms3dVRMLDocumentCache.h"
#include "Grammar/lms3dVRMLContext.h"
#include "Shapes/lms3dVRMLTraversal.h"

lms3dScene lms3dReadVRML(const std::string& fileName, const lms3dVRMLOptions& options,
  const lms3dProgressFunction& progress)
{
  lms3dVRMLContext context(options, progress);
  lms3dVRMLDocumentCache documents(context);
  lms3dScene scene;
  if (const lms3dVRMLDocument* document = documents.ReadScene(fileName))
  {
    scene.Shapes = lms3dVRMLTraversal(context, documents).CollectShapes(*document);
  }
  scene.Messages = context.Messages.Take();
  return scene;
}
