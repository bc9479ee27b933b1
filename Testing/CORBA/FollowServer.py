# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Follows a server in a script: `pvpython FollowServer.py PLUGIN URL`.

Prints the number of each scan and the x coordinate of its sensor.
"""

import sys

from paraview import servermanager, simple

PLUGIN, URL = sys.argv[1:]
simple.LoadPlugin(PLUGIN, remote=False, ns=globals())


def report(proxy, *time):
    """Print what the proxy's output has, at a time of an animation or without one."""
    proxy.UpdatePipeline(*time)
    fields = servermanager.Fetch(proxy).GetFieldData()
    print(fields.GetArray("ScanNumber").GetValue(0), fields.GetArray("SensorToWorld").GetValue(3),
          flush=True)


remote = LMS3DRemote(URL=URL, Timeout=20)
report(remote)
for _ in range(3):
    remote.Refresh()
    report(remote)

# A server has one time. An update with any time gives the newest scan.
for time in (5.0, 1.0):
    remote.Refresh()
    report(remote, time)

remote.Position = [1.25, 0.5, 1.5]
remote.SendPose()
remote.Refresh()
report(remote)

# Filters behind the source follow, too.
elevation = simple.Elevation(Input=remote)
remote.Refresh()
report(elevation)
