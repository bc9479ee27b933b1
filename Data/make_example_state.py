# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Make example.pvsm: a scan of the room and its local map, for ParaView's File > Load State.

    pvpython Data/make_example_state.py PLUGIN

PLUGIN is the file LMS3D.so. The state names its scene as room.wrl, without a folder, so ParaView
finds it if it is started in this folder.
"""

import os
import sys
from pathlib import Path

from paraview import simple

plugin = os.path.abspath(sys.argv[1])
os.chdir(Path(__file__).parent)
simple.LoadPlugin(plugin, remote=False, ns=globals())

room = VRMLReader(registrationName="room.wrl", FileName="room.wrl")
scan = LMS3DScan(registrationName="LMS3DScan1", Input=room, Position=[0.3, -0.2, 1.0])
local_map = LMS3DSurfaceReconstruction(registrationName="LMS3DSurfaceReconstruction1", Input=scan)

view = simple.CreateRenderView()
layout = simple.CreateLayout("Example")
layout.AssignView(0, view)
shown = simple.Show(local_map, view)
simple.ColorBy(shown, None)
shown.DiffuseColor = shown.AmbientColor = [0.2, 0.7, 0.3]
shown.BackfaceRepresentation = "Cull Backface"  # hides the ceiling
points = simple.Show(scan, view)
points.Visibility = 0
view.CameraPosition = [-3.5, -9.8, 15.1]
view.CameraFocalPoint = [1.0, 0.0, 0.6]
view.CameraViewUp = [0, 0, 1]
simple.SetActiveSource(scan)
simple.SaveState("example.pvsm")
