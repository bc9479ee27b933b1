# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""A running server instead of a simulation: its scan, its local map and its sensor's pose."""

import time

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonTransforms import vtkTransform

from .messages import VTKMessages
from .problems import Problem

_PATIENCE = 10.0  # seconds for a server's first scan


class RemoteScanner:
    """The newest scan of the server at a URL, as vtkLMS3DRemoteSource takes one.

    Raises Problem where LMS3D was built without CORBA, or no scan comes.
    """

    def __init__(self, url):
        try:
            from . import vtkLMS3DRemoteSource  # with the ORB
        except ImportError as error:
            raise Problem("cannot watch a server: this LMS3D was built without CORBA; build it where "
                          "omniORB is installed") from error
        self.source = vtkLMS3DRemoteSource()
        self.source.SetURL(url)
        self._wait_for_first()
        if self.returns == 0:
            reason = self.source.GetProblem() or "the server has no scan with any return"
            raise Problem(f"nothing to show from '{url}': {reason}")

    def _wait_for_first(self):
        end = time.monotonic() + _PATIENCE
        self.update()
        while self.returns == 0 and not self.problem and time.monotonic() < end:
            time.sleep(0.05)
            if self.has_news():
                self.update()

    def update(self):
        """Take what has been fetched; `problem` tells what was not."""
        with VTKMessages():
            self.source.Update()

    def has_news(self):
        """Whether an update would bring any."""
        return self.source.GetNeedsUpdate()

    @property
    def scan(self):
        """The returns as vtkPolyData, one vertex each."""
        return self.source.GetOutput()

    @property
    def returns(self):
        """Number of beams that came back."""
        return self.scan.GetNumberOfPoints()

    @property
    def problem(self):
        """Why there is no newer scan, empty where there is."""
        return self.source.GetProblem()

    @property
    def number(self):
        """The number of the scan, from the server's start."""
        return self.scan.GetFieldData().GetArray("ScanNumber").GetValue(0)

    def pose(self):
        """The sensor's position (metres) and orientation (degrees, as VTK's props have it)."""
        transform = vtkTransform()
        transform.SetMatrix(vtk_to_numpy(self.scan.GetFieldData().GetArray("SensorToWorld")).ravel())
        return transform.GetPosition(), transform.GetOrientation()

    def send_pose(self, position, orientation):
        """Have the next scan made from there."""
        self.source.SetPosition(position)
        self.source.SetOrientation(orientation)
        self.source.SendPose()

    @property
    def is_pose_pending(self):
        """Whether a pose was sent, not refused, and no scan has come from there."""
        return self.source.IsPosePending()
