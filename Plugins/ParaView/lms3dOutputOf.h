// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Finds out which output of LMS3D a representation shows.
 */

#ifndef lms3dOutputOf_h
#define lms3dOutputOf_h

#include <vtkSMPropertyHelper.h>
#include <vtkSMProxy.h>

#include <cstring>

/**
 * Whether `shown`, the proxy of a representation, shows output `port` of a proxy with the XML name
 * `source`. Reads the proxies, because a new Qt representation does not have its input yet.
 */
inline bool lms3dIsOutputOf(vtkSMProxy* shown, const char* source, unsigned int port)
{
  const vtkSMPropertyHelper input(shown, "Input", true);
  vtkSMProxy* producer = input.GetNumberOfElements() > 0 ? input.GetAsProxy() : nullptr;
  return producer && !std::strcmp(producer->GetXMLName(), source) && input.GetOutputPort() == port;
}

inline bool lms3dIsRangeImage(vtkSMProxy* shown)
{
  return lms3dIsOutputOf(shown, "LMS3DScan", 1);
}

#endif
