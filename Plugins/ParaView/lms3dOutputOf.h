// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Finds out which outputs representations and views show.
 */

#ifndef lms3dOutputOf_h
#define lms3dOutputOf_h

#include <pqRepresentation.h>
#include <pqView.h>

#include <vtkSMPropertyHelper.h>
#include <vtkSMProxy.h>

#include <algorithm>
#include <cstring>

/// The source whose output `shown`, the proxy of a representation, shows, or null.
inline vtkSMProxy* lms3dGetSourceOf(vtkSMProxy* shown)
{
  const vtkSMPropertyHelper input(shown, "Input", true);
  return input.GetNumberOfElements() > 0 ? input.GetAsProxy() : nullptr;
}

/**
 * Whether `shown`, the proxy of a representation, shows output `port` of a proxy with the XML name
 * `source`. Reads the proxies, because a new Qt representation does not have its input yet.
 */
inline bool lms3dIsOutputOf(vtkSMProxy* shown, const char* source, unsigned int port)
{
  vtkSMProxy* producer = lms3dGetSourceOf(shown);
  return producer && !std::strcmp(producer->GetXMLName(), source) &&
    vtkSMPropertyHelper(shown, "Input").GetOutputPort() == port;
}

inline bool lms3dIsRangeImage(vtkSMProxy* shown)
{
  return lms3dIsOutputOf(shown, "LMS3DScan", 1) || lms3dIsOutputOf(shown, "LMS3DRangeError", 1);
}

/// Whether `view` has a visible representation whose proxy passes `test`.
template <typename Test>
bool lms3dShows(const pqView* view, Test test)
{
  const QList<pqRepresentation*> all = view->getRepresentations();
  return std::any_of(all.begin(), all.end(),
    [&test](const pqRepresentation* shown)
    { return shown->isVisible() && test(shown->getProxy()); });
}

#endif
