# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Charts D and E: how time and memory grow, and how fine a scan has to be."""

from claims.values import ACCURACY, Claim, growth, make_spread, power, sample


def make_claims():
    """Chart D."""
    largest = "9998244"
    hills = {count: growth("map", "map within 10 mm", "triangles", count, "ms")
             for count in ("100", "100000", "10000000")}
    memory = {name: growth("build", name, "triangles", "10000000", "peak MB")
              for name in ("Exact", "Fast")}
    scan = growth("scan", "Exact", "beams", largest, "peak MB")
    return [
        *make_spread(ACCURACY, "with about the fourth root of the triangles",
                     [power("scan", name, "triangles") for name in ("Exact", "Fast")], 0.2, 0.3),
        Claim(ACCURACY, "it grows in proportion", power("scan", "MollerTrumbore", "triangles"),
              0.93, 1.07),
        *make_spread(ACCURACY, "Building grows a little faster than the triangles",
                     [power("build", name, "triangles") for name in ("Exact", "Fast")], 1.02, 1.15),
        Claim(ACCURACY, "its memory in proportion", power("build", "Exact", "triangles", "memory"),
              0.95, 1.05),
        Claim(ACCURACY, "takes less than 0.9 GB", memory["Exact"] / 1000, 0.8, 0.9),
        Claim(ACCURACY, "keeps less than 0.6 GB",
              growth("build", "Exact", "triangles", "10000000", "held MB") / 1000, 0.5, 0.6),
        *make_spread(ACCURACY, "nearly in proportion to its beams",
                     [power("scan", "Exact", "beams", kind) for kind in ("time", "memory")],
                     0.95, 1.05),
        Claim(ACCURACY, "take about 0.7 GB", scan / 1000, 0.65, 0.75),
        Claim(ACCURACY, "`AngleSum` has it", power("scan", "AngleSum", "threads"), -1.1, -0.9),
        *make_spread(ACCURACY, "`Exact` and `Fast` have about -0.8 here",
                     [power("scan", name, "threads") for name in ("Exact", "Fast")], -0.88, -0.72),
        Claim(ACCURACY, "almost seven times as high as on the smallest hills",
              hills["100000"] / hills["100"], 6.4, 7),
        Claim(ACCURACY, "twice as high as on the largest",
              hills["100000"] / hills["10000000"], 1.8, 2.2),
        Claim(ACCURACY, "The plain grid takes less than a tenth of that",
              growth("map", "plain grid", "triangles", "10000000", "ms") / hills["10000000"],
              0.05, 0.1),
        Claim(ACCURACY, "a power of about -0.4", power("map", "map within 10 mm", "threads"),
              -0.45, -0.35),
        *make_spread(ACCURACY, "the plain grid and the build of `Exact` have about -0.9",
                     [power("map", "plain grid", "threads"), power("build", "Exact", "threads")],
                     -1, -0.8),
        Claim(ACCURACY, "takes 1.7 times the memory of its scan",
              growth("map", "plain grid", "beams", largest, "peak MB") / scan, 1.65, 1.75),
        Claim(ACCURACY, "needs 1.4 times the memory of `Exact`", memory["Fast"] / memory["Exact"],
              1.35, 1.45),
    ]


def make_sampling_claims():
    """Chart E."""
    step = sample("room", "1", "10") - sample("room", "2", "10")
    bound = sample("room", "2", "1") - sample("room", "2", "10")
    teapot = [sample("teapot", "1", name) for name in ("0", "1")]
    errors = [sample("teapot", "0.5", name, "map to scene 95% mm") for name in ("5", "1")]
    return [
        Claim(ACCURACY, "about nine tenths of the visible room", sample("room", "2", "10"),
              0.88, 0.93),
        Claim(ACCURACY, "which cuts every corner, about four fifths", sample("room", "2", "0"),
              0.78, 0.84),
        Claim(ACCURACY, "Half the step gains 5 %", step, 0.045, 0.055),
        Claim(ACCURACY, "a tenth of the bound gains less than 1 %", bound, 0, 0.01),
        Claim(ACCURACY, "less than 1 % of the grid's triangles",
              sample("room", "0.5", "10", "triangles") / sample("room", "0.5", "0", "triangles"),
              0.002, 0.01),
        Claim(ACCURACY, "is off by more than 13 mm", errors[0], 13, 15),
        Claim(ACCURACY, "of the map within 1 mm by less than 2 mm", errors[1], 1.5, 2),
        *make_spread(ACCURACY, "have about 70 % of the teapot", teapot, 0.68, 0.73),
    ]
