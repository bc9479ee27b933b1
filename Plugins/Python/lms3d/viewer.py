# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The interactive window: keys move and turn the sensor, and the local map follows."""

import math

import vtkmodules.vtkRenderingFreeType  # noqa: F401 renders the help line
from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindowInteractor, vtkTextActor

from .camera import level_axes
from .figure import Figure
from .interruption import interruptible
from .kept_map import KeptMap
from .pose import TURN_STEP, describe, turn

_HELP = ("arrows: move as seen", "page up/down: height", "x y z: turn about red, green, blue axis",
         "with shift: turn back", "mouse: camera", "r: reset", "q: quit")
HELP_WITH_KEEPING = (*_HELP[:-2], "k: keep what was seen", *_HELP[-2:])

_INTERRUPTION_INTERVAL = 200  # milliseconds

# Steps to the right and up in the picture, and along the world's z axis.
_MOVES = {
    "Left": (-1, 0, 0),
    "Right": (1, 0, 0),
    "Down": (0, -1, 0),
    "Up": (0, 1, 0),
    "Next": (0, 0, -1),
    "Prior": (0, 0, 1),
}
_AXES = {"x": 0, "y": 1, "z": 2}

_FONT_SIZE = 14  # pixels
_LETTER_WIDTH = 7.5  # pixels, the mean of this font
_TEXT_MARGIN = 10  # pixels
_GAP = "    "


class Window:
    """A window on a figure, in which keys move and turn a sensor.

    A key moves the sensor by `step` metres, or by 1/50 of `length`, and turns it by `turn_step`
    degrees. Subclasses define where the sensor is, how it gets elsewhere and how the figure is
    refreshed.
    """

    _help = _HELP

    def __init__(self, figure, title, step, length, turn_step=TURN_STEP):
        self._figure = figure
        self._step = step or _round_step(length / 50)
        self._turn_step = turn_step
        self._start = self.pose()
        self._parts = ()
        self._figure.window.SetWindowName(f"lms3d: {title}")
        self._text = self._add_text()
        self.interactor = self._make_interactor()
        self._figure.window.AddObserver("WindowResizeEvent", self._on_resize)

    def run(self):
        """Show the window until it is closed, or until Ctrl-C in the terminal."""
        with interruptible(self.interactor.TerminateApp) as interruptions:
            self.refresh()
            # Python handles Ctrl-C when VTK calls an observer. VTK forgets the end of the
            # application if it comes before the start, so the observer repeats it.
            self.interactor.AddObserver(
                "TimerEvent", lambda *_: interruptions and self.interactor.TerminateApp())
            self.interactor.CreateRepeatingTimer(_INTERRUPTION_INTERVAL)
            self.interactor.Start()

    def refresh(self):
        """Update the figure and draw it."""
        raise NotImplementedError

    def pose(self):
        """The sensor's position (metres) and orientation (degrees)."""
        raise NotImplementedError

    def set_pose(self, position, orientation):
        """Move the sensor to a pose, and draw."""
        raise NotImplementedError

    def draw(self, pose, returns, *further):
        """Draw, with a text about the sensor and the keys."""
        self._parts = (f"sensor {describe(pose)}", f"{returns:,} returns", *further)
        self._set_text()
        self._figure.render()

    @property
    def text(self):
        """The text at the bottom of the window."""
        return self._text.GetInput()

    def _make_interactor(self):
        style = vtkInteractorStyleTrackballCamera()
        style.AddObserver("CharEvent", lambda *_: None)  # turns off VTK's own keys
        interactor = vtkRenderWindowInteractor()
        interactor.SetRenderWindow(self._figure.window)
        interactor.SetInteractorStyle(style)
        interactor.AddObserver("KeyPressEvent", self._on_key)
        interactor.Initialize()
        return interactor

    def _on_key(self, interactor, _event):
        # With shift, VTK names a letter z or Z, by the system.
        key = interactor.GetKeySym() or ""
        if key in _MOVES:
            self._move(_MOVES[key])
        elif key.lower() in _AXES:
            self._turn(_AXES[key.lower()], -1 if interactor.GetShiftKey() else 1)
        elif key == "r":
            self.set_pose(*self._start)
            self._figure.reset_camera()
            self.refresh()
        elif key == "k":
            self._toggle_keeping()
        elif key == "q":
            interactor.TerminateApp()

    def _toggle_keeping(self):
        """Begin or end to keep what was seen, if the window can."""

    def _move(self, steps):
        position, orientation = self.pose()
        axes = (*level_axes(self._figure.camera), (0, 0, 1))
        for count, axis in zip(steps, axes):
            position = [x + self._step * count * a for x, a in zip(position, axis)]
        self.set_pose(position, orientation)

    def _turn(self, axis, sign):
        position, orientation = self.pose()
        self.set_pose(position, turn(orientation, axis, sign * self._turn_step))

    def _on_resize(self, *_):
        self._figure.follow_size()
        self._set_text()

    def _set_text(self):
        letters = (self._figure.window.GetSize()[0] - 2 * _TEXT_MARGIN) / _LETTER_WIDTH
        self._text.SetInput("\n".join(_wrap(self._parts, letters) + _wrap(self._help, letters)))

    def _add_text(self):
        """A text in a layer of its own, over both halves."""
        text = vtkTextActor()
        text.SetPosition(_TEXT_MARGIN, 8)
        text.GetTextProperty().SetFontSize(_FONT_SIZE)
        text.GetTextProperty().SetColor(0.2, 0.2, 0.2)
        layer = vtkRenderer()
        layer.SetLayer(1)
        layer.InteractiveOff()
        layer.AddViewProp(text)
        self._figure.window.SetNumberOfLayers(2)
        self._figure.window.AddRenderer(layer)
        return text


