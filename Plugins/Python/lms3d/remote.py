# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Connects to a running server: its scan, its local map and its sensor's pose."""

import time

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonTransforms import vtkTransform

from .messages import VTKMessages
from .problems import Problem

_FIRST_SCAN_TIMEOUT = 10.0  # seconds


class RemoteScanner:
    """The newest scan of the server at a URL, fetched by vtkLMS3DRemoteSource.

    Raises Problem if LMS3D was built without CORBA, or if the server sends no scan.
    """

    def __init__(self, url):
        try:
            from . import vtkLMS3DRemoteSource  # loads the ORB
        except ImportError as error:
            raise Problem("cannot show a server: this LMS3D was built without CORBA; install "
                          "omniORB and build again") from error
        self.source = vtkLMS3DRemoteSource()
        self.source.SetURL(url)
        self._wait_for_first()
        if self.returns == 0:
            reason = self.source.GetProblem() or "the server has no scan with any return"
            raise Problem(f"nothing to show from '{url}': {reason}")

    def _wait_for_first(self):
        end = time.monotonic() + _FIRST_SCAN_TIMEOUT
        self.update()
        while self.returns == 0 and not self.problem and time.monotonic() < end:
            time.sleep(0.05)
            if self.has_news():
                self.update()

    def update(self):
        """Take the newest fetched scan. If fetching failed, `problem` says why."""
        with VTKMessages():
            self.source.Update()

    def has_news(self):
        """Whether an update would bring a new scan."""
        return self.source.GetNeedsUpdate()

    @property
    def scan(self):
        """The returns as vtkPolyData, one vertex each."""
        return self.source.GetOutput()

    @property
    def returns(self):
        """Number of returns."""
        return self.scan.GetNumberOfPoints()

    @property
    def problem(self):
        """Why fetching failed; empty if it did not."""
        return self.source.GetProblem()

    @property
    def number(self):
        """The number of the scan since the server started."""
        return self.scan.GetFieldData().GetArray("ScanNumber").GetValue(0)

    def fetch_fused_map(self, is_wanted):
        """Begin or end to fetch the server's map of all poses, the third output of the source."""
        self.source.SetFetchFusedMap(is_wanted)

    @property
    def fused_scans(self):
        """The number of scans in the server's map of all poses; 0 without this map."""
        scans = self.source.GetFusedMap().GetFieldData().GetArray("NumberOfScans")
        return scans.GetValue(0) if scans else 0

    @property
    def fused_triangles(self):
        """The number of triangles of this map."""
        return self.source.GetFusedMap().GetNumberOfCells()

    def pose(self):
        """The sensor's position (metres) and orientation (degrees, as in vtkProp3D)."""
        transform = vtkTransform()
        matrix = self.scan.GetFieldData().GetArray("SensorToWorld")
        transform.SetMatrix(vtk_to_numpy(matrix).ravel())
        return transform.GetPosition(), transform.GetOrientation()

    def send_pose(self, position, orientation):
        """Move the server's sensor: its next scan is made from there."""
        self.source.SetPosition(position)
        self.source.SetOrientation(orientation)
        self.source.SendPose()

    @property
    def is_pose_pending(self):
        """Whether a pose was sent and accepted, and its scan has not arrived yet."""
        return self.source.IsPosePending()
