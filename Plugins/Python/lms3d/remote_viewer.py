# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""A picture and a live window of a running server: its scan left, its local map right."""

from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

from .figure import Figure
from .pose import TURN_STEP, describe
from .viewer import Window

_POLL_INTERVAL = 50  # milliseconds between two checks for a new scan
_HUES = (0.0, 0.667)  # from red, near, to blue, far
_VALUES = (0.75, 0.75)  # darker than full colours, so that yellow is visible on white


class RemoteFigure(Figure):
    """Scan and local map of a RemoteScanner side by side; the scan is coloured by range."""

    def place_marker(self):
        """Move the marker to the pose of the scan."""
        position, orientation = self._simulation.pose()
        self._marker.SetPosition(position)
        self._marker.SetOrientation(orientation)

    def _surface(self):
        return self._simulation.scan

    def _left_actor(self):
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(self._simulation.source.GetOutputPort(0))
        mapper.CreateDefaultLookupTable()
        mapper.GetLookupTable().SetHueRange(_HUES)
        mapper.GetLookupTable().SetValueRange(_VALUES)
        mapper.SetScalarRange(self._simulation.scan.GetPointData().GetScalars().GetRange())
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().LightingOff()
        return actor

    def _map_port(self):
        return self._simulation.source.GetOutputPort(1)


class RemoteViewer(Window):
    """A window that shows a RemoteScanner and redraws with each scan."""

    def __init__(self, scanner, size, title, step=None, edges=False, turn_step=TURN_STEP):
        self._scanner = scanner
        self._sent = scanner.pose()
        super().__init__(RemoteFigure(scanner, size, off_screen=False, edges=edges), title, step,
                         scanner.scan.GetLength(), turn_step)
        self.interactor.AddObserver("TimerEvent", self._poll)
        self.interactor.CreateRepeatingTimer(_POLL_INTERVAL)

    def refresh(self):
        """Draw the newest scan."""
        self._scanner.update()
        self._figure.place_marker()
        self.draw(self._scanner.pose(), self._scanner.returns, *self._describe_state())

    def pose(self):
        """The sensor's pose, or the pose that was sent last if its scan has not arrived yet."""
        return self._sent if self._scanner.is_pose_pending else self._scanner.pose()

    def set_pose(self, position, orientation):
        """Send a pose to the server."""
        self._sent = (position, orientation)
        self._scanner.send_pose(position, orientation)
        self.refresh()

    def _describe_state(self):
        words = [f"scan {self._scanner.number:,}"]
        if self._scanner.is_pose_pending:
            words.append(f"on the way to {describe(self._sent)}")
        if self._scanner.problem:
            words.append(self._scanner.problem)
        return words

    def _poll(self, *_):
        if self._scanner.has_news():
            self.refresh()
