// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqLMS3DDisplay
 * @brief gives each new output of LMS3D its first look in a view
 *
 * - A map is a surface of one colour without back faces, so that one sees into a closed room. Maps
 *   have different colours: green, then orange, blue and violet. A map has the same colour in a
 *   second view. Without this class a map would inherit the colours of its scan.
 * - A comparison shows LargestError, also without back faces.
 * - A range image stands upright (lms3dRangeImageView). Beams without a return are grey.
 * - A VRML scene, and the scan of a server, that comes first in a view is seen obliquely from
 *   above.
 *
 * An output is new when it is shown in a view for the first time, by the user or by Show() in the
 * Python shell. An output that a state, undo or redo restores keeps its look.
 */

#ifndef pqLMS3DDisplay_h
#define pqLMS3DDisplay_h

#include "lms3dAutoStart.h"

class pqRepresentation;
class pqView;

class pqLMS3DDisplay : public lms3dAutoStart
{
  Q_OBJECT

public:
  void startup() override;

private Q_SLOTS:
  /// Sets colours, before the output is shown.
  void color(pqRepresentation* added);
  void watch(pqView* added);
  /// Sets the camera, after the output was added to its view.
  void aim(pqRepresentation* shown);
};

#endif
