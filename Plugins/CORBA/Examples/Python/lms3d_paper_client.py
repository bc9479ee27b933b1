#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Fetches a scan with the paper's interface and Python's standard library alone.

It reads the file that `lms3d-server --ior FILE` writes, and prints range (metres), alpha and beta
(degrees) of each beam, one beam per line. giop.py implements the part of CORBA that it needs.
"""

import argparse
import pathlib
import struct
import sys

import giop


def main():
    """Fetch and print a scan."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("ior", type=pathlib.Path, help="the file of lms3d-server --ior")
    parser.add_argument("--big-endian", action="store_true", help="send requests in this byte order")
    options = parser.parse_args()
    try:
        reference = options.ior.read_text().strip()
        with giop.Client(reference, order=">" if options.big_endian else "<") as scanner:
            triples = scanner.fetch()
    except (OSError, ValueError, LookupError, struct.error, giop.SystemException) as problem:
        sys.exit(f"{parser.prog}: {problem}")
    for i in range(0, len(triples), 3):
        print(*triples[i:i + 3], sep="\t")


if __name__ == "__main__":
    main()
