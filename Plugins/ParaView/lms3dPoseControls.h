// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Adapts ParaView's box widget and its controls to a sensor.
 */

#ifndef lms3dPoseControls_h
#define lms3dPoseControls_h

class QWidget;
class vtkSMProxy;

/**
 * Hides the controls that fit a box to its input. Puts the labels, with units, above the number
 * fields, so that the three fields fit into a panel of the default width, with signs. A field shows
 * the beginning of a longer number.
 */
void lms3dArrangePoseControls(QWidget* panel);

/// Draws the box without the balls that resize it, and on top of the scene.
void lms3dStyleBox(vtkSMProxy* representation);

#endif
