# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Keeps the numbers of a text those of the tables that they come from.

A number in Markdown is followed by a comment that names its cell:

    8.4 %<!-- C-stability: method=MollerTrumbore, situation=shared edges: missed / beams -->

the file, what its row has in some columns, and a column, or a sum of columns with "+", or that
divided by another. With a % after the number a share becomes a percentage. Decimals are as many as
the text has.
"""

import csv
import re

# Those with such numbers, in the repository.
TEXTS = ("Documentation/accuracy.md", "Documentation/performance.md", "README.md")

# The number, its unit, and the three parts of the comment.
_REFERENCE = re.compile(r"(?P<number>-?[\d,]*\.?\d+(?:e[-+]?\d+)?)(?P<unit> %| [A-Za-z]+)?"
                        r"(?P<comment><!-- (?P<file>[\w-]+): (?P<row>[^:]*): (?P<cell>[^:]*) -->)")


class NumberProblem(Exception):
    """A comment that names no cell."""


def refresh(text, folder):
    """The text with all numbers that name a cell as the tables in the folder have them.

    A number whose cell is missing or holds none stays; the list that is returned tells why.
    """
    tables, problems = {}, []

    def replace(match):
        try:
            if match["file"] not in tables:
                tables[match["file"]] = _read(folder / f"{match['file']}.csv")
            value = _value(_find(tables[match["file"]], match), match)
        except NumberProblem as problem:
            problems.append(str(problem))
            return match[0]
        percent = 100 if match["unit"] == " %" else 1
        return _like(match["number"], percent * value) + (match["unit"] or "") + match["comment"]
    return _REFERENCE.sub(replace, text), problems


def references(text):
    """The names of the tables, once for each number that comes from one of them."""
    return [match["file"] for match in _REFERENCE.finditer(text)]


def without_references(text):
    """The text without the numbers that name a cell."""
    return _REFERENCE.sub("", text)


def _read(path):
    try:
        with open(path, newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))
    except FileNotFoundError as problem:
        raise NumberProblem(f"there is no table {path.name}") from problem


def _find(table, match):
    wanted = dict(part.strip().split("=", 1) for part in match["row"].split(","))
    try:
        rows = [row for row in table if all(row[key] == value for key, value in wanted.items())]
    except KeyError as problem:
        raise NumberProblem(f"no column {problem} in {match['comment']}") from problem
    if len(rows) != 1:
        raise NumberProblem(f"{len(rows)} rows for {match['comment']}")
    return rows[0]


def _value(row, match):
    """The value of a column, of "a + b" or of "a + b / c"."""
    terms, _, divisor = match["cell"].partition(" / ")
    try:
        value = sum(float(row[term]) for term in terms.split(" + "))
        return value / float(row[divisor]) if divisor else value
    except (KeyError, ValueError, ZeroDivisionError) as problem:
        raise NumberProblem(f"no number for {match['comment']}: {problem}") from problem


def _like(number, value):
    """The value with as many decimals and as many separators as a number has."""
    if "e" in number:
        mantissa = number.split("e")[0]
        return f"{value:.{len(mantissa.partition('.')[2])}e}"
    return f"{value:,.{len(number.partition('.')[2])}f}"
