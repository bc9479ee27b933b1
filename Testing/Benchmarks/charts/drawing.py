# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the charts have in common: their look, their caption, their files."""

import os
import platform
import subprocess
import textwrap

import lms3d
import matplotlib
from vtkmodules.vtkCommonCore import vtkVersion

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402  (after the choice of what draws)

# The palette of Okabe and Ito (2008): colour-blind people can distinguish its colours.
COLORS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00")

pyplot.rcParams.update({
    "font.size": 9,
    "axes.titlesize": 10,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": "#dddddd",
    "grid.linewidth": 0.6,
    "lines.linewidth": 1.6,
    "legend.frameon": False,
})


def _processor():
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        names = [line.split(":", 1)[1].strip() for line in file if line.startswith("model name")]
    return names[0] if names else platform.machine()


def _system():
    with open("/etc/os-release", encoding="utf-8") as file:
        fields = dict(line.rstrip().split("=", 1) for line in file if "=" in line)
    return fields.get("PRETTY_NAME", "Linux").strip('"')


def _embree():
    """The version of the package that holds Embree's library, without the distribution's part."""
    command = ["dpkg-query", "-W", "-f", "${Version}\n", "libembree3*", "libembree4*"]
    lines = subprocess.run(command, text=True, capture_output=True, check=False).stdout.split()
    return lines[0].split("+")[0].split("-")[0] if lines else "of unknown version"


def name_machine():
    """What measures and on what, to be kept beside the table that comes of it."""
    return (f"LMS3D {lms3d.__version__}, VTK {vtkVersion.GetVTKVersion()}, Embree {_embree()}, "
            f"{_system()}, {_processor()}, {len(os.sched_getaffinity(0))} cores")


def caption(words, machine, threads="1 thread"):
    """What was measured, by what and on what."""
    return f"{words} {machine}, {threads}."


def add_caption(figure, text, width):
    """Write a caption below the axes, in lines of at most width letters."""
    figure.text(0.01, 0.008, textwrap.fill(text, width), fontsize=7, color="#555555", va="bottom")


def save(figure, path):
    """Save a figure as PNG."""
    figure.savefig(f"{path}.png", dpi=120)
    pyplot.close(figure)
