# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The paper's Figures 5 and 6: the scene in blue, left, its local map in green, right.

Both halves share one camera. Only faces that are turned towards the camera are drawn. The walls of
a room face inwards, so the walls between camera and furniture are not drawn.
"""

import ctypes
import ctypes.util

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 the implementation of the classes below
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkBoundingBox
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals, vtkTriangleFilter
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkCamera,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

from .camera import frame, get_direction, reframe
from .marker import make_marker
from .messages import VTKMessages
from .problems import Problem

DEFAULT_SIZE = (1600, 620)

_WHITE = (1.0, 1.0, 1.0)
_BLUE = (0.44, 0.64, 0.96)
_BLUE_EDGES = (0.20, 0.35, 0.66)
_GREEN = (0.42, 0.80, 0.42)
_GREEN_EDGES = (0.14, 0.42, 0.16)

# Intensity and direction of each light in the camera frame: x right, y up, z towards the viewer.
_LIGHTS = ((0.55, (0.30, 0.50, 0.81)), (0.48, (0.0, 0.0, 1.0)), (0.36, (-0.80, -0.20, 0.56)))

_FEATURE_ANGLE = 30.0  # degrees; edges with a larger angle are drawn sharp
_MARKER_SIZE = 0.04  # of the diagonal of the scene
_SCREEN_SHARE = (0.95, 0.9)  # of the screen's width and height; window managers add a frame


def check_display():
    """Raise Problem without a display; VTK itself would end the process."""
    if vtkRenderWindow().IsA("vtkXOpenGLRenderWindow") and not _x_server_answers():
        raise Problem("no display to draw on: start a desktop session, set DISPLAY, or put "
                      "'xvfb-run -a -s \"-noreset -screen 0 1280x1024x24\"' before the command")


def _x_server_answers():
    """Whether an X server opens the display that DISPLAY names."""
    name = ctypes.util.find_library("X11")
    if name is None:
        return True
    x11 = ctypes.CDLL(name)
    x11.XOpenDisplay.restype = ctypes.c_void_p
    display = x11.XOpenDisplay(None)
    if display:
        x11.XCloseDisplay(ctypes.c_void_p(display))
    return bool(display)


class Figure:
    """Scene and local map of a simulation side by side.

    `window` is the vtkRenderWindow, off screen by default, and `camera` the camera of both halves.
    A window on the screen is never larger than the screen. With `edges` the edges of the map's
    triangles are drawn.
    """

    def __init__(self, simulation, size=DEFAULT_SIZE, off_screen=True, edges=False):
        check_display()
        self._simulation = simulation
        self._aspect = None
        self._marker = make_marker(_MARKER_SIZE * _diagonal(self._surface()))
        self.camera = vtkCamera()
        self.window = vtkRenderWindow()
        self.window.SetMultiSamples(0)
        self.window.SetOffScreenRendering(off_screen)
        self.window.SetSize(*(size if off_screen else self._limit_to_screen(size)))
        self._add_half(self._left_actor(), (0.0, 0.0, 0.5, 1.0))
        self._right = self._right_actor(edges)
        self._add_half(self._right, (0.5, 0.0, 1.0, 1.0))
        self.place_marker()
        self.reset_camera()

    def place_marker(self):
        """Move the marker to the sensor."""
        self._marker.SetPosition(self._simulation.sensor.GetPosition())
        self._marker.SetOrientation(self._simulation.sensor.GetOrientation())

    def show_map(self, port=None):
        """Show the map of an output port on the right; without one, the local map."""
        self._right.GetMapper().SetInputConnection(port or self._map_port())

    def reset_camera(self):
        """Show the whole scene, from a side that the sensor sees. Without points the camera stays."""
        surface = self._surface()
        if surface.GetNumberOfPoints() > 0:
            direction = get_direction(surface.GetBounds(), self._marker.GetPosition())
            self._aspect = self._measure_aspect()
            frame(self.camera, _points(surface), direction, self._aspect)
            self._reset_clipping()

    def follow_size(self):
        """Keep the whole scene in view after the window's size has changed."""
        old_aspect, self._aspect = self._aspect, self._measure_aspect()
        if self._aspect != old_aspect and self._surface().GetNumberOfPoints() > 0:
            reframe(self.camera, _points(self._surface()), old_aspect, self._aspect)
            self._reset_clipping()

    def render(self):
        """Draw the figure."""
        self._reset_clipping()
        with VTKMessages() as messages:
            self.window.Render()
        messages.report("cannot draw")

    def image(self):
        """Draw the figure and return it as vtkImageData, 8 bits RGB."""
        self.render()
        grab = vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.ReadFrontBufferOff()
        grab.ShouldRerenderOff()
        grab.Update()
        return grab.GetOutput()

    def _surface(self):
        """The surface that the camera shows."""
        return self._simulation.scene.surface

    def _left_actor(self):
        return _scene_actor(self._simulation.scene.surface)

    def _right_actor(self, edges):
        return make_map_actor(self._map_port(), edges)

    def _map_port(self):
        """The output port of the local map."""
        return self._simulation.reconstruction.GetOutputPort()

    def _add_half(self, actor, viewport):
        renderer = vtkRenderer()
        renderer.SetViewport(*viewport)
        renderer.SetBackground(*_WHITE)
        renderer.SetActiveCamera(self.camera)
        renderer.UseFXAAOn()
        renderer.AddActor(actor)
        renderer.AddActor(self._marker)
        add_lights(renderer)
        self.window.AddRenderer(renderer)

    def _limit_to_screen(self, size):
        screen = self.window.GetScreenSize()
        return [min(pixels, int(share * side))
                for pixels, share, side in zip(size, _SCREEN_SHARE, screen)]

    def _measure_aspect(self):
        """Width by height of each half."""
        width, height = self.window.GetSize()
        return 0.5 * max(width, 1) / max(height, 1)

    def _reset_clipping(self):
        """Set the clipping range by the left half: the scene contains the map."""
        self.window.GetRenderers().GetFirstRenderer().ResetCameraClippingRange()


def add_lights(renderer):
    """Add lights that move with the camera and shade floor and walls of a room differently."""
    renderer.AutomaticLightCreationOff()
    for intensity, direction in _LIGHTS:
        light = vtkLight()
        light.SetLightTypeToCameraLight()
        light.SetPosition(direction)
        light.SetIntensity(intensity)
        renderer.AddLight(light)


def _scene_actor(surface):
    """The scene: triangles with thin edges, without back faces."""
    triangles = vtkTriangleFilter()
    triangles.SetInputData(surface)
    triangles.PassVertsOff()
    triangles.PassLinesOff()
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(triangles.GetOutputPort())
    normals.SetFeatureAngle(_FEATURE_ANGLE)
    normals.ConsistencyOff()
    actor = _surface_actor(normals.GetOutputPort(), _BLUE)
    actor.GetProperty().EdgeVisibilityOn()
    actor.GetProperty().SetEdgeColor(*_BLUE_EDGES)
    return actor


def make_map_actor(port, edges=False):
    """The local map of an output port, with flat shading."""
    actor = _surface_actor(port, _GREEN)
    actor.GetProperty().SetInterpolationToFlat()
    actor.GetProperty().SetEdgeVisibility(edges)
    actor.GetProperty().SetEdgeColor(*_GREEN_EDGES)
    return actor


def _surface_actor(port, color):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(port)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*color)
    actor.GetProperty().BackfaceCullingOn()
    return actor


def _points(surface):
    return vtk_to_numpy(surface.GetPoints().GetData())


def _diagonal(surface):
    return vtkBoundingBox(surface.GetBounds()).GetDiagonalLength()