class Viewer(Window):
    """A window that shows a simulation. It can join the local maps of all poses to one map."""

    _help = HELP_WITH_KEEPING

    def __init__(self, simulation, size, step=None, edges=False, turn_step=TURN_STEP):
        self._simulation = simulation
        self._kept = None
        super().__init__(Figure(simulation, size, off_screen=False, edges=edges),
                         simulation.scene.path.name, step, simulation.scene.surface.GetLength(),
                         turn_step)

    def refresh(self):
        """Scan from the sensor's pose and draw."""
        self._simulation.reconstruction.Update()
        self._figure.place_marker()
        self.draw(self.pose(), self._simulation.returns, *self._grow())

    def pose(self):
        """The sensor's position (metres) and orientation (degrees)."""
        sensor = self._simulation.sensor
        return sensor.GetPosition(), sensor.GetOrientation()

    def set_pose(self, position, orientation):
        """Move the sensor to a pose, scan, and draw."""
        self._simulation.sensor.SetPosition(position)
        self._simulation.sensor.SetOrientation(orientation)
        self.refresh()

    def _toggle_keeping(self):
        """Begin a map of what is seen from now on, or show the local map alone again."""
        self._kept = None if self._kept else KeptMap(self._simulation)
        self._figure.show_map(self._kept.port if self._kept else None)
        self.refresh()

    def _grow(self):
        """Add what is seen to the kept map; what to say about it."""
        if not self._kept:
            return []
        self._kept.grow()
        return [self._kept.describe()]


def _wrap(parts, letters):
    """Join the parts to lines of at most a number of letters, unless a single part is longer."""
    lines = []
    for part in parts:
        if lines and len(lines[-1] + _GAP + part) <= letters:
            lines[-1] += _GAP + part
        else:
            lines.append(part)
    return lines


def _round_step(length):
    """The largest of 1, 2 and 5 times a power of ten that does not exceed a length."""
    power = 10.0 ** math.floor(math.log10(length))
    return max(factor * power for factor in (1, 2, 5) if factor * power <= length)
