# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Charts A and C: what a beam costs, and where methods fail."""

from claims.values import ACCURACY, Claim, beam, make_spread, missed_hits, ratios, share

SCENES = ("room", "teapot", "terrain1e5")


def make_claims():
    """Chart A."""
    room = beam("Exact")
    worst = [beam("Fast", scene, "worst error") for scene in SCENES]
    packets = ratios(lambda scene: beam("Embree robust packets", scene),
                     lambda scene: beam("Exact", scene), ("room", "terrain1e5"))
    packet_errors = [beam("Embree robust packets", scene, "worst error") for scene in SCENES]
    return [
        Claim(ACCURACY, "a tenth longer than `Exact`",
              beam("Fast", "terrain1e5") / beam("Exact", "terrain1e5"), 1.05, 1.15),
        Claim(ACCURACY, "in the room more than twice as long", beam("Fast") / room, 2, 3),
        *make_spread(ACCURACY, "errs by less than 1e-14 of the range", worst, 0, 1e-14),
        Claim(ACCURACY, "In the room they take almost twice as long as `Exact`", packets[0],
              1.75, 2),
        Claim(ACCURACY, "At the teapot `Exact` is quicker, too",
              beam("Exact", "teapot") / beam("Embree robust packets", "teapot"), 0.5, 0.95),
        *make_spread(ACCURACY, "err by some millionths", packet_errors, 0.5e-6, 5e-6),
        *make_spread(ACCURACY, "take more than seven times as long as `Exact` in the room",
                     [beam(name) / room for name in ("Embree rays", "Embree robust rays")],
                     7, 9),
        Claim(ACCURACY, "which casts such rays, nine times", beam("Open3D") / room, 8.5, 9.5),
        *make_spread(ACCURACY, "takes about 860 times as long as `Exact` in the room",
                     [beam(name) / room for name in ("vtkStaticCellLocator", "StaticCellLocator")],
                     820, 900),
        Claim(ACCURACY, "without a tolerance it misses one beam in a thousand",
              beam("vtkStaticCellLocator at 0", column="misses")
              / beam("vtkStaticCellLocator at 0", column="beams compared"), 0.0008, 0.0015),
        Claim(ACCURACY, "in the room their errors are up to 85 % and 12 % of the range",
              beam("vtkCellLocator", column="worst error"), 0.845, 0.855),
        Claim(ACCURACY, "in the room their errors are up to 85 % and 12 % of the range",
              beam("vtkCellTreeLocator", column="worst error"), 0.115, 0.125),
        Claim(ACCURACY, "on the hills `vtkCellLocator` errs by up to 260 %",
              beam("vtkCellLocator", "terrain1e5", "worst error"), 2.55, 2.65),
        Claim(ACCURACY, "On the hills `Exact` takes a third longer than Embree's packets",
              1 / packets[1], 1.25, 1.4),
        Claim(ACCURACY, "errs a quarter as much", beam("trimesh", column="worst error")
              / beam("Fast", column="worst error"), 0.2, 0.3),
        Claim(ACCURACY, "takes about 15 times as long", beam("trimesh") / beam("Fast"), 14, 16),
        Claim(ACCURACY, "takes more than 2,000 times as long as `Exact` in the room",
              beam("AngleSum") / room, 2000, 2600),
        Claim(ACCURACY, "more than 20,000 times at the teapot",
              beam("AngleSum", "teapot") / beam("Exact", "teapot"), 20000, 25000),
        Claim(ACCURACY, "`MollerTrumbore` about 260 and", beam("MollerTrumbore") / room,
              245, 275),
        Claim(ACCURACY, "about 2,700 times", beam("MollerTrumbore", "teapot")
              / beam("Exact", "teapot"), 2550, 2850),
    ]

