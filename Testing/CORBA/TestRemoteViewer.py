# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""lms3d view --server: the small viewer with a real server. Needs a display."""

import signal
import subprocess
import sys
import tempfile
import time
import unittest
from unittest import mock

import numpy as np
from lms3d.remote import RemoteScanner
from lms3d.remote_viewer import RemoteViewer
from server_process import BEAMS, Server, find_free_port, wait_until

SIZE = (400, 160)

_windows = []

# A process of its own, since VTK's loop goes on until all windows of a process are closed.
_QUIT_LATER = """
import sys, time
from lms3d.remote import RemoteScanner
from lms3d.remote_viewer import RemoteViewer

def press_q(*_):
    if time.monotonic() > start + 1:
        viewer.interactor.SetKeySym("q")
        viewer.interactor.InvokeEvent("KeyPressEvent")

viewer = RemoteViewer(RemoteScanner(sys.argv[1]), (400, 160), "test")
print("shown", flush=True)
start = time.monotonic()
viewer.interactor.AddObserver("TimerEvent", press_q)
viewer.run()
print("quit", flush=True)
"""

# Another process, which can be stopped while it waits for nothing.
_FOLLOW = """
import sys, time
from lms3d.remote import RemoteScanner

scanner = RemoteScanner(sys.argv[1])
first = scanner.pose()[0][0]
print(first, flush=True)
while scanner.pose()[0][0] == first:
    time.sleep(0.05)
    if scanner.has_news():
        scanner.update()
print(scanner.pose()[0][0], flush=True)
"""


def find_marker(renderer):
    """The ball with the sensor's axes."""
    props = renderer.GetViewProps()
    return next(prop for prop in map(props.GetItemAsObject, range(props.GetNumberOfItems()))
                if prop.IsA("vtkAssembly"))


