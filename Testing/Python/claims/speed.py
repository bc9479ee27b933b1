# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Tables S: scans, building and reading; and what performance.md and the README say of maps."""

from claims.values import (GUIDE, PERFORMANCE, QUADRICS, README, TABLES, Claim, bounded, first,
                           grid, kernels, local_map, make_spread, ratios, scan)

BEAMS = 361 * 360
README_SCENES = ("room", "castle", "teapot", "terrain1e6")
HILLS = tuple(f"terrain1e{power}" for power in range(3, 8))
SMALL = ("room", "castle", "teapot", "terrain1e3", "terrain1e4")
LARGE = ("ball", "terrain1e6", "terrain1e7")
SCENES = (*SMALL, "terrain1e5", *LARGE)
METHODS = ("Exact", "Fast")


def get_speed_ups(scenes, part="scenes"):
    """Return how many times as fast two threads are, by both methods."""
    return [scan(scene, method, part=part) / scan(scene, method, threads="2", part=part)
            for scene in scenes for method in METHODS]


def compare_runs(methods):
    """Return how many times as long the README's scans took in one run as in the other."""
    return [scan(scene, method, threads=threads, part="scan")
            / scan(scene, method, threads=threads)
            for scene in README_SCENES for method in methods for threads in "12"]


def make_scan_claims():
    """A scan, its threads and its errors."""
    small = [scan(scene, "Exact", "x raw") for scene in SMALL]
    small += [scan(scene, "Exact", "x raw", part="scan") for scene in ("room", "castle")]
    fast_errors = [scan(scene, "Fast", "worst error") for scene in SCENES]
    fast_errors += [scan(scene, "Fast", "worst error", part="scan") for scene in README_SCENES]
    exact_to_fast = [scan(scene, "Exact") / scan(scene, "Fast") for scene in (*SMALL, "terrain1e5")]
    long_scans = [scene for scene in SCENES if scan(scene, "Exact") > 1]
    return [
        *make_spread(PERFORMANCE, "`Exact` takes less time than raw packets in the room, in the "
                     "castle, at the teapot and on hills of up to 10,000 triangles",
                     small, 0.4, 0.95),
        Claim(PERFORMANCE, "On hills of 100,000 triangles it takes about a third longer",
              scan("terrain1e5", "Exact", "x raw"), 1.25, 1.42),
        *make_spread(PERFORMANCE, "in the ball and on larger hills about twice as long",
                     [scan(scene, "Exact", "x raw") for scene in LARGE], 1.85, 2.15),
        *make_spread(PERFORMANCE, "`Fast` takes less than twice the time of raw packets in every "
                     "scene", [scan(scene, "Fast", "x raw") for scene in SCENES], 0.5, 2),
        *make_spread(PERFORMANCE, "It is quicker than `Exact` in the ball and from 1,000,000 "
                     "triangles on",
                     [scan(scene, "Fast") / scan(scene, "Exact") for scene in LARGE], 0.5, 1),
        *make_spread(PERFORMANCE, "in the other scenes `Exact` takes less time", exact_to_fast,
                     0.3, 1),
        *make_spread(GUIDE, "slower than `Fast` (in smaller scenes faster)", exact_to_fast, 0.3, 1),
        *make_spread(PERFORMANCE, "`Fast` errs by less than 1e-14", fast_errors, 0, 1e-14),
        *make_spread(README, "`Fast` errs by less than 1e-14", fast_errors, 0, 1e-14),
        *make_spread(PERFORMANCE, "Two threads are about twice as fast as one",
                     get_speed_ups(long_scans), 1.87, 2.35),
        *make_spread(PERFORMANCE, "at the teapot 1.6 times", get_speed_ups(["teapot"]), 1.5, 1.7),
        *make_spread(README, "two threads take about half the time",
                     get_speed_ups(["room", "castle", "terrain1e6"], "scan"), 1.75, 2.35),
        *make_spread(PERFORMANCE, "a scan took up to a fifth longer", compare_runs(METHODS),
                     0.85, 1.2),
        *make_spread(PERFORMANCE, "raw packets less than a tenth", compare_runs(["raw packets"]),
                     0.9, 1.1),
        Claim(PERFORMANCE, "99 of 100 beams miss it",
              1 - scan("teapot", "Exact", "hits") / BEAMS, 0.985, 0.995),
        *make_spread(PERFORMANCE, "46 of 100 beams miss them",
                     [1 - scan(scene, "Exact", "hits") / BEAMS for scene in HILLS], 0.45, 0.48),
    ]


def make_method_claims():
    """The methods for comparison, in times of raw packets."""
    at_teapot = "at the teapot about 1,600, 64 and 14,200 times"
    return [Claim(PERFORMANCE, phrase, scan(scene, method, "x raw", part="methods"),
                  0.94 * times, 1.06 * times) for method, scene, times, phrase in (
        ("MollerTrumbore", "room", 170, "takes about 170 times as long as raw packets"),
        ("StaticCellLocator", "room", 500, "`StaticCellLocator` about 500 times"),
        ("AngleSum", "room", 1300, "`AngleSum` about 1,300 times"),
        ("MollerTrumbore", "teapot", 1600, at_teapot),
        ("StaticCellLocator", "teapot", 64, at_teapot),
        ("AngleSum", "teapot", 14200, at_teapot),
    )]


