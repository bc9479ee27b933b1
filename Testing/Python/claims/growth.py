# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Charts D and E: how time and memory grow, and how fine a scan has to be."""

from claims.values import ACCURACY, Claim, growth, make_spread, power, sample


def make_claims():
    """Chart D."""
    largest = "9998244"
    hills = {count: growth("map", "map within 10 mm", "triangles", count, "ms")
             for count in ("100", "10000000")}
    memory = {name: growth("build", name, "triangles", "10000000", "peak MB")
              for name in ("Exact", "Fast")}
    scan = growth("scan", "Exact", "beams", largest, "peak MB")
    return [
        *make_spread(ACCURACY, "with about the third root of the triangles",
                     [power("scan", name, "triangles") for name in ("Exact", "Fast")], 0.28, 0.4),
        Claim(ACCURACY, "it grows in proportion", power("scan", "MollerTrumbore", "triangles"),
              0.93, 1.07),
        *make_spread(ACCURACY, "Building grows a little faster than the triangles",
                     [power("build", name, "triangles") for name in ("Exact", "Fast")], 1.02, 1.15),
        Claim(ACCURACY, "its memory in proportion", power("build", "Exact", "triangles", "memory"),
              0.95, 1.05),
        Claim(ACCURACY, "takes less than 0.9 GB", memory["Exact"] / 1000, 0.8, 0.9),
        Claim(ACCURACY, "keeps less than 0.6 GB",
              growth("build", "Exact", "triangles", "10000000", "held MB") / 1000, 0.5, 0.6),
        Claim(ACCURACY, "A scan's memory is in proportion to its beams",
              power("scan", "Exact", "beams", "memory"), 0.95, 1.05),
        *make_spread(ACCURACY, "its time grows a little less",
                     [power("scan", name, "beams") for name in ("Exact", "Fast")], 0.85, 0.97),
        Claim(ACCURACY, "10,000,000 beams in the room take about 0.64 GB", scan / 1000, 0.62, 0.66),
        *make_spread(ACCURACY, "`Exact` and `Fast` have about -1,",
                     [power("scan", name, "threads") for name in ("Exact", "Fast")], -1.1, -0.9),
        Claim(ACCURACY, "`AngleSum` has -0.8 here", power("scan", "AngleSum", "threads"),
              -0.85, -0.75),
        Claim(ACCURACY, "takes about 80 times as long as on the smallest",
              hills["10000000"] / hills["100"], 75, 85),
        Claim(ACCURACY, "The plain grid takes less than a hundredth of that",
              growth("map", "plain grid", "triangles", "10000000", "ms") / hills["10000000"],
              0.005, 0.01),
        Claim(ACCURACY, "a power of about -0.5", power("map", "map within 10 mm", "threads"),
              -0.55, -0.45),
        *make_spread(ACCURACY, "the plain grid and the build of `Exact` have about -1.",
                     [power("map", "plain grid", "threads"), power("build", "Exact", "threads")],
                     -1.1, -0.9),
        Claim(ACCURACY, "takes 1.9 times the memory of its scan",
              growth("map", "plain grid", "beams", largest, "peak MB") / scan, 1.85, 1.95),
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
