# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Measures and draws the charts of Documentation/accuracy.md, and renews its numbers.

Call it as "./run chart". A chart is a module of this folder; it makes a table, .csv, and of
that a picture, .png and .svg.
"""

import argparse
import pathlib
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

ROOT = pathlib.Path(__file__).resolve().parents[3]
# Each has LETTER, NAME, SUMMARY, measure(quick, csv_file), which writes the table, and
# draw(table), which makes the picture of what the table holds.
CHARTS = {chart.LETTER: chart for chart in (casting, mapping, stability, growth, sampling)}


def make(chart, quick, folder):
    """Measure, then draw what was measured; the files are there when all of them are done."""
    start = time.monotonic()
    print(f"{chart.LETTER}: {chart.SUMMARY}", flush=True)
    name = f"{chart.LETTER}-{chart.NAME}"
    with tempfile.TemporaryDirectory(dir=folder, prefix=".unfinished-") as unfinished:
        path = pathlib.Path(unfinished) / name
        chart.measure(quick, path.with_suffix(".csv"))
        figure = chart.draw(drawing.read_table(path.with_suffix(".csv")))
        drawing.save(figure, path)
        for file in sorted(pathlib.Path(unfinished).iterdir()):
            file.replace(folder / file.name)
    print(f"saved {folder / name}.csv, .png and .svg after {time.monotonic() - start:.0f} s",
          flush=True)


def refresh_text(folder):
    """Give the text on the charts the numbers of the new tables."""
    path = ROOT / "Documentation" / "accuracy.md"
    text = numbers_of_text.refresh(path.read_text(encoding="utf-8"), folder)
    unfinished = path.with_name(".unfinished-accuracy.md")
    unfinished.write_text(text, encoding="utf-8")
    unfinished.replace(path)


def main():
    """Read the command line, make the charts."""
    parser = argparse.ArgumentParser(
        prog="./run chart", formatter_class=argparse.RawDescriptionHelpFormatter,
        description="Measure and draw charts of accuracy.\n\n" + "\n".join(
            f"  {letter}  {chart.SUMMARY}" for letter, chart in CHARTS.items()))
    parser.add_argument("charts", nargs="*", metavar="CHART", help="which (default: all)")
    parser.add_argument("--quick", action="store_true",
                        help="measure less, for a first look; saved in build/charts")
    parser.add_argument("--output", metavar="FOLDER", type=pathlib.Path,
                        help="where to save (default: Documentation/charts)")
    options = parser.parse_args()
    unknown = [name for name in options.charts if name.upper() not in CHARTS]
    if unknown:
        parser.error(f"no chart {' '.join(unknown)}; there are {' '.join(CHARTS)}")

    folder = options.output or ROOT / ("build" if options.quick else "Documentation") / "charts"
    folder.mkdir(parents=True, exist_ok=True)
    for name in options.charts or CHARTS:
        make(CHARTS[name.upper()], options.quick, folder)
        if not options.quick and not options.output:
            refresh_text(folder)


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        sys.exit("./run chart: interrupted; the charts that were saved are whole")