def make_claims():
    """Everything that is not about maps."""
    reading = [float(row["x numbers"]) for row in TABLES["S-speed-read"]
               if row["what is read"] == "vtkVRMLImporterSource"]
    updates = {method: [first(f"first update with {method}", "x boxes low", threads)
                        for threads in "12"] for method in METHODS}
    medium = [first(f"first update with {method}", "x boxes medium", threads)
              for method in METHODS for threads in "12"]
    held = {method: [scan(scene, method, "B/triangle") for scene in HILLS[1:]]
            for method in METHODS}
    scenes = ("room", "teapot", "terrain1e5")
    return make_scan_claims() + make_method_claims() + [
        *make_spread(PERFORMANCE, "with `Exact` takes less than a quarter longer than the "
                     "least", updates["Exact"], 1, 1.25),
        *make_spread(PERFORMANCE, "with `Fast` less than a fifth", updates["Fast"], 0.9, 1.2),
        *make_spread(PERFORMANCE, "Both take less than Embree's build at medium quality", medium,
                     0.3, 1),
        *make_spread(PERFORMANCE, "takes less than two and a half times that for one "
                     "IndexedFaceSet", reading, 1.3, 2.5),
        *make_spread(PERFORMANCE, "A triangle takes less than 60 bytes with `Exact`",
                     held["Exact"], 40, 60),
        *make_spread(PERFORMANCE, "less than 100 with `Fast`", held["Fast"], 60, 100),
        *make_spread(PERFORMANCE, "A beam takes about 65 bytes if all beams return",
                     [scan(scene, "Exact", "B/beam") for scene in ("room", "castle", "ball")],
                     63, 67),
        Claim(PERFORMANCE, "18 if one in a hundred does", scan("teapot", "Exact", "B/beam"),
              17, 19),
        Claim(PERFORMANCE, "`Exact` holds about 0.55 GB", held["Exact"][-1] / 100, 0.545, 0.555),
        Claim(PERFORMANCE, "`Fast` about 0.92 GB", held["Fast"][-1] / 100, 0.915, 0.925),
        Claim(PERFORMANCE, "up to 0.84 and 1.18 GB", scan("terrain1e7", "Exact", "peak MB") / 1000,
              0.83, 0.845),
        Claim(PERFORMANCE, "up to 0.84 and 1.18 GB", scan("terrain1e7", "Fast", "peak MB") / 1000,
              1.175, 1.185),
        *make_spread(PERFORMANCE, "AVX2 takes up to about three quarters less time than SSE2",
                     ratios(lambda scene: kernels("AVX2", scene),
                            lambda scene: kernels("Baseline", scene), scenes), 0.24, 1),
        *make_spread(PERFORMANCE, "AVX-512 up to a fifth less than AVX2",
                     ratios(lambda scene: kernels("AVX512", scene),
                            lambda scene: kernels("AVX2", scene),
                            (*scenes, "castle", "terrain1e6")), 0.78, 1),
        *(claim for name, phrase, most in (
            ("Baseline", "less than three quarters of the time of raw packets with SSE2", 0.75),
            ("AVX2", "less than three fifths with AVX2", 0.6))
          for claim in make_spread(
              PERFORMANCE, phrase,
              [kernels(name, scene) / kernels(name, scene, "raw packets")
               for scene in ("room", "castle", "teapot")], 0.35, most)),
    ]


def make_map_claims():
    """Maps, as performance.md and the README describe them."""
    scene, hills = {"column": "to scene mean mm"}, {"scene": "terrain1e5"}
    farthest = {name: [local_map(QUADRICS, "10", scene=name, column="farthest return mm"),
                       grid(scene=name, column="farthest return mm")]
                for name in ("room", "teapot")}
    claims = [Claim(PERFORMANCE, *claim) for claim in (
        ("is less than a fifth farther from the scene than the [plain grid]",
         bounded("10", **scene) / grid(**scene), 1, 1.2),
        ("the distance is twice as large",
         local_map(QUADRICS, "10", **scene) / bounded("10", **scene), 1.9, 2.2),
        ("returns are 0.7 m away", min(farthest["room"]) / 1000, 0.65, 0.75),
        ("returns are 0.7 m away", max(farthest["room"]) / 1000, 0.65, 0.75),
        ("within 20 mm is nearer to the scene than the grid",
         bounded("20", "5", **scene) / grid("5", **scene), 0, 1),
        ("the mean of both distances is a third of the grid's",
         bounded("10", **hills) / grid(**hills), 0.28, 0.39),
        ("as in the plain grid, returns are up to 7 cm away", min(farthest["teapot"]), 65, 75),
        ("as in the plain grid, returns are up to 7 cm away", max(farthest["teapot"]), 65, 75),
        ("takes about six times as long as with a bound of 0",
         bounded("5", "5", column="ms") / grid("5", column="ms"), 5, 7),
    )]
    return claims + [Claim(README, *claim) for claim in (
        ("half a per cent of the plain grid's triangles",
         bounded("10", column="triangles") / grid(column="triangles"), 0.004, 0.0055),
        ("its mean distance to the scene is less than a fifth larger",
         bounded("10", **scene) / grid(**scene), 1, 1.2),
        ("more than 300 times as long",
         local_map(QUADRICS, "10", column="ms") / bounded("10", column="ms"), 300, 500),
        ("the mean distance is twice as large",
         local_map(QUADRICS, "10", **scene) / bounded("10", **scene), 1.9, 2.2),
    )]
