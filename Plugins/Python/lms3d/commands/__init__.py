# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The subcommands of the command line, one module each.

A module has NAME, SUMMARY (a line), DESCRIPTION and EPILOG (help texts), add_arguments(parser)
and run(options), which returns nothing and raises Problem if the job fails.
"""

from . import advise, compare, demo, emulate, info, scan, view

COMMANDS = (scan, compare, advise, view, emulate, info, demo)
