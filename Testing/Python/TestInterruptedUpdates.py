#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Ctrl-C in updates of the package lms3d: they stop, and a program's own signals stay as they are."""

import signal
import threading
import unittest
from unittest import mock

import lms3d
from command_line import POSITION, ROOM, room
from lms3d.execution import update


class TestLibrary(unittest.TestCase):
    """The handler of the package leaves a program's own signals as they are."""

    @staticmethod
    def _scan():
        reader = lms3d.vtkVRMLImporterSource()
        reader.SetFileName(str(ROOM))
        sensor = lms3d.vtkLMS3DScanFilter()
        sensor.SetInputConnection(reader.GetOutputPort())
        sensor.SetPosition(0.3, -0.2, 1)
        return sensor

    def _interrupt_while_reading(self, sensor):
        reader = sensor.GetInputAlgorithm(0, 0)
        reader.AddObserver("StartEvent", lambda *_: signal.raise_signal(signal.SIGINT))
        update(sensor, "scanning", "cannot scan")

    def test_an_interrupted_update_raises_and_the_next_one_works(self):
        sensor = self._scan()
        with self.assertRaises(KeyboardInterrupt):
            self._interrupt_while_reading(sensor)
        self.assertIs(signal.getsignal(signal.SIGINT), signal.default_int_handler)
        sensor.GetInputAlgorithm(0, 0).RemoveObservers("StartEvent")
        sensor.GetInputAlgorithm(0, 0).Modified()
        update(sensor, "scanning", "cannot scan")
        self.assertEqual(sensor.GetOutput().GetNumberOfPoints(), 361 * 360)

    def test_functions(self):
        def make(algorithm_class):
            algorithm = algorithm_class()
            algorithm.AddObserver("StartEvent", lambda *_: signal.raise_signal(signal.SIGINT))
            return algorithm

        mesh = room()
        scan = lms3d.scan(mesh, POSITION)
        calls = {"vtkLMS3DScanFilter": lambda: lms3d.scan(mesh, POSITION),
                 "vtkLMS3DSurfaceReconstructionFilter": lambda: lms3d.reconstruct(scan)}
        for name, call in calls.items():
            algorithm_class = getattr(lms3d, name)
            with self.subTest(name):
                with mock.patch(f"lms3d.scanning.{name}", lambda: make(algorithm_class)), \
                        self.assertRaises(KeyboardInterrupt):
                    call()
                self.assertIs(signal.getsignal(signal.SIGINT), signal.default_int_handler)
                call()

    def test_a_handler_of_the_program_stays(self):
        calls = []
        before = signal.signal(signal.SIGINT, lambda *_: calls.append(True))
        self.addCleanup(signal.signal, signal.SIGINT, before)
        self._interrupt_while_reading(self._scan())
        self.assertEqual(calls, [True])

    def test_another_thread_has_no_handler(self):
        sensor = self._scan()
        thread = threading.Thread(target=update, args=(sensor, "scanning", "cannot scan"))
        thread.start()
        thread.join()
        self.assertEqual(sensor.GetOutput().GetNumberOfPoints(), 361 * 360)


if __name__ == "__main__":
    unittest.main()
