# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The generated texts: a page of short tables for each chart, and the table of the README.

Everything here depends on the CSV files alone, so that the same files give the same bytes.
"""

import damage_tables
import fusion_tables
import speed_tables
from places import HERE
from tables import (BEAMS, find, name_scene, read, select, to_error, to_markdown, to_number,
                    to_percent, unique)

BEGIN, END = "<!-- table: begin (./run chart S writes it) -->", "<!-- table: end -->"


def _pivot(rows, row_keys, column_key, get_cell):
    """Return the cells of a table with a row for each row_keys, a column for each column_key."""
    columns = [column for column, in unique(rows, column_key)]
    cells = {(tuple(row[key] for key in row_keys), row[column_key]): get_cell(row) for row in rows}
    return columns, [[*names, *(cells.get((names, column), "-") for column in columns)]
                     for names in unique(rows, *row_keys)]


# --- Chart A --------------------------------------------------------------------------------------

def _format_time(row):
    if row["end"] != "done":
        return row["end"]
    # Casters that take long have fewer beams.
    beams = int(row["beams timed"])
    part = "" if beams == BEAMS else f" ({beams:,} beams)"
    return to_number(row["ns/beam"]) + part


def _make_casting_tables(table):
    rows = [{**row, "scene": name_scene(row["scene"])} for row in table]
    for heading, get_cell in (
            ("Time of a beam, ns", _format_time),
            ("Worst relative error of the range", lambda row: to_error(row["worst error"]))):
        scenes, cells = _pivot(rows, ["caster"], "scene", get_cell)
        yield heading, to_markdown(["caster", *scenes], cells)
    failing = [row for row in rows if row["end"] == "done"
               and int(row["misses"]) + int(row["false hits"])]
    yield "Beams that fail (no other caster has any)", to_markdown(
        ["caster", "scene", "missed", "invented", "of"],
        [[row["caster"], row["scene"], row["misses"], row["false hits"],
          to_number(row["beams compared"])] for row in failing], words=2)


# --- Chart B --------------------------------------------------------------------------------------

MAP_COLUMNS = {"ms": "ms", "triangles": "triangles", "to scene mean mm": "map to scene, mm",
               "to map mean mm": "scene to map, mm", "both mean mm": "mean of both, mm",
               "farthest return mm": "farthest return, mm"}


def _is_summarized(row):
    """Whether a rival has as many triangles as the map within 10 mm, with noise 20 mm."""
    bound = "10" if row["noise mm"] == "0" else "20"
    return "Decimat" not in row["map"] or row["bound mm"] == bound


def _make_mapping_tables(table):
    for scene, noise in unique(table, "scene", "noise mm"):
        rows = [row for row in select(table, scene=scene, noise_mm=noise) if _is_summarized(row)]
        words = "ideal ranges" if noise == "0" else f"{noise} mm of noise"
        yield f"{name_scene(scene).capitalize()}, {words}", to_markdown(
            ["map", "bound, mm", *MAP_COLUMNS.values()],
            [[row["map"], "-" if row["bound mm"] == "0" else row["bound mm"],
              *(to_number(row[key]) for key in MAP_COLUMNS)] for row in rows])
    scenes = [find(table, scene=scene, map="LMS3D map", noise_mm="0", bound_mm="10")
              for scene, in unique(table, "scene")]
    yield "Triangles of the scenes", to_markdown(
        ["scene", "all", "hit by the scan", "map within 10 mm"],
        [[name_scene(row["scene"]), *(to_number(row[key]) for key in (
            "scene triangles", "hit triangles", "triangles"))] for row in scenes])


# --- Chart C --------------------------------------------------------------------------------------

FAILURES = ("missed", "false", "wrong")
# Heading, ways to fail, how the methods' names begin, and the situations; without them all.
METHODS = (
    ("Methods of LMS3D: failing beams, %", FAILURES,
     ("Exact", "Fast", "AngleSum", "MollerTrumbore", "StaticCellLocator"), ()),
    ("The paper's sum of angles: missed beams, %", ("missed",), ("sum",),
     ("generic beams", "shared edges", "shared vertices", "within an edge")),
    ("The paper's sum of angles: invented beams, %", ("false",), ("sum",), ("beside an edge",)),
    ("Embree in single precision: failing beams, %", FAILURES, ("Embree",),
     ("shared edges", "shared vertices", "tiny component", "offset")),
    ("VTK's locators: failing beams, %", FAILURES, ("vtk",),
     ("shared edges", "nested shells", "on a surface")),
)


def get_share(row, kinds=FAILURES):
    """Return the share of a cell's beams that fail in one of these ways."""
    return sum(int(row[kind]) for kind in kinds) / int(row["beams"])


