# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""LMS3DScanner.idl keeps all types and operations of older versions, and adds operations at the end."""

import re
import unittest
from pathlib import Path

OLDER = Path(__file__).parent / "ScannerBeforeDevice.idl"
NEWEST = Path(__file__).parents[2] / "Plugins/CORBA/IDL/LMS3DScanner.idl"


def read_definitions(path):
    """The definitions of the module, from their first two words to their text, blanks normalized."""
    text = re.sub(r"/\*.*?\*/|//[^\n]*|#[^\n]*", "", path.read_text(encoding="utf-8"), flags=re.DOTALL)
    body = text[text.index("{") + 1:text.rindex("}")]
    definitions, depth, start = {}, 0, 0
    for at, letter in enumerate(body):
        depth += {"{": 1, "}": -1}.get(letter, 0)
        if letter == ";" and depth == 0:
            words = " ".join(body[start:at].split())
            name = re.match(r"typedef .* (\w+)$|\w+ (\w+)", words)
            definitions[name[1] or name[2]] = words
            start = at + 1
    return definitions


class OlderInterfaceTest(unittest.TestCase):
    """Clients that were compiled from an older version."""

    def test_nothing_changes(self):
        """An interface may be longer. All else is as it was."""
        older, newest = read_definitions(OLDER), read_definitions(NEWEST)
        self.assertEqual(len(older), 25)
        for name, words in older.items():
            if words.startswith("interface"):
                self.assertEqual(words[-1], "}")
                self.assertEqual(newest[name][:len(words) - 1], words[:-1])
            else:
                self.assertEqual(newest[name], words)


if __name__ == "__main__":
    unittest.main()
