// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief measureWithCoin FILE: what another VRML reader, Coin, makes of a scene
 *
 * Prints one line: the number of triangles, their area, and their bounds as xmin ymin zmin xmax
 * ymax zmax. A program of its own, since Coin may crash on what it reads. Exit code 1: Coin rejects
 * it. Without a file it prints Coin's version.
 */
#include <Inventor/SbMatrix.h>
#include <Inventor/SbVec3d.h>
#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/VRMLnodes/SoVRMLGeometry.h>
#include <Inventor/VRMLnodes/SoVRMLGroup.h>
#include <Inventor/VRMLnodes/SoVRMLText.h>
#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/errors/SoDebugError.h>
#include <Inventor/errors/SoReadError.h>
#include <Inventor/nodes/SoComplexity.h>
#include <Inventor/nodes/SoSeparator.h>

#include <algorithm>
#include <cstdio>
#include <limits>

namespace
{
struct Measures
{
  void Add(const SbVec3d& a, const SbVec3d& b, const SbVec3d& c)
  {
    ++this->Triangles;
    this->Area += (b - a).cross(c - a).length() / 2;
    for (const SbVec3d& p : { a, b, c })
    {
      for (int i = 0; i < 3; ++i)
      {
        this->Minimum[i] = std::min(this->Minimum[i], p[i]);
        this->Maximum[i] = std::max(this->Maximum[i], p[i]);
      }
    }
  }

  long Triangles = 0;
  double Area = 0;
  double Minimum[3] = { Infinity, Infinity, Infinity };
  double Maximum[3] = { -Infinity, -Infinity, -Infinity };

  static constexpr double Infinity = std::numeric_limits<double>::infinity();
};

SbVec3d InWorld(SoCallbackAction* action, const SoPrimitiveVertex* vertex)
{
  SbVec3f world;
  action->getModelMatrix().multVecMatrix(vertex->getPoint(), world);
  return SbVec3d(world);
}

void AddTriangle(void* measures, SoCallbackAction* action, const SoPrimitiveVertex* a,
  const SoPrimitiveVertex* b, const SoPrimitiveVertex* c)
{
  static_cast<Measures*>(measures)->Add(InWorld(action, a), InWorld(action, b), InWorld(action, c));
}

SoCallbackAction::Response Prune(void*, SoCallbackAction*, const SoNode*)
{
  return SoCallbackAction::PRUNE;
}

void BeSilent(const SoError*, void*) {}

SoNode* Read(const char* fileName)
{
  SoInput input;
  return input.openFile(fileName) ? SoDB::readAllVRML(&input) : nullptr;
}
} // namespace

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::puts(COIN_VERSION);
    return 0;
  }
  SoDB::init();
  SoError::setHandlerCallback(BeSilent, nullptr);
  SoReadError::setHandlerCallback(BeSilent, nullptr);
  SoDebugError::setHandlerCallback(BeSilent, nullptr);
  SoNode* scene = Read(argv[1]);
  if (!scene)
  {
    return 1;
  }

  auto* root = new SoSeparator;
  root->ref();
  auto* complexity = new SoComplexity;
  complexity->value = 1.0f;
  root->addChild(complexity);
  root->addChild(scene);

  Measures measures;
  SoCallbackAction action;
  action.addPreCallback(SoVRMLText::getClassTypeId(), Prune, nullptr);
  action.addTriangleCallback(SoVRMLGeometry::getClassTypeId(), AddTriangle, &measures);
  action.apply(root);
  std::printf("%ld %.9g", measures.Triangles, measures.Area);
  for (const double* bounds : { measures.Minimum, measures.Maximum })
  {
    std::printf(" %.9g %.9g %.9g", bounds[0], bounds[1], bounds[2]);
  }
  std::printf("\n");
  return 0;
}