def _make_stability_tables(table):
    for heading, kinds, starts, situations in METHODS:
        rows = [row for row in table if row["method"].startswith(starts)
                and (not situations or row["situation"] in situations)]
        failing = {(row["situation"], row["parameter"]) for row in rows
                   if row["end"] != "done" or get_share(row, kinds) > 0}
        rows = [row for row in rows if (row["situation"], row["parameter"]) in failing]
        methods, cells = _pivot(
            rows, ["situation", "parameter"], "method",
            lambda row, kinds=kinds: (to_percent(get_share(row, kinds)) if row["end"] == "done"
                                      else "×"))
        yield heading, to_markdown(["situation", "parameter", *methods], cells, words=2)


# --- Chart D --------------------------------------------------------------------------------------

GROWING = ("Exact", "Fast", "plain grid", "map within 10 mm")


def _make_growth_tables(table):
    done = select(table, end="done")
    for kind in ("time", "memory"):
        columns, cells = _pivot(done, ["work", "contender"], "against",
                                lambda row, kind=kind: row[f"{kind} exponent"])
        yield f"The power with which {kind} grows", to_markdown(
            ["work", "by", *(f"against {column}" for column in columns)], cells, words=2)
    largest = {row["contender"]: row for row in select(done, work="build", against="triangles")}
    yield "Building", to_markdown(
        ["by", "triangles", "ms", "held MB", "peak MB"],
        [[name, *(to_number(row[key]) for key in ("triangles", "ms", "held MB", "peak MB"))]
         for name, row in largest.items()])
    maps = select(done, work="map", against="triangles")
    yield ("Time of a map against the triangles of the hills, ms",
           _pivot_growth(maps, "triangles", "ms"))
    rows = [row for row in select(done, against="beams") if row["contender"] in GROWING]
    yield "Time against the beams of the room, ms", _pivot_growth(rows, "beams", "ms")
    yield "Most memory against the beams of the room, MB", _pivot_growth(rows, "beams", "peak MB")


def _pivot_growth(rows, against, column):
    names, cells = _pivot(rows, [against], "contender", lambda row: to_number(row[column]))
    return to_markdown([against, *names], [[to_number(row[0]), *row[1:]] for row in cells], words=0)


# --- Chart E --------------------------------------------------------------------------------------

SAMPLING = (
    ("share of the visible scene that the map has, %",
     lambda row: f"{100 * float(row['complete']):.1f}"),
    ("triangles of the map", lambda row: to_number(row["triangles"])),
    ("distance of the map from the scene, 95 % of its area, mm",
     lambda row: to_number(row["map to scene 95% mm"])),
)


def _make_sampling_tables(table):
    for scene, tolerance in unique(table, "scene", "tolerance mm"):
        for heading, get_cell in SAMPLING:
            bounds, cells = _pivot(select(table, scene=scene), ["step deg"], "bound mm", get_cell)
            names = ["plain grid" if bound == "0" else f"within {bound} mm" for bound in bounds]
            yield (f"{scene.capitalize()}, tolerance {tolerance} mm: {heading}",
                   to_markdown(["step, degrees", *names], cells))


