# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Options of the one map of many scans."""

from .. import vtkLMS3DMapFusion
from ..problems import UsageProblem


def add_fusion(parser):
    """Add the options of how the local maps are joined."""
    parser.add_argument("--forget-seen-through", action="store_true",
                        help="take surface out of the fused map if beams of a later pose pass through "
                        "it, such as the ranges between two surfaces that a real device measures at "
                        "their edges; its returns are then not within --maximum-error of the map")
    parser.add_argument("--drop-returns", action="store_true",
                        help="do not keep the ranges of earlier poses, four bytes for each beam, "
                        "while the fused map grows; what a later pose guesses between its returns is "
                        "then not checked against their beams")


def check(options):
    """Raise UsageProblem if the maps cannot be joined as the options say."""
    if options.maximum_error <= 0:
        raise UsageProblem("--maximum-error 0: the fused map needs a bound above 0")


def connect(simulation, options):
    """Join the maps of a simulation as the options say."""
    fusion = vtkLMS3DMapFusion()
    fusion.SetMaximumError(options.maximum_error)
    fusion.SetForgetSeenThrough(options.forget_seen_through)
    fusion.SetKeepReturns(not options.drop_returns)
    fusion.SetNumberOfThreads(options.threads)
    simulation.add_fusion(fusion)
