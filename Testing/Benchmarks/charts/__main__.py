# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Measures and draws the charts of Documentation/accuracy.md, and renews the numbers of texts.

Call it as "./run chart". A chart is a module of this folder; it makes a table, .csv, and of that,
and of the words on the machine that measured, .txt, a picture, .png and .svg.
"""

import argparse
import pathlib
import subprocess
import sys
import tempfile
import time

import casting
import drawing
import growth
import mapping
import numbers_of_text
import sampling
import stability

# Each has LETTER, NAME, SUMMARY, measure(quick, csv_file), which writes the table, and
# draw(table, machine), which makes the picture of what the table holds.
CHARTS = {chart.LETTER: chart for chart in (casting, mapping, stability, growth, sampling)}


class ChartProblem(Exception):
    """Why a chart could not be made."""


def make(chart, options, folder):
    """Measure, then draw what was measured; the files are there when all of them are done."""
    start = time.monotonic()
    print(f"{chart.LETTER}: {chart.SUMMARY}", flush=True)
    name = f"{chart.LETTER}-{chart.NAME}"
    with tempfile.TemporaryDirectory(dir=folder, prefix=".unfinished-") as unfinished:
        path = pathlib.Path(unfinished) / name
        if not options.draw:
            _measure(chart, options.quick, path)
        _draw(chart, folder / name if options.draw else path, path)
        for file in sorted(pathlib.Path(unfinished).iterdir()):
            file.replace(folder / file.name)
    print(f"saved {folder / name}.* after {time.monotonic() - start:.0f} s", flush=True)


def _measure(chart, quick, path):
    try:
        chart.measure(quick, path.with_suffix(".csv"))
    except (OSError, subprocess.CalledProcessError) as problem:
        raise ChartProblem(f"it cannot be measured: {problem}") from problem
    path.with_suffix(".txt").write_text(drawing.name_machine() + "\n", encoding="utf-8")


def _draw(chart, source, path):
    try:
        table = drawing.read_table(source.with_suffix(".csv"))
        machine = source.with_suffix(".txt").read_text(encoding="utf-8").strip()
    except FileNotFoundError as problem:
        raise ChartProblem(f"there is no {problem.filename}; measure first") from problem
    drawing.save(chart.draw(table, machine), path)


def refresh_texts(folder):
    """Give the texts the numbers of the tables; returns what could not be renewed."""
    problems = []
    for name in numbers_of_text.TEXTS:
        path = drawing.ROOT / name
        text, missing = numbers_of_text.refresh(path.read_text(encoding="utf-8"), folder)
        problems += [f"{name} keeps a number: {problem}" for problem in missing]
        unfinished = path.with_name(f".unfinished-{path.name}")
        unfinished.write_text(text, encoding="utf-8")
        unfinished.replace(path)
    return problems


def main():
    """Read the command line, make the charts."""
    parser = argparse.ArgumentParser(
        prog="./run chart", formatter_class=argparse.RawDescriptionHelpFormatter,
        description="Measure and draw charts of accuracy.\n\n" + "\n".join(
            f"  {letter}  {chart.SUMMARY}" for letter, chart in CHARTS.items()))
    parser.add_argument("charts", nargs="*", metavar="CHART", help="which (default: all)")
    parser.add_argument("--draw", action="store_true",
                        help="draw anew what has been measured before")
    parser.add_argument("--quick", action="store_true",
                        help="measure less, for a first look; saved in build/charts")
    parser.add_argument("--output", metavar="FOLDER", type=pathlib.Path,
                        help="where to save (default: Documentation/charts)")
    options = parser.parse_args()
    unknown = [name for name in options.charts if name.upper() not in CHARTS]
    if unknown:
        parser.error(f"no chart {' '.join(unknown)}; there are {' '.join(CHARTS)}")

    place = "build" if options.quick else "Documentation"
    folder = options.output or drawing.ROOT / place / "charts"
    folder.mkdir(parents=True, exist_ok=True)
    problems = []
    for name in options.charts or CHARTS:
        try:
            make(CHARTS[name.upper()], options, folder)
        except ChartProblem as problem:
            problems.append(f"chart {name.upper()}: {problem}")
    if not options.quick and not options.output:
        problems += refresh_texts(folder)
    if problems:
        sys.exit("\n".join(f"./run chart: {problem}" for problem in problems))


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        sys.exit("./run chart: interrupted; the charts that were saved are whole")
