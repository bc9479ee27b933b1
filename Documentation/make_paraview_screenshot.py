#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Make pictures of ParaView's window with a sensor and its local map in images/.

paraview.png shows Data/example.pvsm, paraview_steps.png the three steps of README.md, and
paraview_journey.png a moving sensor.

    xvfb-run -a -s "-noreset -screen 0 1152x762x24" ./run python Documentation/make_paraview_screenshot.py

ParaView also runs this script, by its option --script, to fill the window. Pillow (python3-pil)
takes the picture; Debian installs it with ParaView.
"""

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

READY, PICTURE = "LMS3D_SCREENSHOT_READY", "LMS3D_SCREENSHOT"
TIMEOUT, SETTLING_TIME = 60.0, 3.0  # seconds


def load_example(simple):
    """A sensor at a fixed position, as File > Load State shows it."""
    simple.LoadState("example.pvsm")
    return simple.FindSource("LMS3DScan1")


def show_steps(simple):
    """The three steps, with the sensor at the position where the window puts it."""
    room = simple.VRMLReader(registrationName="room.wrl", FileName="room.wrl")
    view = simple.GetActiveViewOrCreate("RenderView")
    simple.Show(room, view)
    simple.ResetCamera(view)
    simple.Hide(room, view)
    scan = simple.LMS3DScan(registrationName="LMS3DScan1", Input=room, Position=[1.475, 0.07, 1.0])
    local_map = simple.LMS3DSurfaceReconstruction(
        registrationName="LMS3DSurfaceReconstruction1", Input=scan)
    simple.Show(local_map, view)
    return scan


def show_journey(simple):
    """The sensor in the doorway, its trajectory, and the map from above without the ceiling."""
    room = simple.VRMLReader(registrationName="room.wrl", FileName="room.wrl")
    journey = simple.XMLPolyDataReader(registrationName="journey.vtp", FileName=["journey.vtp"])
    view = simple.GetActiveViewOrCreate("RenderView")
    simple.Show(journey, view).LineWidth = 3
    scan = simple.LMS3DScan(registrationName="LMS3DScan1", Input=room, Trajectory=journey)
    simple.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
    simple.GetAnimationScene().AnimationTime = 12
    local_map = simple.LMS3DSurfaceReconstruction(
        registrationName="LMS3DSurfaceReconstruction1", Input=scan)
    simple.Show(local_map, view).BackfaceRepresentation = "Cull Backface"
    view.CameraPosition = [-1.6, -5.6, 8.9]
    view.CameraFocalPoint = [1.0, 0.0, 0.6]
    view.CameraViewUp = [0, 0, 1]
    return scan


PICTURES = {
    "paraview": load_example, "paraview_steps": show_steps, "paraview_journey": show_journey}


def fill_window():
    """Inside ParaView: show the pipeline and select the scan."""
    from paraview import simple

    scan = PICTURES[os.environ[PICTURE]](simple)
    simple.SetActiveSource(scan)
    simple.ShowInteractiveWidgets(proxy=scan)
    simple.Render()
    Path(os.environ[READY]).touch()


def start_paraview(script, name, folder):
    """ParaView with the plugin, a new configuration, and small letters so that the panel fits."""
    root = script.parents[1]
    (plugin,) = root.glob("build/lib*/**/plugins/LMS3D/LMS3D.so")
    environment = dict(
        os.environ, HOME=folder, XDG_CONFIG_HOME=folder, QT_FONT_DPI="72",
        LIBGL_ALWAYS_SOFTWARE="1")
    environment.update({READY: f"{folder}/ready", PICTURE: name})
    return subprocess.Popen(
        ["paraview", "--dr", f"--plugin-search-paths={plugin.parent}", "--plugins=LMS3D",
         f"--script={script}"],
        cwd=root / "Data", env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def wait_for(file, process):
    """Wait until the file exists; exit if ParaView ends or takes too long."""
    end = time.monotonic() + TIMEOUT
    while not file.exists():
        if process.poll() is not None or time.monotonic() > end:
            sys.exit("ParaView did not show the scan; does ./run paraview work?")
        time.sleep(0.1)
    time.sleep(SETTLING_TIME)


def take_picture(script, name):
    """Start ParaView on the screen DISPLAY and save a picture of the screen."""
    from PIL import ImageGrab

    picture = script.parent / "images" / f"{name}.png"
    with tempfile.TemporaryDirectory() as folder:
        process = start_paraview(script, name, folder)
        try:
            wait_for(Path(folder) / "ready", process)
            screen = ImageGrab.grab(xdisplay=os.environ["DISPLAY"])
        finally:
            process.kill()
            process.wait()
    screen.save(picture, optimize=True)
    print(picture)


def main():
    """Start ParaView for each picture."""
    for name in PICTURES:
        take_picture(Path(__file__).resolve(), name)


if READY in os.environ:
    fill_window()
else:
    main()
