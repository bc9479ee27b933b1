# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The interactive window: keys move the sensor, and the local map follows."""

import math

import vtkmodules.vtkRenderingFreeType  # noqa: F401 renders the help line
from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
from vtkmodules.vtkRenderingCore import vtkRenderWindowInteractor, vtkTextActor

from .figure import Figure
from .interruption import interruptible

_HELP = "arrows: x, y    page up/down: z    mouse: camera    r: reset    q: quit"

_INTERRUPTION_INTERVAL = 200  # milliseconds

_MOVES = {
    "Left": (-1, 0, 0),
    "Right": (1, 0, 0),
    "Down": (0, -1, 0),
    "Up": (0, 1, 0),
    "Next": (0, 0, -1),
    "Prior": (0, 0, 1),
}


class Window:
    """A window on a figure, in which keys move a sensor by `step` metres, or by 1/50 of `length`.

    Subclasses define how the sensor moves and how the figure is refreshed.
    """

    def __init__(self, figure, title, step, length):
        self._figure = figure
        self._step = step or _round_step(length / 50)
        self._figure.window.SetWindowName(f"lms3d: {title}")
        self._text = self._add_text()
        self.interactor = self._make_interactor()

    def run(self):
        """Show the window until it is closed, or until Ctrl-C in the terminal."""
        self.refresh()
        # Python handles Ctrl-C when VTK calls an observer.
        self.interactor.AddObserver("TimerEvent", lambda *_: None)
        self.interactor.CreateRepeatingTimer(_INTERRUPTION_INTERVAL)
        with interruptible(self.interactor.TerminateApp):
            self.interactor.Start()

    def refresh(self):
        """Update the figure and draw it."""
        raise NotImplementedError

    def move(self, shift):
        """Move the sensor by metres along x, y and z."""
        raise NotImplementedError

    def reset(self):
        """Move the sensor back to its first position."""
        raise NotImplementedError

    def draw(self, position, returns, further=""):
        """Draw, with a line of text about the sensor and the keys."""
        self._text.SetInput(f"sensor {format_position(position)} m    {returns:,} returns    "
                            f"{_HELP}{further}")
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
        key = interactor.GetKeySym()
        if key in _MOVES:
            self.move([self._step * x for x in _MOVES[key]])
        elif key == "r":
            self.reset()
            self._figure.reset_camera()
            self.refresh()
        elif key == "q":
            interactor.TerminateApp()

    def _add_text(self):
        text = vtkTextActor()
        text.SetPosition(10, 8)
        text.GetTextProperty().SetFontSize(14)
        text.GetTextProperty().SetColor(0.2, 0.2, 0.2)
        self._figure.window.GetRenderers().GetFirstRenderer().AddViewProp(text)
        return text


class Viewer(Window):
    """A window that shows a simulation."""

    def __init__(self, simulation, size, step=None, edges=False):
        self._simulation = simulation
        self._start = simulation.sensor.GetPosition()
        super().__init__(Figure(simulation, size, off_screen=False, edges=edges),
                         simulation.scene.path.name, step, simulation.scene.surface.GetLength())

    def refresh(self):
        """Scan from the sensor's position and draw."""
        self._simulation.reconstruction.Update()
        self._figure.place_marker()
        self.draw(self._simulation.sensor.GetPosition(), self._simulation.returns)

    def move(self, shift):
        """Move the sensor by metres along x, y and z, and scan."""
        position = self._simulation.sensor.GetPosition()
        self._simulation.sensor.SetPosition(*(x + d for x, d in zip(position, shift)))
        self.refresh()

    def reset(self):
        """Move the sensor back to its first position."""
        self._simulation.sensor.SetPosition(self._start)


def format_position(position):
    """Coordinates with centimetres."""
    return "  ".join(f"{x:.2f}" for x in position)


def _round_step(length):
    """The largest of 1, 2 and 5 times a power of ten that does not exceed a length."""
    power = 10.0 ** math.floor(math.log10(length))
    return max(factor * power for factor in (1, 2, 5) if factor * power <= length)
