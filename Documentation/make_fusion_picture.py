#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Make images/fusion.png: the map that grows while a sensor drives through Data/building.wrl.

    xvfb-run -a -s "-noreset -screen 0 1600x1200x24" ./run python Documentation/make_fusion_picture.py

Three small panels show the map on the way, and a large one shows it at the end, from above without
the ceilings. The line is the way of the sensor so far, and the ball with arrows is the sensor.
"""

from pathlib import Path

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 the implementation of the classes below
import vtkmodules.vtkRenderingFreeType  # noqa: F401 renders the texts
from lms3d import vtkLMS3DMapFusion
from lms3d.camera import frame
from lms3d.figure import add_lights, make_map_actor
from lms3d.marker import make_marker
from lms3d.results import save
from lms3d.scene import read_data, read_scene
from lms3d.simulation import Simulation
from lms3d.trajectory import TrajectoryScan
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkFiltersCore import vtkTubeFilter
from vtkmodules.vtkFiltersSources import vtkLineSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkTextActor,
    vtkWindowToImageFilter,
)

ROOT = Path(__file__).resolve().parents[1]
SCENE, JOURNEY = ROOT / "Data/building.wrl", ROOT / "Data/building_journey.vtp"
PICTURE = ROOT / "Documentation/images/fusion.png"

BEAMS, TURNS = 181, 180
MAXIMUM_ERROR = 0.02  # metres
ON_THE_WAY = (30, 90, 150)  # numbers of poses

SIZE = (1500, 1230)
LARGE = 0.68  # of the picture's height
DIRECTION = np.array((-0.12, -0.55, 0.83))  # from the scene to the camera
LINE_WIDTH, MARKER = 0.06, 0.5  # metres
DARK_RED = (0.6, 0.1, 0.1)


def drive():
    """Yield the number of poses and a copy of the map, for each panel."""
    simulation = Simulation(read_scene(SCENE))
    simulation.sensor.SetAlphaResolution(BEAMS)
    simulation.sensor.SetBetaResolution(TURNS)
    simulation.reconstruction.SetMaximumError(MAXIMUM_ERROR)
    fusion = vtkLMS3DMapFusion()
    fusion.SetMaximumError(MAXIMUM_ERROR)
    simulation.add_fusion(fusion)
    scans = TrajectoryScan(simulation, read_data(JOURNEY, "trajectory"))
    for _ in scans.run():
        done = len(scans.returns)
        if done in (*ON_THE_WAY, len(scans.times)):
            copy = vtkPolyData()
            copy.DeepCopy(simulation.fused_map)
            print(f"{done} poses: {copy.GetNumberOfCells():,} triangles", flush=True)
            yield done, copy


def add_panel(window, viewport, local_map, way, words):
    """Add a renderer with a map, the way of the sensor and a text."""
    renderer = vtkRenderer()
    renderer.SetViewport(*viewport)
    renderer.SetBackground(1, 1, 1)
    source = vtkTrivialProducer()
    source.SetOutput(local_map)
    renderer.AddActor(make_map_actor(source.GetOutputPort()))
    renderer.AddActor(make_line(way))
    marker = make_marker(MARKER)
    marker.SetPosition(*way[-1])
    heading = way[-1] - way[-2]
    marker.SetOrientation(0, 0, np.degrees(np.arctan2(heading[1], heading[0])))
    renderer.AddActor(marker)
    text = vtkTextActor()
    text.SetInput(words)
    text.SetPosition(12, 8)
    text.GetTextProperty().SetFontSize(20)
    text.GetTextProperty().SetColor(0.2, 0.2, 0.2)
    renderer.AddViewProp(text)
    add_lights(renderer)
    renderer.UseFXAAOn()
    window.AddRenderer(renderer)
    return renderer


def make_line(way):
    """The way as a tube."""
    points = vtkPoints()
    points.SetData(numpy_to_vtk(way, deep=True))
    line = vtkLineSource()
    line.SetPoints(points)
    tube = vtkTubeFilter()
    tube.SetInputConnection(line.GetOutputPort())
    tube.SetRadius(LINE_WIDTH)
    tube.SetNumberOfSides(8)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(tube.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*DARK_RED)
    return actor


def viewports():
    """The small panels above, from left to right, and the large one below."""
    count = len(ON_THE_WAY)
    return [*((i / count, LARGE, (i + 1) / count, 1) for i in range(count)), (0, 0, 1, LARGE)]


def main():
    """Drive, draw and save."""
    way = vtk_to_numpy(read_data(JOURNEY, "trajectory").GetPoints().GetData())
    corners = vtk_to_numpy(read_scene(SCENE).surface.GetPoints().GetData())
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(*SIZE)
    for (done, local_map), viewport in zip(drive(), viewports()):
        words = f"{done} poses, {local_map.GetNumberOfCells():,} triangles"
        renderer = add_panel(window, viewport, local_map, way[:done], words)
        width, height = SIZE[0] * (viewport[2] - viewport[0]), SIZE[1] * (viewport[3] - viewport[1])
        frame(renderer.GetActiveCamera(), corners, DIRECTION / np.linalg.norm(DIRECTION),
              width / height)
        renderer.ResetCameraClippingRange()
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.ShouldRerenderOff()
    grab.Update()
    save(grab.GetOutput(), PICTURE, "picture")


if __name__ == "__main__":
    main()
