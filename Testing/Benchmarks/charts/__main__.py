# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Measures the charts of Documentation/accuracy.md and the tables of Documentation/performance.md.

Call it as "./run chart". A chart is a module of this folder. It measures a .csv file; a .txt file
names the machine. A picture, .png, and a page of short tables, .md, are made from these two.
"""

import argparse
import pathlib
import subprocess
import sys
import tempfile
import time

import casting
import device
import drawing
import fusion
import growth
import mapping
import sampling
import speed
import stability
import summaries
import tables
from places import CHART_FOLDER, ROOT

# Each has LETTER, NAME, SUMMARY, measure(quick, csv_file), which writes the table, and
# draw(table, machine), which makes the picture of the table, or None.
CHARTS = {chart.LETTER: chart for chart in (casting, mapping, stability, growth, sampling, device,
                                          fusion, speed)}


class ChartProblem(Exception):
    """Why a chart could not be made."""


def make(chart, options, folder):
    """Measure, then draw what was measured; the files appear when all of them are done."""
    start = time.monotonic()
    print(f"{chart.LETTER}: {chart.SUMMARY}", flush=True)
    name = f"{chart.LETTER}-{chart.NAME}"
    with tempfile.TemporaryDirectory(dir=folder, prefix=".unfinished-") as unfinished:
        unfinished = pathlib.Path(unfinished)
        if not options.draw:
            _measure(chart, options.quick, unfinished / name)
        _present(chart, folder if options.draw else unfinished, unfinished)
        for file in sorted(unfinished.iterdir()):
            file.replace(folder / file.name)
    print(f"saved {folder / name}* after {time.monotonic() - start:.0f} s", flush=True)


def _measure(chart, quick, path):
    try:
        chart.measure(quick, path.with_suffix(".csv"))
    except (OSError, subprocess.CalledProcessError) as problem:
        raise ChartProblem(f"it cannot be measured: {problem}") from problem
    path.with_suffix(".txt").write_text(drawing.name_machine() + "\n", encoding="utf-8")


def _present(chart, source, target):
    """Draw the picture and write the tables of what lies in the source folder."""
    name = f"{chart.LETTER}-{chart.NAME}"
    try:
        page = summaries.make_page(source, name)
        if chart.draw:
            machine = (source / f"{name}.txt").read_text(encoding="utf-8").strip()
            drawing.save(chart.draw(tables.read(source / f"{name}.csv"), machine), target / name)
    except FileNotFoundError as problem:
        raise ChartProblem(f"there is no {problem.filename}; measure first") from problem
    (target / f"{name}.md").write_text(page, encoding="utf-8")


def renew_readme():
    """Write the README's table anew."""
    path = ROOT / "README.md"
    text = summaries.insert_table(path.read_text(encoding="utf-8"), CHART_FOLDER)
    unfinished = path.with_name(f".unfinished-{path.name}")
    unfinished.write_text(text, encoding="utf-8")
    unfinished.replace(path)


def main():
    """Read the command line, make the charts."""
    parser = argparse.ArgumentParser(
        prog="./run chart", formatter_class=argparse.RawDescriptionHelpFormatter,
        description="Measure and draw charts, and write their tables.\n\n" + "\n".join(
            f"  {letter}  {chart.SUMMARY}" for letter, chart in CHARTS.items()))
    parser.add_argument("charts", nargs="*", metavar="CHART", help="which (default: all)")
    parser.add_argument("--draw", action="store_true",
                        help="draw pictures and write tables of what has been measured")
    parser.add_argument("--quick", action="store_true",
                        help="measure less, for a first look; saves in build/charts")
    parser.add_argument("--output", metavar="FOLDER", type=pathlib.Path,
                        help="where to save (default: Documentation/charts)")
    options = parser.parse_args()
    unknown = [name for name in options.charts if name.upper() not in CHARTS]
    if unknown:
        parser.error(f"no chart {' '.join(unknown)}; there are {' '.join(CHARTS)}")

    folder = options.output or (ROOT / "build" / "charts" if options.quick else CHART_FOLDER)
    folder.mkdir(parents=True, exist_ok=True)
    problems = []
    for name in options.charts or CHARTS:
        try:
            make(CHARTS[name.upper()], options, folder)
        except ChartProblem as problem:
            problems.append(f"chart {name.upper()}: {problem}")
    if folder == CHART_FOLDER and not problems:
        renew_readme()
    if problems:
        sys.exit("\n".join(f"./run chart: {problem}" for problem in problems))


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        sys.exit("./run chart: interrupted; the charts that were saved are whole")
