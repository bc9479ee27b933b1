#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Make images/paraview.png, ParaView's window with the room's map and the sensor in hand, and
images/paraview_journey.png, the same with a sensor on its way.

    xvfb-run -a -s "-noreset -screen 0 1152x762x24" ./run python Documentation/make_paraview_screenshot.py

ParaView runs this script as well, by its option --script, to fill the window. Pillow (python3-pil)
takes the picture; Debian installs it along with ParaView.
"""

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

READY, PICTURE, DATA = "LMS3D_SCREENSHOT_READY", "LMS3D_SCREENSHOT", "LMS3D_DATA_DIR"
PATIENCE, SETTLING = 60.0, 3.0


def show_sensor(simple, room):
    """A sensor that stands still."""
    return simple.LMS3DScan(registrationName="LMS3DScan1", Input=room, Position=[0.3, -0.2, 1.0],
                            Orientation=[0, 0, 30])


def show_journey(simple, room):
    """The sensor in the doorway, and all its way."""
    journey = simple.XMLPolyDataReader(
        registrationName="journey.vtp", FileName=[f"{os.environ[DATA]}/journey.vtp"])
    simple.Show(journey).LineWidth = 3
    scan = simple.LMS3DScan(registrationName="LMS3DScan1", Input=room, Trajectory=journey)
    simple.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
    simple.GetAnimationScene().AnimationTime = 12
    return scan


PICTURES = {"paraview": show_sensor, "paraview_journey": show_journey}


def fill_window():
    """Inside ParaView: the map of the room, seen from above and without its ceiling."""
    from paraview import simple

    room = simple.VRMLReader(registrationName="room.wrl", FileName=f"{os.environ[DATA]}/room.wrl")
    scan = PICTURES[os.environ[PICTURE]](simple, room)
    local_map = simple.LMS3DSurfaceReconstruction(
        registrationName="LMS3DSurfaceReconstruction1", Input=scan)

    view = simple.GetActiveViewOrCreate("RenderView")
    display = simple.Show(local_map, view)
    display.BackfaceRepresentation = "Cull Backface"
    view.CameraPosition = [-1.6, -5.6, 8.9]
    view.CameraFocalPoint = [1.0, 0.0, 0.6]
    view.CameraViewUp = [0, 0, 1]
    simple.SetActiveSource(scan)
    simple.ShowInteractiveWidgets(proxy=scan)
    simple.Render(view)
    Path(os.environ[READY]).touch()


def start_paraview(script, name, folder):
    """ParaView with the plugin, a fresh configuration and small letters, so that the panel fits."""
    root = script.parents[1]
    (plugin,) = root.glob("build/lib*/**/plugins/LMS3D/LMS3D.so")
    environment = dict(
        os.environ, HOME=folder, XDG_CONFIG_HOME=folder, QT_FONT_DPI="72",
        LIBGL_ALWAYS_SOFTWARE="1")
    environment.update({READY: f"{folder}/ready", PICTURE: name, DATA: str(root / "Data")})
    return subprocess.Popen(
        ["paraview", "--dr", f"--plugin-search-paths={plugin.parent}", "--plugins=LMS3D",
         f"--script={script}"],
        env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def wait_for(file, process):
    """Until the file is there; an error where ParaView ends or takes too long."""
    end = time.monotonic() + PATIENCE
    while not file.exists():
        if process.poll() is not None or time.monotonic() > end:
            sys.exit("ParaView did not show the scan; does ./run paraview work?")
        time.sleep(0.1)
    time.sleep(SETTLING)


def take_picture(script, name):
    """Start ParaView on the screen DISPLAY and save what the screen shows."""
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
    """One ParaView for each picture."""
    for name in PICTURES:
        take_picture(Path(__file__).resolve(), name)


if READY in os.environ:
    fill_window()
else:
    main()
