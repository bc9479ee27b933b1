#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Find phrases and names that the project's texts and sources avoid.

    python3 Testing/Style/check_words.py [FILE...]

Checks the given files, or all tracked texts and sources. Prints file and line of each finding, and
exits with code 1 if there is one. A phrase may continue on the next line.
"""

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PHRASES = ("but for", "be it", "lest", "of which", "whatever", "those of", "that is none",
           "so many", "told", "nobody", "the words on")
PREFIXES = ("Most", "Least", "Fewest", "Longest")

_ENDINGS = (".md", ".h", ".cxx", ".inl", ".py", ".idl", ".xml", ".cmake", ".in", ".java",
            "CMakeLists.txt", ".ci/run")
_SKIPPED = re.compile(r"Testing/Data/|Baselines?/|LICENSE$|Testing/Style/check_words\.py$",
                      re.IGNORECASE)

# Between two words: blanks, or the end of a line and the start of the next comment line.
_GAP = r"[ \t]*(?:\n[ \t]*(?:///?|#|\*)?[ \t]*| )"


def _phrase(words):
    """A pattern that finds a phrase, also capitalized and as a part of a CamelCase name."""
    first, *others = words.split()
    capital = first.capitalize()
    start = rf"(?:(?<![A-Za-z]){first}|(?<![A-Z]){capital})"
    return _GAP.join([start, *others]) + r"(?![a-z])"


_PATTERNS = [(f'"{words}"', re.compile(_phrase(words))) for words in PHRASES]
_PATTERNS += [
    ('a comment that begins with "Of"', re.compile(r'(?://+|#|\*|""")[ \t<!]*Of\b')),
    ("a name that begins with " + ", ".join(PREFIXES),
     re.compile(rf"\b_?(?:(?:{'|'.join(PREFIXES)})[A-Z]|(?:{'|'.join(PREFIXES).upper()})_)\w*")),
]


def find(text):
    """The findings in a text: pairs of a line number, from 1, and a description."""
    found = [(text.count("\n", 0, match.start()) + 1, f"{name}: {' '.join(match[0].split())}")
             for name, pattern in _PATTERNS for match in pattern.finditer(text)]
    return sorted(found)


def is_checked(name):
    """Whether a tracked file is a text or source that the check reads."""
    is_text = name.endswith(_ENDINGS) or name == "run"
    return is_text and not _SKIPPED.search(name)


def main(names):
    """Check files; returns the exit code."""
    if not names:
        tracked = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, check=True,
                                 capture_output=True, text=True).stdout.split("\0")
        names = [name for name in tracked if is_checked(name)]
    count = 0
    for name in names:
        for line, finding in find((ROOT / name).read_text(encoding="utf-8")):
            print(f"{name}:{line}: {finding}")
            count += 1
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
