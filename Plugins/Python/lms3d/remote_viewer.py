# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""A picture and a live window of a running server: its scan left, its local map right."""

from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

from .figure import Figure
from .kept_map import describe_kept
from .pose import TURN_STEP, describe
from .viewer import HELP_WITH_KEEPING, Window

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

    _help = HELP_WITH_KEEPING

    def __init__(self, scanner, size, title, step=None, edges=False, turn_step=TURN_STEP):
        self._scanner = scanner
        self._sent = scanner.pose()
        self._keeps = False
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

    def _toggle_keeping(self):
        """Show the server's map of all poses, or the local map alone again."""
        self._keeps = not self._keeps
        self._scanner.fetch_fused_map(self._keeps)
        self._figure.show_map(self._scanner.source.GetOutputPort(2) if self._keeps else None)
        self.refresh()

    def _describe_state(self):
        words = [f"scan {self._scanner.number:,}"]
        if self._scanner.is_pose_pending:
            words.append(f"on the way to {describe(self._sent)}")
        if self._keeps:
            words.append(describe_kept(self._scanner.fused_scans, self._scanner.fused_triangles))
        if self._scanner.problem:
            words.append(self._scanner.problem)
        return words

    def _poll(self, *_):
        if self._scanner.has_news():
            self.refresh()