# --- Chart F --------------------------------------------------------------------------------------

DEVICE_RANGES = ("changed %", "median mm", "95% mm", "max mm", "lost %")
DEVICE_MAPS = ("triangles", "map to scene mean mm", "map to scene 95% mm", "scene to map mean mm",
               "complete %", "free space m2")


def _make_device_tables(table):
    for heading, columns in (("Ranges against the ideal ones", DEVICE_RANGES),
                             ("The map against the scene", DEVICE_MAPS),
                             ("Time of a scan", ("ms", "x ideal"))):
        yield heading, to_markdown(
            ["effect", "value", *columns],
            [[row["effect"], row["value"], *(to_number(row[key]) for key in columns)]
             for row in table], words=2)


# --- Chart G --------------------------------------------------------------------------------------

FUSION_TIMES = ("scan ms", "map ms", "fusion ms", "slowest fusion ms")
FUSION_SIZES = ("triangles", "triangles of all maps", "triangles of the visible scene", "x visible scene",
                "complete %", "all maps complete %", "changed kB", "whole kB")


def _make_fusion_tables(table):
    for threads, in unique(table, "threads"):
        rows = select(table, threads=threads)
        yield f"Time for each pose, {threads} thread{'s' * (threads != '1')}", to_markdown(
            ["poses", *FUSION_TIMES],
            [[row["poses"], *(to_number(row[key]) for key in FUSION_TIMES)] for row in rows], words=0)
    yield "The map", to_markdown(
        ["poses", *FUSION_SIZES],
        [[row["poses"], *(to_number(row[key], 4) for key in FUSION_SIZES)]
         for row in select(table, threads="1")], words=0)


# --- Pages ----------------------------------------------------------------------------------------

PAGES = {
    "A-casting": ("Chart A: what a beam costs", _make_casting_tables),
    "B-mapping": ("Chart B: what a map costs", _make_mapping_tables),
    "C-stability": ("Chart C: where methods fail", _make_stability_tables),
    "D-growth": ("Chart D: how time and memory grow", _make_growth_tables),
    "E-sampling": ("Chart E: how fine a scan has to be", _make_sampling_tables),
    "F-device": ("Chart F: what a real device does", _make_device_tables),
    "G-fusion": ("Chart G: how one map of many scans grows", _make_fusion_tables),
}


def _make_sections(folder, name):
    if name == speed_tables.NAME:
        return speed_tables.make_sections(folder)
    sections = [*PAGES[name][1](read(folder / f"{name}.csv"))]
    if name == damage_tables.NAME:
        sections += damage_tables.make_sections(folder)
    if name == fusion_tables.NAME:
        sections += fusion_tables.make_sections(folder)
    return sections


def make_page(folder, name):
    """Return the Markdown page of a chart's CSV files."""
    title = PAGES[name][0] if name in PAGES else speed_tables.TITLE
    machine = (folder / f"{name}.txt").read_text(encoding="utf-8").strip()
    sources = sorted(path.name for path in folder.glob(f"{name}*.csv"))
    links = ", ".join(f"[{source}]({source})" for source in sources)
    parts = [f"# {title}", f"`./run chart` makes this page from {links}; numbers are rounded.",
             f"Machine and versions: {machine}."]
    for heading, table in _make_sections(folder, name):
        parts += [f"## {heading}", table]
    parts += ["## How it was measured", (HERE / "notes" / f"{name}.md").read_text("utf-8").strip()]
    return "\n\n".join(parts) + "\n"


def insert_table(text, folder):
    """Return the README with its table made anew."""
    head, _, rest = text.partition(BEGIN)
    _, _, tail = rest.partition(END)
    if not tail:
        raise ValueError(f"the README lacks {BEGIN} and {END}")
    return f"{head}{BEGIN}\n\n{speed_tables.make_short_table(folder)}\n\n{END}{tail}"
