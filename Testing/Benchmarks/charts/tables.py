# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reads and writes CSV tables, and makes Markdown tables of their rows."""

import csv
import math

BEAMS = 361 * 360  # of the default scan


def read(path):
    """Return the rows of a CSV file as dictionaries."""
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def write(path, rows):
    """Write dictionaries with the same keys as a CSV file."""
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, rows[0], lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def unique(rows, *keys):
    """Return the tuples of cells that occur, in the order of the rows."""
    return list(dict.fromkeys(tuple(row[key] for key in keys) for row in rows))


def select(rows, **wanted):
    """Return the rows with these cells; "_" in a keyword stands for a blank."""
    wanted = {key.replace("_", " "): value for key, value in wanted.items()}
    return [row for row in rows if all(row[key] == value for key, value in wanted.items())]


def find(rows, **wanted):
    """Return the only row with these cells, None if there is none."""
    found = select(rows, **wanted)
    if len(found) > 1:
        raise ValueError(f"{len(found)} rows with {wanted}")
    return found[0] if found else None


def name_scene(scene):
    """Return what texts call a scene of the benchmarks."""
    return "hills" if scene.startswith("terrain") else scene


def to_number(cell, digits=2):
    """Return a number rounded to some digits, integers whole; return words as they are."""
    try:
        value = float(cell)
    except ValueError:
        return cell
    if 0 < abs(value) < 0.001:
        return "< 0.001"
    present = len(str(cell).partition(".")[2])
    if value == 0 or present == 0:
        return f"{value:,.0f}"
    rounded = float(f"{value:.{digits - 1}e}")
    wanted = digits - 1 - math.floor(math.log10(abs(rounded)))
    return f"{value:,.{min(present, max(0, wanted))}f}"


def to_error(cell):
    """Return a relative error, 0 for one that is exactly 0."""
    return "0" if cell == "0.0e+00" else cell


def to_percent(share):
    """Return a share as a percentage; what is not 0 or 100 does not look like it."""
    if 0 < share < 0.001:
        return "< 0.1"
    is_fine = 0 < share < 0.0995 or 0.995 <= share < 1
    return f"{100 * share:.{1 if is_fine else 0}f}"


def to_markdown(columns, rows, words=1):
    """Return a Markdown table; the first columns hold words, the others numbers."""
    rule = ["---"] * words + ["--:"] * (len(columns) - words)
    return "\n".join("| " + " | ".join(str(cell) for cell in row) + " |"
                     for row in (columns, rule, *rows))
