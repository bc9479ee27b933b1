# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The command line: one parser, with a subcommand for each module of `commands`."""

import argparse
import os
import re
import sys

from . import __version__
from .commands import COMMANDS
from .problems import Problem, UsageProblem

_DESCRIPTION = """\
A simulated 3D laser range finder: a SICK LMS 200 on a rotating support scans a scene.

Lengths are in metres, angles in degrees. Scenes and sensor are right-handed with z up.
A beam with elevation alpha in the fan, on a support turned by beta, points along
(cos(alpha) cos(beta), -cos(alpha) sin(beta), sin(alpha)): beta turns clockwise seen from
above. By default 361 beams from -90 to 90 in each of 360 turns of one degree.
"""

_EPILOG = """\
exit codes: 0 success, 1 the job failed, 2 the command was invalid, 130 Ctrl-C

examples:
  lms3d scan room.wrl --position 0.3 -0.2 1 -o scan.vtp --map map.vtp
  lms3d scan room.wrl --position 0.3 -0.2 1 -o reported.vtp --device lms200-mm
  lms3d compare map.vtp room.wrl
  lms3d view room.wrl --position 0.3 -0.2 1
  lms3d emulate room.wrl --position 0.3 -0.2 1 --link /tmp/lms200
  lms3d demo --output demo

'lms3d COMMAND --help' explains each command.
"""

_INTERRUPTED = 130  # as shells report it: 128 and the number of the signal

# argparse takes "-1e-3" for an option, unless it begins with a blank.
_NEGATIVE_NUMBER = re.compile(r"-\.?\d")


class _Parser(argparse.ArgumentParser):
    """A parser that keeps the line breaks of its help and prints each error as one line."""

    def __init__(self, **options):
        super().__init__(formatter_class=argparse.RawDescriptionHelpFormatter,
                         allow_abbrev=False, **options)

    def error(self, message):
        self.exit(UsageProblem.exit_code,
                  f"lms3d: error: {message}; see '{self.prog} --help'\n")


def build_parser():
    """The parser of the whole command line."""
    parser = _Parser(prog="lms3d", description=_DESCRIPTION, epilog=_EPILOG)
    parser.add_argument("--version", action="version", version=f"lms3d {__version__}")
    subparsers = parser.add_subparsers(title="commands", metavar="COMMAND", required=True)
    for command in COMMANDS:
        subparser = subparsers.add_parser(command.NAME, help=command.SUMMARY,
                                          description=command.DESCRIPTION, epilog=command.EPILOG)
        command.add_arguments(subparser)
        subparser.set_defaults(run=command.run)
    return parser


def main(arguments=None):
    """Run the command line; returns the exit code, which the help explains."""
    words = sys.argv[1:] if arguments is None else arguments
    options = build_parser().parse_args(
        [f" {word}" if _NEGATIVE_NUMBER.match(word) else word for word in words]
    )
    try:
        options.run(options)
        if sys.stdout:
            sys.stdout.flush()
    except Problem as problem:
        return _fail(problem, problem.exit_code)
    except MemoryError:
        return _fail("not enough memory", Problem.exit_code)
    except OSError as error:
        return _fail(_explain(error), Problem.exit_code)
    except KeyboardInterrupt:
        return _fail("interrupted", _INTERRUPTED)
    return 0


def _fail(message, exit_code):
    print(f"lms3d: error: {message}", file=sys.stderr)
    return exit_code


def _explain(error):
    """What failed: the use of a file, or else printing.

    After printing has failed, print no more: at its end Python would print a traceback.
    """
    if error.filename is not None:
        return f"cannot use '{error.filename}': {error.strerror}"
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
    return f"cannot print to the standard output: {error.strerror}"
