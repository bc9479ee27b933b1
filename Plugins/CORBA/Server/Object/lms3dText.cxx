// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dText.h"

#include <cstddef>

CORBA::String_var lms3dText(const std::string& text)
{
  // The bound in LMS3DScanner.idl.
  constexpr std::size_t Longest = 512;
  std::string plain = text.substr(0, Longest);
  for (char& character : plain)
  {
    if (character < 0x20 || character > 0x7e)
    {
      character = character == '\n' ? ' ' : '?';
    }
  }
  return CORBA::string_dup(plain.c_str());
}