class TestWindow(unittest.TestCase):
    """The window, controlled like a user does."""

    def setUp(self):
        self.folder = self.enterContext(tempfile.TemporaryDirectory())
        self.arguments = ("--ior", f"{self.folder}/server.ior")
        self.url = f"file:{self.folder}/server.ior"

    def open(self):
        """A scanner and its window."""
        scanner = RemoteScanner(self.url)
        viewer = RemoteViewer(scanner, SIZE, "test", step=0.5)
        viewer.refresh()
        # From there the arrow keys follow the axes x and y.
        renderers = viewer.interactor.GetRenderWindow().GetRenderers()
        camera = renderers.GetFirstRenderer().GetActiveCamera()
        camera.SetFocalPoint(0, 0, 1)
        camera.SetPosition(0, -10, 6)
        # VTK 9.2 crashes if a second window is made after one was destroyed.
        _windows.append(viewer)
        return scanner, viewer

    def assert_soon(self, viewer, condition):
        """Run the window until the condition is true."""

        def work():
            viewer.interactor.ProcessEvents()
            return condition()

        self.assertTrue(wait_until(work))

    def press(self, viewer, key):
        """Press a key."""
        viewer.interactor.SetKeySym(key)
        viewer.interactor.InvokeEvent("KeyPressEvent")

    def assert_place(self, scanner, viewer, place):
        """The sensor gets there."""
        self.assert_soon(viewer, lambda: np.allclose(scanner.pose()[0], place, rtol=0, atol=1e-12))

    def test_scans_come_by_themselves(self):
        with Server(*self.arguments):
            scanner, viewer = self.open()
            self.assertEqual(scanner.returns, BEAMS)
            first = scanner.number
            self.assert_soon(viewer, lambda: scanner.number > first + 2)

    def test_k_keeps_what_was_seen(self):
        with Server(*self.arguments, "--fused-map", "0.02"):
            scanner, viewer = self.open()
            local = scanner.source.GetLocalMap().GetNumberOfCells()
            self.assertEqual(scanner.fused_triangles, 0)
            self.press(viewer, "k")
            self.assert_soon(viewer, lambda: scanner.fused_scans == 1)
            self.assertIn("kept: 1 scan, ", viewer.text)
            self.press(viewer, "Right")
            self.assert_soon(viewer, lambda: scanner.fused_scans == 2)
            self.assertIn(f"kept: 2 scans, {scanner.fused_triangles:,} triangles", viewer.text)
            self.assertNotEqual(scanner.fused_triangles, local)
            self.press(viewer, "k")
            self.assertNotIn("kept", viewer.text)
            self.assertEqual(scanner.fused_triangles, 0)
            number = scanner.number
            self.assert_soon(viewer, lambda: scanner.number > number + 2)
            self.press(viewer, "k")
            self.assert_soon(viewer, lambda: scanner.fused_scans == 2)
            self.assertIn("kept: 2 scans, ", viewer.text)

    def test_k_says_that_the_server_has_no_map(self):
        with Server(*self.arguments):
            scanner, viewer = self.open()
            self.press(viewer, "k")
            self.assert_soon(viewer, lambda: "started without --fused-map" in viewer.text)
            self.press(viewer, "k")
            self.assert_soon(viewer, lambda: "fused" not in viewer.text)
            self.assertEqual(scanner.problem, "")

    def test_keys_move_the_servers_sensor(self):
        with Server(*self.arguments, "--orientation", "10", "20", "30"):
            scanner, viewer = self.open()
            self.press(viewer, "Right")
            self.press(viewer, "Right")
            self.press(viewer, "Prior")
            self.assert_place(scanner, viewer, (1.3, -0.2, 1.5))
            np.testing.assert_allclose(scanner.pose()[1], (10, 20, 30), rtol=0, atol=1e-9)
            self.press(viewer, "r")
            self.assert_place(scanner, viewer, (0.3, -0.2, 1.0))

    def test_keys_turn_the_servers_sensor(self):
        with Server(*self.arguments):
            scanner, viewer = self.open()
            self.press(viewer, "z")
            self.press(viewer, "z")
            self.assert_soon(viewer, lambda: np.allclose(scanner.pose()[1], (0, 0, 30)))
            self.assertEqual(scanner.pose()[0], (0.3, -0.2, 1.0))
            self.press(viewer, "r")
            self.assert_soon(viewer, lambda: np.allclose(scanner.pose()[1], (0, 0, 0)))

    def test_keys_add_up_while_a_scan_is_far_off(self):
        with Server(*self.arguments) as server:
            scanner, viewer = self.open()
            server.process.send_signal(signal.SIGSTOP)
            self.press(viewer, "Right")
            self.assertIn("on the way to 0.80  -0.20  1.00 m", viewer.text)
            time.sleep(0.5)
            viewer.interactor.ProcessEvents()
            self.press(viewer, "Right")
            server.process.send_signal(signal.SIGCONT)
            self.assert_place(scanner, viewer, (1.3, -0.2, 1.0))
            self.assertNotIn("on the way", viewer.text)

    def test_a_place_without_returns(self):
        """The marker is there, and the camera stays."""
        with Server(*self.arguments):
            scanner, viewer = self.open()
            window = viewer.interactor.GetRenderWindow()
            renderer = window.GetRenderers().GetFirstRenderer()
            place = (1000, -0.2, 1)
            viewer.set_pose(place, (0, 0, 0))
            self.assert_place(scanner, viewer, place)
            self.assert_soon(viewer, lambda: "0 returns" in viewer.text)
            self.assertEqual(find_marker(renderer).GetPosition(), place)
            before = renderer.GetActiveCamera().GetPosition()
            # VTK passes exceptions of a key to this function. The scan from the start comes later.
            with mock.patch("sys.excepthook") as problems:
                self.press(viewer, "r")
            problems.assert_not_called()
            self.assertEqual(renderer.GetActiveCamera().GetPosition(), before)
            self.assert_place(scanner, viewer, (0.3, -0.2, 1.0))
            self.assertIn(f"{BEAMS:,} returns", viewer.text)

    def test_a_refused_pose_is_not_where_keys_go_on(self):
        with Server(*self.arguments, "--read-only"):
            scanner, viewer = self.open()
            self.press(viewer, "Right")
            self.assert_soon(viewer, lambda: "not permit" in viewer.text)
            self.assertFalse(scanner.is_pose_pending)
            self.assertNotIn("on the way", viewer.text)

    def test_it_follows_a_restart_elsewhere(self):
        with Server(*self.arguments) as server:
            scanner, viewer = self.open()
            server.stop(signal.SIGKILL)
            self.assert_soon(viewer, lambda: "no server answers" in scanner.problem)
            self.assertEqual(scanner.returns, BEAMS)
        with Server(*self.arguments, "--position", "1", "0", "1.5"):
            self.assert_place(scanner, viewer, (1, 0, 1.5))
            self.assertEqual(scanner.problem, "")

    def test_a_restart_between_two_calls(self):
        """The window shows the scan that the new server already has, without waiting for the next."""
        place = ("--endpoint", f"giop:tcp:127.0.0.1:{find_free_port()}")
        with Server(*place, "--rate", "50") as server:
            follower = subprocess.Popen([sys.executable, "-c", _FOLLOW, server.corbaloc],
                                        stdout=subprocess.PIPE, text=True)
            self.addCleanup(follower.stdout.close)
            self.addCleanup(follower.wait)
            self.addCleanup(follower.kill)
            self.assertEqual(follower.stdout.readline(), "0.3\n")
            follower.send_signal(signal.SIGSTOP)
            time.sleep(1)
            server.stop()
        with Server(*place, "--rate", "0.01", "--position", *"111"):
            follower.send_signal(signal.SIGCONT)
            self.assertEqual(follower.communicate(timeout=60)[0], "1.0\n")

    def test_it_quits_while_the_server_hangs(self):
        with Server(*self.arguments) as server:
            window = subprocess.Popen([sys.executable, "-c", _QUIT_LATER, self.url],
                                      stdout=subprocess.PIPE, text=True)
            self.assertEqual(window.stdout.readline(), "shown\n")
            server.process.send_signal(signal.SIGSTOP)
            self.assertEqual(window.communicate(timeout=60)[0], "quit\n")
            self.assertEqual(window.returncode, 0)


if __name__ == "__main__":
    unittest.main()
