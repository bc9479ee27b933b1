// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class lms3dRangeImageView
 * @brief lets a range image stand upright while a render view shows it alone
 *
 * The platform angle increases to the right, the elevation upwards, and the mouse moves the image
 * in its plane. When the image is hidden or deleted, the view has its former camera and interaction
 * mode back.
 *
 * The image stays as it is if a script sets the camera right after it shows the image. The former
 * camera does not come back if the user or a script has turned the camera meanwhile.
 */

#ifndef lms3dRangeImageView_h
#define lms3dRangeImageView_h

#include "lms3dCamera.h"

#include <QObject>

class pqRenderView;
class pqRepresentation;

class lms3dRangeImageView : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  /// The view owns this object.
  explicit lms3dRangeImageView(pqRenderView* view);

private Q_SLOTS:
  void watch(pqRepresentation* added);
  void update();
  /// Notes the camera that ParaView sets for a new output.
  void noteCamera();
  void standUpright();

private:
  Q_DISABLE_COPY(lms3dRangeImageView)

  pqRenderView* View;
  bool IsShown = false;
  lms3dCamera Former{}; // before the image was shown
  lms3dCamera Expected{}; // if no script changes it
};

#endif
