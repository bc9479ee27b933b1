// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief All options that the command line and a configuration file share.
 */
#ifndef lms3dOptionTable_h
#define lms3dOptionTable_h

struct lms3dServerOptions;

namespace CLI
{
class App;
}

/// Adds the options to `app`, whose parse() then writes the values into `options`, which must
/// outlive it, and throws CLI::ParseError. A later value replaces an earlier one; each --connect-to
/// adds one.
void lms3dAddServerOptions(CLI::App& app, lms3dServerOptions& options);

#endif
