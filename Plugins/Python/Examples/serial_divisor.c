// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/*
 * Lets drivers set a custom divisor on a pseudo-terminal, which has none and refuses the request. The
 * answer to TIOCGSERIAL is an ordinary port, and TIOCSSERIAL does nothing.
 *
 *     gcc -shared -fPIC -o serial_divisor.so serial_divisor.c
 *     LD_PRELOAD=./serial_divisor.so DRIVER
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <linux/serial.h>
#include <stdarg.h>
#include <string.h>
#include <sys/ioctl.h>

int ioctl(int file, unsigned long request, ...)
{
  va_list arguments;
  va_start(arguments, request);
  void* argument = va_arg(arguments, void*);
  va_end(arguments);
  int (*next)(int, unsigned long, ...) =
    (int (*)(int, unsigned long, ...))dlsym(RTLD_NEXT, "ioctl");
  int result = next(file, request, argument);
  if (result == 0 || (errno != ENOTTY && errno != EINVAL))
  {
    return result;
  }
  if (request == TIOCGSERIAL)
  {
    memset(argument, 0, sizeof(struct serial_struct));
    ((struct serial_struct*)argument)->baud_base = 24000000;
    return 0;
  }
  return request == TIOCSSERIAL ? 0 : result;
}