def make_failure_claims():
    """Chart C."""
    missed, invented, wrong = ("missed",), ("false",), ("wrong",)
    exact = [share("Exact", "denormals", parameter) for parameter in ("1e-120", "1e-310")]
    faces = [share(name, "on a surface", "face") for name in (
        "vtkStaticCellLocator", "vtkStaticCellLocator at 0", "vtkCellLocator",
        "vtkCellTreeLocator", "vtkModifiedBSPTree", "vtkOBBTree")]
    far = [share(name, "far targets", "1e9", invented)
           for name in ("AngleSum", "MollerTrumbore", "StaticCellLocator")]
    small = [share(f"sum within {tolerance}", "shared edges", kinds=missed)
             for tolerance in ("1e-12", "1e-9")]
    corners = [share(f"sum within {tolerance}", "shared vertices", kinds=missed)
               for tolerance in ("1e-12", "1e-9", "1e-3")]
    return [Claim(ACCURACY, *claim) for claim in (
        ("every beam is missed", min(exact), 1, 1),
        ("At 1e-100 m it misses none", share("Exact", "denormals", "1e-100"), 0, 0),
        ("fails for 96 % of the beams at an offset of a kilometre",
         share("Embree robust rays", "offset", "1e3"), 0.955, 0.965),
        ("at a range of 0, for almost all beams", min(faces), 0.95, 1),
        ("for about nine beams in ten", share("vtkCellLocator", "nested shells", "1e-2"),
         0.88, 0.95),
        ("loses about one beam in twelve at shared edges",
         share("MollerTrumbore", "shared edges"), 1 / 13, 1 / 11),
        ("Embree's plain mode one in 26", share("Embree rays", "shared edges"), 1 / 27, 1 / 25),
        ("its robust mode none", share("Embree robust rays", "shared edges"), 0, 0),
        ("lose about six beams in ten",
         share("Embree robust packets", "tiny component", "-1e-33"), 0.55, 0.65),
        ("at 1e-120 m all hits are missed", missed_hits("Exact", "denormals", "1e-120"), 1, 1),
        ("about four fifths of the beams that pass it are false",
         share("Fast", "beside an edge", "1e-8", invented), 0.75, 0.85),
        ("about 15 % of those inside are missed",
         share("Fast", "within an edge", "-1e-8", missed), 0.14, 0.16),
        ("about a tenth on a common grid", share("Fast", "common grid", "blocks"), 0.09, 0.11),
        ("about 3 % at a grazing angle of 1e-6", share("Fast", "grazing angle", "1e-6"),
         0.025, 0.035),
        ("At nested shells less than one beam in a thousand",
         share("Fast", "nested shells", "1e-2", wrong), 1e-6, 0.001),
        ("From a face it misses every hit", missed_hits("Fast", "on a surface", "face"), 1, 1),
        ("all beams at 1e-8", share("AngleSum", "beside an edge", "1e-8", invented), 1, 1),
        ("From 1e9 radii away the last three invent less than one beam in a thousand",
         max(far), 1e-6, 0.001),
        ("From 1e9 radii away the last three invent", min(far), 1e-6, 0.001),
        ("loses about 8 % of the beams at edges", share("MollerTrumbore", "shared edges"),
         0.075, 0.085),
        ("6 % at corners", share("MollerTrumbore", "shared vertices"), 0.055, 0.065),
        ("invents all beams at 1e-10 m beside a triangle",
         share("StaticCellLocator", "beside an edge", "1e-10", invented), 1, 1),
        ("almost half of them in scenes of 1e-30 m",
         share("StaticCellLocator", "denormals", "1e-30"), 0.4, 0.5),
        ("about 2 % of a ball that large", share("StaticCellLocator", "scale", "1e7"),
         0.015, 0.025),
        ("less than 1 % at that offset", share("StaticCellLocator", "offset", "1e7"), 1e-6, 0.01),
        ("fails for about one beam in a thousand",
         share("StaticCellLocator", "common grid", "blocks"), 0.0005, 0.0015),
        ("about a third of generic beams are lost",
         share("sum = 2 pi", "generic beams", kinds=missed), 0.3, 0.36),
        ("about two thirds at edges", share("sum = 2 pi", "shared edges", kinds=missed),
         0.63, 0.7),
        ("repairs the first", share("sum within 1e-12", "generic beams", kinds=missed), 0, 0),
        ("about one beam in eight is lost at edges", min(small), 1 / 9, 1 / 7),
        ("about one beam in eight is lost at edges", max(small), 1 / 9, 1 / 7),
        ("almost all are lost with 1e-12",
         share("sum within 1e-12", "within an edge", "-1e-6", missed), 0.95, 1),
        ("about 70 % are lost with 1e-9",
         share("sum within 1e-9", "within an edge", "-1e-8", missed), 0.68, 0.73),
        ("within 1e-3 about 70 % of the beams",
         share("sum within 1e-3", "beside an edge", "1e-4", invented), 0.68, 0.72),
        ("and all that pass by 1e-6",
         share("sum within 1e-3", "beside an edge", "1e-6", invented), 1, 1),
        ("with each about 45 % are lost", min(corners), 0.44, 0.46),
        ("with each about 45 % are lost", max(corners), 0.44, 0.46),
        ("It loses no beam at edges or corners", share("AngleSum", "shared edges"), 0, 0),
        ("It loses no beam at edges or corners", share("AngleSum", "shared vertices"), 0, 0),
    )]
