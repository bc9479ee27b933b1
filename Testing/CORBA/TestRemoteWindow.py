# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's window with the plugin LMS3DRemote watches a server, which it moves and which restarts.

WatchServer.xml is what the user does and sees; the numbers in it are checked here. Needs a display.
LMS3D_PARAVIEW is the program, LMS3D_REMOTE_PLUGIN the plugin's file.
"""

import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

import lms3d
from server_process import BEAMS, DATA, Server, wait_until

SCRIPT = Path(__file__).with_name("WatchServer.xml")


def start_paraview(folder):
    """ParaView with nothing but this plugin, in a folder and with a home of its own."""
    plugin = Path(os.environ["LMS3D_REMOTE_PLUGIN"])
    environment = dict(
        os.environ, HOME=folder, XDG_CONFIG_HOME=folder, XDG_CACHE_HOME=folder,
        XDG_RUNTIME_DIR=folder, LC_ALL="C.UTF-8", LIBGL_ALWAYS_SOFTWARE="1",
        DASHBOARD_TEST_FROM_CTEST="1")
    return subprocess.Popen(
        [os.environ["LMS3D_PARAVIEW"], "--dr", f"--plugin-search-paths={plugin.parent}",
         f"--plugins={plugin.stem}", f"--test-directory={folder}", f"--test-script={SCRIPT}",
         "--exit"],
        cwd=folder, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


class Observer:
    """Reads the position of a server's sensor."""

    def __init__(self, reference):
        self.source = lms3d.vtkLMS3DRemoteSource()
        self.source.SetURL(reference)
        self.source.Update()

    def sensor_x(self):
        """Metres."""
        if self.source.GetNeedsUpdate():
            self.source.Update()
        return self.source.GetOutput().GetFieldData().GetArray("SensorToWorld").GetValue(3)


def count_returns(*position):
    """The number of returns that the direct pipeline has."""
    room = lms3d.vtkVRMLImporterSource()
    room.SetFileName(str(DATA / "room.wrl"))
    scan = lms3d.vtkLMS3DScanFilter()
    scan.SetInputConnection(room.GetOutputPort())
    scan.SetPosition(*position)
    scan.Update()
    return scan.GetOutput().GetNumberOfPoints()


class TestWindow(unittest.TestCase):
    """The window of an operator."""

    def test_it_follows_the_server(self):
        folder = self.enterContext(tempfile.TemporaryDirectory())
        arguments = ("--ior", f"{folder}/server.ior")
        with Server(*arguments) as server:
            paraview = start_paraview(folder)
            self.addCleanup(paraview.kill)
            observer = Observer(server.reference)
            self.assertTrue(wait_until(lambda: observer.sensor_x() == 1.0, 120))
            self.assertEqual(server.stop()[0], 0)
        with Server(*arguments):
            words = paraview.communicate(timeout=120)[0]
        self.assertEqual(paraview.returncode, 0, words)
        self.assertNotIn("ERR|", words)

    def test_the_numbers_that_it_shows(self):
        shown = re.findall(r'cellCount"\s+property="text" arguments="(.+?)"',
                           SCRIPT.read_text(encoding="utf-8"))
        start, moved = count_returns(0.3, -0.2, 1.0), count_returns(0, 0, 10)
        self.assertEqual(start, BEAMS)
        self.assertEqual(shown, [f"{count:,}" for count in (start, moved, start)])


if __name__ == "__main__":
    unittest.main()
