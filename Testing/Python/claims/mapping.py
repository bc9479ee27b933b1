# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Chart B: what a map costs."""

from claims.values import (ACCURACY, PRO, QUADRICS, Claim, bounded, damaged, grid, local_map,
                           make_spread)


def make_claims():
    """Chart B, as accuracy.md describes it."""
    poisson = {"name": "Open3D Poisson depth 9", "bound": "-"}
    surface = {"name": "vtkSurfaceReconstructionFilter", "bound": "-"}
    ms, triangles, farthest = "ms", "triangles", "farthest return mm"
    hills = {"scene": "terrain1e5"}
    near = {"scene": "terrain1e5", "column": "to scene mean mm"}
    missing = {"scene": "terrain1e5", "column": "to map mean mm"}
    return [
        Claim(ACCURACY, "less than a hundredth of the plain grid's triangles",
              bounded("10", column=triangles) / grid(column=triangles), 0.005, 0.01),
        Claim(ACCURACY, "about 60 % of its error", bounded("10") / grid(), 0.55, 0.65),
        Claim(ACCURACY, "It takes about four times as long",
              bounded("10", column=ms) / grid(column=ms), 3.5, 4.7),
        Claim(ACCURACY, "takes more than 250 times as long as the map",
              local_map(PRO, "10", column=ms) / bounded("10", column=ms), 250, 400),
        Claim(ACCURACY, "has twice the error", local_map(QUADRICS, "10") / bounded("10"),
              1.8, 2.2),
        Claim(ACCURACY, "`vtkDecimatePro` more than eight times",
              local_map(PRO, "10") / bounded("10"), 8, 9),
        Claim(ACCURACY, "the room's map has two fifths of the grid's error",
              bounded("20", "5") / grid("5"), 0.37, 0.43),
        Claim(ACCURACY, "takes about 14 seconds in the room", local_map(**surface, column=ms) / 1000,
              12, 16),
        Claim(ACCURACY, "with noise more than a minute",
              local_map(**surface, noise="5", column=ms) / 1000, 60, 100),
        Claim(ACCURACY, "more than 100 times the map's error",
              local_map(**surface) / bounded("10"), 100, 200),
        Claim(ACCURACY, "takes about five seconds", local_map(**poisson, column=ms) / 1000, 4, 6),
        Claim(ACCURACY, "has about 17 times the error", local_map(**poisson) / bounded("10"),
              14, 20),
        Claim(ACCURACY, "the scan has hit a third of them",
              grid(column="hit triangles") / grid(column="scene triangles"), 0.3, 0.36),
        Claim(ACCURACY, "the scan has hit twice as many triangles as the map",
              grid(scene="teapot", column="hit triangles")
              / bounded("10", scene="teapot", column=triangles), 1.9, 2.2),
        Claim(ACCURACY, "decimation has more than a quarter less error than the map",
              1 - local_map(QUADRICS, "10", scene="teapot") / bounded("10", scene="teapot"),
              0.25, 0.33),
        Claim(ACCURACY, "With noise the plain grid has two fifths less error",
              1 - grid("5", "teapot") / bounded("20", "5", "teapot"), 0.35, 0.45),
        *make_spread(ACCURACY, "from the decimated grid, as from the plain grid, the farthest "
                     "return is seven times as far",
                     [distance / bounded("10", scene="teapot", column=farthest) for distance in
                      (local_map(QUADRICS, "10", scene="teapot", column=farthest),
                       grid(scene="teapot", column=farthest))], 6.5, 7.5),
        Claim(ACCURACY, "takes about ten times the triangles",
              bounded("10", "5", column=triangles) / bounded("20", "5", column=triangles), 9, 11),
        Claim(ACCURACY, "about twelve times the time",
              bounded("10", "5", column=ms) / bounded("20", "5", column=ms), 10, 14),
        Claim(ACCURACY, "takes about 70 times as long as the grid",
              bounded("10", **hills, column=ms) / grid(**hills, column=ms), 60, 80),
        Claim(ACCURACY, "with noise more than 200 times",
              bounded("10", "5", **hills, column=ms) / grid("5", **hills, column=ms), 200, 260),
        Claim(ACCURACY, "has a tenth of the grid's triangles",
              bounded("10", **hills, column=triangles) / grid(**hills, column=triangles),
              0.085, 0.115),
        Claim(ACCURACY, "almost four times as many as the scan has hit",
              bounded("10", **hills, column=triangles) / grid(**hills, column="hit triangles"),
              3.6, 4),
        Claim(ACCURACY, "twice as far from the scene as the grid",
              bounded("10", **near) / grid(**near), 1.9, 2.1),
        Claim(ACCURACY, "misses less than half as much of the scene",
              bounded("10", **missing) / grid(**missing), 0.3, 0.5),
        Claim(ACCURACY, "the open map has about 25 times the triangles of the ideal one",
              damaged("5 % lost", "open triangles") / damaged("none", "triangles"), 23, 27),
        Claim(ACCURACY, "the closed map less than twice as many", damaged("5 % lost"), 1, 2),
        Claim(ACCURACY, "With all errors it has 1.7 times as many",
              damaged("all"), 1.6, 1.8),
        *make_spread(ACCURACY, "with 20 % lost or with 1 % strays between three and four times as many",
                     [damaged("20 % lost"), damaged("1 % strays")], 3, 4),
    ]
