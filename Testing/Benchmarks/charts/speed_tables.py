# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The tables of Documentation/performance.md: times of scans, of building and of reading."""

from tables import BEAMS, find, name_scene, read, select, to_error, to_markdown, to_number, unique

NAME = "S-speed"
TITLE = "Tables S: speed and memory of a scan"
METHODS = ("raw packets", "Exact", "Fast")
QUIET = 3  # per cent that other processes may take; lms3dBenchmark has the same limit


def read_part(folder, part):
    """Return the rows of one CSV file, none if it does not exist."""
    path = folder / f"{NAME}-{part}.csv"
    return read(path) if path.exists() else []


def make_short_table(folder):
    """Return the README's table: scans of some scenes on one thread."""
    rows = select(read_part(folder, "scan"), threads="1")
    cells = []
    for scene, triangles in unique(rows, "scene", "triangles"):
        raw, exact, fast = (find(rows, scene=scene, method=method) for method in METHODS)
        cells.append([name_scene(scene), to_number(triangles), raw["scan ms"], exact["scan ms"],
                      exact["x raw"], fast["scan ms"], fast["x raw"]])
    return to_markdown(["scene", "triangles", "raw packets, ms", "Exact, ms", "x raw", "Fast, ms",
                        "x raw"], cells)


def _list_scans(rows):
    """Return a table with both numbers of threads in a row."""
    cells = []
    for scene, method, triangles in unique(rows, "scene", "method", "triangles"):
        one, two = (find(rows, scene=scene, method=method, threads=threads) for threads in "12")
        cells.append([f"{scene}, {to_number(triangles)}", method,
                      *(to_number(one[key]) for key in ("build ms", "B/triangle", "peak MB")),
                      *(row[key] for row in (one, two) for key in ("scan ms", "x raw")),
                      _count_wrong_beams(one), to_error(one["worst error"])])
    return to_markdown(["scene, triangles", "method", "build, ms", "B/triangle", "peak MB",
                        "1 thread, ms", "x raw", "2 threads, ms", "x raw", "wrong beams",
                        "worst error"], cells, words=2)


def _count_wrong_beams(row):
    return "-" if row["misses"] == "-" else int(row["misses"]) + int(row["false hits"])


def get_speed_up(rows, scene, method):
    """Return how many times as fast two threads are."""
    one, two = (find(rows, scene=scene, method=method, threads=threads) for threads in "12")
    return float(one["scan ms"]) / float(two["scan ms"])


def _list_speed_ups(rows):
    return to_markdown(["scene", *METHODS],
                       [[scene, *(f"{get_speed_up(rows, scene, method):.2f}" for method in METHODS)]
                        for scene, in unique(rows, "scene")])


def _list_memory(rows):
    cells = []
    for method in METHODS:
        held = [int(row["B/triangle"]) for row in select(rows, method=method)
                if row["B/triangle"] != "-"]
        if held:
            cells.append([f"a triangle, {method}", f"{min(held)} to {max(held)}"])
    for row in select(rows, method="Exact", threads="1"):
        if row["B/beam"] != "-":
            hits = int(row["hits"]) / BEAMS
            cells.append([f"a beam, {row['scene']} ({100 * hits:.0f} % of the beams return)",
                          row["B/beam"]])
    return to_markdown(["what", "bytes"], cells)


def _list_first_scans(rows):
    return to_markdown(
        ["scene", "work", "threads", "ms", "x boxes low", "x boxes medium"],
        [[row["scene"], row["work"], row["threads"], to_number(row["ms"], 3), row["x boxes low"],
          row["x boxes medium"]] for row in rows], words=2)


def _list_reading(rows):
    return to_markdown(
        ["scene", "what is read", "file, MB", "ms", "x numbers", "MB beside the output"],
        [[row["scene"], row["what is read"], row["file MB"], to_number(row["ms"], 3),
          row["x numbers"], row["MB beside the output"]] for row in rows], words=2)


def _list_kernels(rows):
    kernels = [name for name, in unique(rows, "kernels")]
    cells = []
    for scene, method in unique(rows, "scene", "method"):
        times = [find(rows, kernels=name, scene=scene, method=method, threads="1")
                 for name in kernels]
        cells.append([scene, method, *(row[key] for row in times for key in ("scan ms", "x raw"))])
    columns = [column for name in kernels for column in (f"{name}, ms", "x raw")]
    return to_markdown(["scene", "method", *columns], cells, words=2)


def _describe_others(rows):
    """Return a paragraph about other processes, nothing if the machine was quiet."""
    shares = [int(row["others %"]) for row in rows if row.get("others %", "-") != "-"]
    if max(shares, default=0) <= QUIET:
        return ""
    return (f"\n\nThe machine was not quiet: other processes took up to {max(shares)} % of the "
            "cores' time.")


# Headings, the part with the rows, and what makes a table of them.
SECTIONS = (
    ("A scan", "scenes", _list_scans),
    ("Two threads: times as fast as one", "scenes", _list_speed_ups),
    ("A scan, measured again (the README's table)", "scan", _list_scans),
    ("Methods for comparison", "methods", _list_scans),
    ("The first scan, building included", "first", _list_first_scans),
    ("Reading a scene", "read", _list_reading),
    ("Memory", "scenes", _list_memory),
    ("Instruction sets, 1 thread", "kernels", _list_kernels),
)


def make_sections(folder):
    """Yield headings and tables; a part that was not measured has none."""
    for heading, part, make in SECTIONS:
        rows = read_part(folder, part)
        if rows:
            yield heading, make(rows) + _describe_others(rows)
