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
        Claim(ACCURACY, "half a per cent of the plain grid's triangles",
              bounded("10", column=triangles) / grid(column=triangles), 0.004, 0.0055),
        Claim(ACCURACY, "half of its error", bounded("10") / grid(), 0.45, 0.55),
        Claim(ACCURACY, "It takes about four times as long",
              bounded("10", column=ms) / grid(column=ms), 3.5, 4.7),
        Claim(ACCURACY, "takes more than 250 times as long as the map",
              local_map(PRO, "10", column=ms) / bounded("10", column=ms), 250, 400),
        Claim(ACCURACY, "has more than twice the error", local_map(QUADRICS, "10") / bounded("10"),
              2, 3),
        Claim(ACCURACY, "`vtkDecimatePro` more than six times",
              local_map(PRO, "10") / bounded("10"), 6, 7.5),
        Claim(ACCURACY, "the room's map has two fifths of the grid's error",
              bounded("20", "5") / grid("5"), 0.37, 0.43),
        Claim(ACCURACY, "takes about ten seconds in the room", local_map(**surface, column=ms) / 1000,
              8.5, 12),
        Claim(ACCURACY, "with noise about a minute",
              local_map(**surface, noise="5", column=ms) / 1000, 50, 70),
        Claim(ACCURACY, "more than 100 times the map's error",
              local_map(**surface) / bounded("10"), 100, 200),
        Claim(ACCURACY, "takes about three seconds", local_map(**poisson, column=ms) / 1000, 2.5, 3.5),
        Claim(ACCURACY, "has about 12 times the error", local_map(**poisson) / bounded("10"),
              10.5, 13.5),
        Claim(ACCURACY, "the scan has hit a third of them",
              grid(column="hit triangles") / grid(column="scene triangles"), 0.3, 0.36),
        Claim(ACCURACY, "the scan has hit more than twice as many triangles as the map",
              grid(scene="teapot", column="hit triangles")
              / bounded("10", scene="teapot", column=triangles), 2, 2.7),
        Claim(ACCURACY, "With noise the plain grid has two fifths less error",
              1 - grid("5", "teapot") / bounded("20", "5", "teapot"), 0.35, 0.45),
        *make_spread(ACCURACY, "from the decimated grid, as from the plain grid, the farthest "
                     "return is more than eight times as far",
                     [distance / bounded("10", scene="teapot", column=farthest) for distance in
                      (local_map(QUADRICS, "10", scene="teapot", column=farthest),
                       grid(scene="teapot", column=farthest))], 8, 9),
        Claim(ACCURACY, "takes about eleven times the triangles",
              bounded("10", "5", column=triangles) / bounded("20", "5", column=triangles), 10, 12),
        Claim(ACCURACY, "about nine times the time",
              bounded("10", "5", column=ms) / bounded("20", "5", column=ms), 8, 10.5),
        Claim(ACCURACY, "takes about 40 times as long as the grid",
              bounded("10", **hills, column=ms) / grid(**hills, column=ms), 35, 46),
        Claim(ACCURACY, "with noise about 120 times",
              bounded("10", "5", **hills, column=ms) / grid("5", **hills, column=ms), 105, 140),
        Claim(ACCURACY, "has a tenth of the grid's triangles",
              bounded("10", **hills, column=triangles) / grid(**hills, column=triangles),
              0.085, 0.115),
        Claim(ACCURACY, "almost four times as many as the scan has hit",
              bounded("10", **hills, column=triangles) / grid(**hills, column="hit triangles"),
              3.6, 4),
        Claim(ACCURACY, "three times as far from the scene as the grid",
              bounded("10", **near) / grid(**near), 2.7, 3.3),
        Claim(ACCURACY, "misses less than half as much of the scene",
              bounded("10", **missing) / grid(**missing), 0.3, 0.5),
        Claim(ACCURACY, "the open map has about 27 times the triangles of the ideal one",
              damaged("5 % lost", "open triangles") / damaged("none", "triangles"), 25, 30),
        Claim(ACCURACY, "the closed map less than twice as many", damaged("5 % lost"), 1, 2),
        Claim(ACCURACY, "With all errors it has 1.7 times as many",
              damaged("all"), 1.6, 1.8),
        Claim(ACCURACY, "with 1 % strays 2.5 times as many", damaged("1 % strays"), 2.4, 2.6),
        Claim(ACCURACY, "with 20 % lost almost four times as many", damaged("20 % lost"), 3.6, 4),
    ]
