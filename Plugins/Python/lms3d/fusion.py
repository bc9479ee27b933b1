# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""One map of many scans, with numpy arrays."""

from vtkmodules.vtkCommonDataModel import vtkPolyData

from .arguments import to_bound, to_count
from .interruption import abortable
from .mesh import from_vtk
from .messages import VTKMessages
from .problems import Problem
from .properties import MAXIMUM_THREADS
from .scanning import make_map
from .vtkLMS3DFilters import vtkLMS3DMapFusion


class FusedMap:
    """One map of triangles that grows with each scan.

        fused = lms3d.FusedMap(maximum_error=0.02)
        for position in positions:
            fused.add(lms3d.scan(mesh, position))
        vertices, triangles = fused.mesh

    maximum_error: bound on the distance from the map of every return that its local map explains,
        metres, above 0.
    depth_step, maximum_gap_size, maximum_speckle_size, keep_speckles: of the local map that is made
        from each scan, as for `reconstruct`.
    keep_returns: whether the ranges of all scans are kept, four bytes for each beam, so that what a
        later scan guesses between its returns is checked against the beams of earlier ones.
    forget_seen_through: whether surface is taken out if beams of a later scan pass through it.
    threads: 1 to 1024; 0 stands for all cores. The result does not depend on it.

    If scans have no status, beams without a return count as beams that met nothing, and the map opens
    there. So the scans of a device that loses beams, or has a minimum range, need it:
    `lms3d.scan(..., status=True)`.

    Raises ValueError if an argument is invalid. `filter` is the vtkLMS3DMapFusion, with all arrays.
    """

    def __init__(self, *, maximum_error=0.01, depth_step=0.1, maximum_gap_size=-1,
                 maximum_speckle_size=0, keep_speckles=True, keep_returns=True,
                 forget_seen_through=False, threads=0):
        self._of_each_map = {
            "maximum_error": maximum_error, "depth_step": depth_step,
            "maximum_gap_size": maximum_gap_size, "maximum_speckle_size": maximum_speckle_size,
            "keep_speckles": keep_speckles}
        bound = to_bound("maximum_error", maximum_error)
        if bound == 0:
            raise ValueError("maximum_error must be above 0")
        self.filter = vtkLMS3DMapFusion()
        self.filter.SetMaximumError(bound)
        self.filter.SetKeepReturns(bool(keep_returns))
        self.filter.SetForgetSeenThrough(bool(forget_seen_through))
        self.filter.SetNumberOfThreads(to_count("threads", threads, 0, MAXIMUM_THREADS))

    def add(self, scan):
        """Join the local map of a Scan to the map.

        Raises ValueError if the scan is invalid; the map is then as before. If Ctrl-C ends this, the map
        loses all scans.
        """
        local_map = make_map(scan, self._of_each_map)
        with VTKMessages() as messages, abortable(self.filter):
            self.filter.AddScan(local_map, scan.poly)
        try:
            messages.report("cannot join the map of this scan to the others")
        except Problem as problem:
            raise ValueError(str(problem)) from None

    @property
    def poly(self):
        """The map as vtkPolyData, with the arrays of vtkLMS3DMapFusion."""
        self.filter.Update()
        return self.filter.GetOutput()

    @property
    def mesh(self):
        """The map as a Mesh."""
        return from_vtk(self.poly)

    @property
    def revision(self):
        """A number that grows with each scan."""
        return self.filter.GetRevision()

    def changes(self, since):
        """What changed after a revision, as vtkPolyData.

        It has the triangles of all regions that changed. Who has the map of that revision removes the
        triangles whose RegionId is in the field data ChangedRegions, and adds these.
        """
        changed = vtkPolyData()
        self.filter.GetChanges(to_count("since", since, 0), changed)
        return changed
