# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Chart B: what a map costs."""

from claims.values import (ACCURACY, PRO, QUADRICS, Claim, bounded, grid, local_map,
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
        Claim(ACCURACY, "It takes between two and three times as long",
              bounded("10", column=ms) / grid(column=ms), 2, 3),
        Claim(ACCURACY, "takes more than 500 times as long as the map",
              local_map(QUADRICS, "10", column=ms) / bounded("10", column=ms), 500, 700),
        Claim(ACCURACY, "has almost twice the error", local_map(QUADRICS, "10") / bounded("10"),
              1.7, 2),
        Claim(ACCURACY, "`vtkDecimatePro` almost seven times",
              local_map(PRO, "10") / bounded("10"), 6.5, 7),
        Claim(ACCURACY, "the room's map has half the grid's error",
              bounded("20", "5") / grid("5"), 0.45, 0.55),
        Claim(ACCURACY, "takes ten seconds in the room", local_map(**surface, column=ms) / 1000,
              8.5, 11.5),
        Claim(ACCURACY, "with noise more than a minute",
              local_map(**surface, noise="5", column=ms) / 1000, 60, 100),
        Claim(ACCURACY, "more than 100 times the map's error",
              local_map(**surface) / bounded("10"), 100, 200),
        Claim(ACCURACY, "takes six seconds", local_map(**poisson, column=ms) / 1000, 5, 7),
        Claim(ACCURACY, "has about 17 times the error", local_map(**poisson) / bounded("10"),
              14, 20),
        Claim(ACCURACY, "the scan has hit a third of them",
              grid(column="hit triangles") / grid(column="scene triangles"), 0.3, 0.36),
        Claim(ACCURACY, "the scan has hit twice as many triangles as the map",
              grid(scene="teapot", column="hit triangles")
              / bounded("10", scene="teapot", column=triangles), 1.9, 2.2),
        Claim(ACCURACY, "decimation has about a quarter less error than the map",
              1 - local_map(QUADRICS, "10", scene="teapot") / bounded("10", scene="teapot"),
              0.2, 0.3),
        Claim(ACCURACY, "With noise the plain grid has two fifths less error",
              1 - grid("5", "teapot") / bounded("20", "5", "teapot"), 0.35, 0.45),
        *make_spread(ACCURACY, "from the decimated grid, as from the plain grid, the farthest "
                     "return is eight times as far",
                     [distance / bounded("10", scene="teapot", column=farthest) for distance in
                      (local_map(QUADRICS, "10", scene="teapot", column=farthest),
                       grid(scene="teapot", column=farthest))], 7.5, 8.5),
        Claim(ACCURACY, "takes almost nine times the triangles",
              bounded("10", "5", column=triangles) / bounded("20", "5", column=triangles), 8, 9),
        Claim(ACCURACY, "almost five times the time",
              bounded("10", "5", column=ms) / bounded("20", "5", column=ms), 4, 5),
        Claim(ACCURACY, "takes about 25 times as long as the grid",
              bounded("10", **hills, column=ms) / grid(**hills, column=ms), 21, 30),
        Claim(ACCURACY, "with noise about 100 times",
              bounded("10", "5", **hills, column=ms) / grid("5", **hills, column=ms), 85, 120),
        Claim(ACCURACY, "still has a quarter of the grid's triangles",
              bounded("10", **hills, column=triangles) / grid(**hills, column=triangles),
              0.22, 0.28),
        Claim(ACCURACY, "almost ten times as many as the scan has hit",
              bounded("10", **hills, column=triangles) / grid(**hills, column="hit triangles"),
              9, 10),
        Claim(ACCURACY, "1.7 times as far from the scene as the grid",
              bounded("10", **near) / grid(**near), 1.65, 1.75),
        Claim(ACCURACY, "misses less than half as much of the scene",
              bounded("10", **missing) / grid(**missing), 0.3, 0.5),
    ]
