// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqLMS3DLegendUnits
 * @brief adds the unit to the legends of ranges, errors and angles
 *
 * Changes the title of a new legend that an output of LMS3D uses, such as Range to Range (m). A
 * legend that a state, undo or redo restores keeps its title.
 */

#ifndef pqLMS3DLegendUnits_h
#define pqLMS3DLegendUnits_h

#include "lms3dAutoStart.h"

class pqRepresentation;

class pqLMS3DLegendUnits : public lms3dAutoStart
{
  Q_OBJECT

public:
  void startup() override;

private Q_SLOTS:
  void label(pqRepresentation* added);
};

#endif
