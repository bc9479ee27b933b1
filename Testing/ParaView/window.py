# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Plays a user's actions in ParaView's window, as tuples (object, command, argument).

Objects are named from the main window; a dialog without a parent begins with "/". An action with
the command CHECK compares a property, written "name=value", and ParaView exits with another code
than 0 if the value differs.
"""

import os
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ET
from pathlib import Path

CHECK = "check"
TIMEOUT = 250  # seconds; ends a ParaView that waits in a dialog
VERSION = tuple(int(part) for part in os.environ["LMS3D_PARAVIEW_VERSION"].split(".")[:2])

_PANEL = "propertiesDock/propertiesPanel"
PROPERTIES = (f"{_PANEL}/scrollArea/qt_scrollarea_viewport/scrollAreaWidgetContents/PropertiesFrame/"
              "ProxyPanel")
INFORMATION = ("informationDock/informationWidgetFrame/informationScrollArea/qt_scrollarea_viewport/"
               "informationWidget")
PIPELINE = "pipelineBrowserDock/pipelineBrowser"
APPLY = [(f"{_PANEL}/Accept", "activate", "")]
DELETE = [(f"{_PANEL}/Delete", "activate", "")]
OK_BUTTON = "buttonBox/1QPushButton0"
SEARCH = "QuickLaunchDialog"
ESCAPE = 0x01000000
CONTROL = 0x04000000  # a key that is held


def choose(menu, *entries):
    """An entry of a menu and its submenus."""
    names = ["menubar", menu, *entries]
    return [("/".join(names[:i]), "activate", names[i]) for i in range(1, len(names))]


def open_file(path):
    """File > Open, Apply."""
    return [("MainControlsToolbar/actionOpenData", "activate", ""),
            ("FileOpenDialog", "filesSelected", str(path)), *APPLY]


def select(tree, place, x=40, held=0):
    """A click on an entry of the pipeline, while keys are held."""
    return [(tree, f"mouse{action}", f"1,{down},{held},{x},8,{place}")
            for action, down in (("Press", 1), ("Release", 0))]


def add_filter(name):
    """Filters > LMS3D."""
    return choose("menuFilters", "LMS3D", name)


def save_state(path):
    """File > Save State."""
    return choose("menu_File", "actionFileSaveServerState") + [
        ("FileSaveServerStateDialog", "filesSelected", str(path))]


def type_property(name, value):
    """A number of a property."""
    return [(f"{PROPERTIES}/{name}", "set_string", str(value))]


def expect(name, shown, value):
    """A property of a widget."""
    return [(name, CHECK, f"{shown}={value}")]


def expect_cells(count):
    """The number of cells in the Information panel."""
    return expect(f"{INFORMATION}/cellCount", "text", f"{count:,}")


def expect_icon(menu, category, place, text):
    """An icon of a category's toolbar, which has the text of its entry in the menu.

    ParaView 5.13 names the menu too, and hides these toolbars while it plays.
    """
    toolbar = f"{menu}.{category}/0" if VERSION >= (5, 13) else f"{category}/1"
    return expect(f"{toolbar}QToolButton{place}", "text", text)


def press(name, key, text=""):
    """A key of Qt."""
    return [(name, "keyEvent", f"6:{key}:0:{text}:0:1")]


def expect_found(words, text):
    """Words in the quick search, the entry that they find, and Escape, which clears the words."""
    steps = [step for letter in words for step in press(SEARCH, ord(letter.upper()), letter)]
    return steps + expect(f"{SEARCH}/selection", "text", text) + press(SEARCH, ESCAPE)


def write_script(path, actions):
    """The actions as ParaView's test player reads them."""
    root = ET.Element("pqevents")
    for name, command, argument in actions:
        name = name[1:] if name.startswith("/") else f"pqClientMainWindow/{name}"
        if command == CHECK:
            shown, _, value = argument.partition("=")
            ET.SubElement(root, "pqcheck", object=name, property=shown, arguments=value)
        else:
            ET.SubElement(root, "pqevent", object=name, command=command, arguments=argument)
    ET.ElementTree(root).write(path, encoding="utf-8", xml_declaration=True)


def hide_welcome(home):
    """Switches off the dialog that welcomes a new user, for ParaView with settings in `home`."""
    folder = Path(home) / ".config/ParaView"
    folder.mkdir(parents=True)
    version = os.environ["LMS3D_PARAVIEW_VERSION"]
    (folder / f"ParaView{version}.ini").write_text(
        "[General]\nGeneralSettings.ShowWelcomeDialog=false\n")


def play(home, actions, command=None, **environment):
    """The return code and all messages of ParaView, which reads and writes settings in `home`.

    `command` starts ParaView; without it, it is ParaView with LMS3D's plugins.
    """
    script = Path(home) / "actions.xml"
    write_script(script, actions)
    done = subprocess.run(
        [*(command or start_with_plugins()), f"--test-directory={home}", f"--test-script={script}",
         "--exit"],
        cwd=home, env=make_environment(home, environment), stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, text=True, check=False, timeout=TIMEOUT)
    return done.returncode, done.stdout


def start_with_plugins():
    """ParaView with the plugins that the build has."""
    command = [os.environ["LMS3D_PARAVIEW"]]
    for plugin in map(Path, filter(None, os.environ["LMS3D_PLUGINS"].split(os.pathsep))):
        command += [f"--plugin-search-paths={plugin.parent}", f"--plugins={plugin.stem}"]
    return command


def make_environment(home, others=()):
    """The environment of a user with this home."""
    inherited = {name: value for name, value in os.environ.items() if not name.startswith("XDG_")}
    return {**inherited, "HOME": str(home), "XDG_RUNTIME_DIR": str(home), "LC_ALL": "C.UTF-8",
            "LIBGL_ALWAYS_SOFTWARE": "1", "DASHBOARD_TEST_FROM_CTEST": "1", **dict(others)}


class WindowTest(unittest.TestCase):
    """A user with a home in which ParaView has never run."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.home = Path(folder.name)
        hide_welcome(self.home)

    def play(self, *actions):
        """All messages of a ParaView that played the actions."""
        code, messages = play(self.home, [step for steps in actions for step in steps])
        self.assertEqual(code, 0, messages)
        return messages

    def check_one_error(self, messages, text):
        """One error, which contains a text."""
        self.assertIn(text, messages)
        self.assertEqual(messages.count("ERR|"), 1, messages)
