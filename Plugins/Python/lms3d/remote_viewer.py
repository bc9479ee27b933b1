# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The picture of a running server, its scan left and its local map right, and the live window."""

from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

from .figure import Figure
from .viewer import Window, format_place

_LOOK_INTERVAL = 50  # milliseconds between two looks for a new scan
_NEAR_TO_FAR = (0.0, 0.667)  # hues: red, blue
_DARKNESS = (0.75, 0.75)  # values: yellow would not be seen on white


class RemoteFigure(Figure):
    """Scan and local map of a RemoteScanner side by side; the scan is coloured by range."""

    def place_marker(self):
        """Put the marker where the sensor was."""
        position, orientation = self._simulation.pose()
        self._marker.SetPosition(position)
        self._marker.SetOrientation(orientation)

    def _surface(self):
        return self._simulation.scan

    def _left_actor(self):
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(self._simulation.source.GetOutputPort(0))
        mapper.CreateDefaultLookupTable()
        mapper.GetLookupTable().SetHueRange(_NEAR_TO_FAR)
        mapper.GetLookupTable().SetValueRange(_DARKNESS)
        mapper.SetScalarRange(self._simulation.scan.GetPointData().GetScalars().GetRange())
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().LightingOff()
        return actor

    def _map_port(self):
        return self._simulation.source.GetOutputPort(1)


class RemoteViewer(Window):
    """A window on a RemoteScanner, drawn again with each scan."""

    def __init__(self, scanner, size, title, step=None, edges=False):
        self._scanner = scanner
        self._start = self._sent = scanner.pose()
        super().__init__(RemoteFigure(scanner, size, off_screen=False, edges=edges), title, step,
                         scanner.scan.GetLength())
        self.interactor.AddObserver("TimerEvent", self._look)
        self.interactor.CreateRepeatingTimer(_LOOK_INTERVAL)

    def refresh(self):
        """Draw the newest scan."""
        self._scanner.update()
        if self._scanner.returns > 0:
            self._figure.place_marker()
        self.draw(self._scanner.pose()[0], self._scanner.returns, "\n" + self._tell_state())

    def move(self, shift):
        """Send the sensor beside where it is, or where it was just sent to."""
        position, orientation = self._pose()
        self._send([x + d for x, d in zip(position, shift)], orientation)

    def reset(self):
        """Send the sensor to where the first scan was made."""
        self._send(*self._start)

    def _pose(self):
        return self._sent if self._scanner.is_pose_pending else self._scanner.pose()

    def _tell_state(self):
        words = [f"scan {self._scanner.number:,}"]
        if self._scanner.is_pose_pending:
            words.append(f"on the way to {format_place(self._sent[0])} m")
        if self._scanner.problem:
            words.append(self._scanner.problem)
        return "    ".join(words)

    def _send(self, position, orientation):
        self._sent = (position, orientation)
        self._scanner.send_pose(position, orientation)
        self.refresh()

    def _look(self, *_):
        if self._scanner.has_news():
            self.refresh()
