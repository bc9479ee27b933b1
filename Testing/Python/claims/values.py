# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""A claim of a text, and the measured numbers that claims are about."""

import dataclasses
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "Testing" / "Benchmarks" / "charts"))
import summaries  # noqa: E402  (of a folder that is no package)
import tables  # noqa: E402

CHARTS = ROOT / "Documentation" / "charts"
ACCURACY = "Documentation/accuracy.md"
PERFORMANCE = "Documentation/performance.md"
GUIDE = "Documentation/guide.md"
README = "README.md"

TABLES = {path.stem: tables.read(path) for path in CHARTS.glob("*.csv")}
QUADRICS, PRO = "LMS3D grid + vtkQuadricDecimation", "LMS3D grid + vtkDecimatePro"


@dataclasses.dataclass(frozen=True)
class Claim:
    """A document's phrase, a measured number, and the least and the most that the phrase allows."""

    document: str
    phrase: str
    value: float
    least: float
    most: float


def make_spread(document, phrase, values, least, most):
    """Return two claims, about the least and the most of the values."""
    return [Claim(document, phrase, min(values), least, most),
            Claim(document, phrase, max(values), least, most)]


def get(table, column, **wanted):
    """Return a number of the only row with these cells."""
    return float(tables.find(TABLES[table], **wanted)[column])


def beam(caster, scene="room", column="ns/beam"):
    """Return a number of chart A."""
    return get("A-casting", column, caster=caster, scene=scene)


def local_map(name, bound, noise="0", scene="room", column="both mean mm"):
    """Return a number of chart B."""
    return get("B-mapping", column, map=name, bound_mm=bound, noise_mm=noise, scene=scene)


def bounded(bound, *arguments, **keywords):
    """Return a number of a bounded map."""
    return local_map("LMS3D map", bound, *arguments, **keywords)


def grid(*arguments, **keywords):
    """Return a number of the plain grid."""
    return local_map("LMS3D grid", "0", *arguments, **keywords)


def damaged(errors, column="x ideal"):
    """Return a number of the map of a scan with errors of a device, of chart B."""
    return get("B-mapping-damage", column, errors=errors)


def share(method, situation, parameter="ball", kinds=("missed", "false", "wrong")):
    """Return the share of a cell of chart C that fails."""
    row = tables.find(TABLES["C-stability"], method=method, situation=situation,
                      parameter=parameter)
    return summaries.get_share(row, kinds)


def missed_hits(method, situation, parameter):
    """Return the share of the hits of a cell of chart C that are missed."""
    return (share(method, situation, parameter, ("missed",))
            * get("C-stability", "beams", method=method, situation=situation, parameter=parameter)
            / get("C-stability", "hits", method=method, situation=situation, parameter=parameter))


def power(work, contender, against, kind="time"):
    """Return a fitted power of chart D."""
    return next(float(row[f"{kind} exponent"]) for row in TABLES["D-growth"]
                if (row["work"], row["contender"], row["against"]) == (work, contender, against)
                and row["end"] == "done")


def growth(work, contender, against, count, column):
    """Return a number of chart D."""
    return get("D-growth", column, work=work, contender=contender, against=against,
               **{against: count})


def sample(scene, step, bound, column="complete"):
    """Return a number of chart E."""
    return get("E-sampling", column, scene=scene, step_deg=step, bound_mm=bound)


def effect(name, column):
    """Return a number of the first row of chart F with this effect."""
    return float(tables.select(TABLES["F-device"], effect=name)[0][column])


def scan(scene, method, column="scan ms", threads="1", part="scenes"):
    """Return a number of tables S."""
    return get(f"S-speed-{part}", column, scene=scene, method=method, threads=threads)


def first(work, column, threads="1"):
    """Return a number of the first scan."""
    return get("S-speed-first", column, work=work, threads=threads)


def kernels(name, scene, method="Exact"):
    """Return the time of a method with an instruction set, on one thread."""
    return get("S-speed-kernels", "scan ms", kernels=name, scene=scene, method=method,
               threads="1")


def ratios(numerator, denominator, scenes):
    """Return the ratios over scenes."""
    return [numerator(scene) / denominator(scene) for scene in scenes]
