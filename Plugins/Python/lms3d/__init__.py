# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""A 3D laser range finder (a SICK LMS 200 on a rotating support), simulated with VTK.

Scan a mesh (metres; angles are in degrees, z is up) and look at the ranges, a numpy array:

    import lms3d

    scan = lms3d.scan((vertices, triangles), position=(0.3, -0.2, 1.0))
    print(scan.ranges.shape, scan.points.shape)

`scan` also accepts a vtkPolyData, `reconstruct` makes a local map of triangles from a scan, and
`FusedMap` joins the local maps of many scans to one map.
`scan(..., device="lms200-mm")` measures as an LMS 200 does, and `undistort` corrects the scan of a
sensor that moved meanwhile.

The classes are ordinary VTK algorithms: vtkVRMLImporterSource reads a scene, vtkLMS3DScanFilter
scans it, vtkLMS3DRangeErrorFilter gives the scan the errors of a real device,
vtkLMS3DSurfaceReconstructionFilter makes a local map from a scan, vtkLMS3DMapFusion joins such maps
to one, and vtkLMS3DMapComparison measures how far a map is from the scene. If LMS3D was built with
CORBA, vtkLMS3DRemoteSource shows the scans of a running server.
Importing the package needs no display. The same job from a shell:
``python3 -m lms3d scan room.wrl --position 0.3 -0.2 1 -o scan.vtp``.
"""

import sys

from . import _loading

try:
    from ._version import __version__  # noqa: F401

    _loading.check_vtk()
    # The wrapped modules need their base classes to be loaded first.
    from vtkmodules import vtkCommonDataModel, vtkCommonExecutionModel  # noqa: F401

    from .vtkLMS3DFilters import *  # noqa: F401,F403
    from .vtkLMS3DReaders import *  # noqa: F401,F403
    from .device import set_device  # noqa: F401
    from .fusion import FusedMap  # noqa: F401
    from .mesh import Mesh  # noqa: F401
    from .motion import undistort  # noqa: F401
    from .properties import DEVICES  # noqa: F401
    from .scanning import Scan, reconstruct, scan  # noqa: F401
except ImportError as error:
    raise ImportError(_loading.explain(error), name=error.name, path=error.path) from error
except KeyboardInterrupt:
    if sys.argv[:1] != ["-m"]:  # Python's value while `python3 -m lms3d` loads the package
        raise
    _loading.exit_interrupted()


def __getattr__(name):
    """Load the class that needs an ORB on first use.

    Programs that do not use it can load another ORB into the process.
    """
    if name == "vtkLMS3DRemoteSource":
        try:
            from .vtkLMS3DRemote import vtkLMS3DRemoteSource
        except ModuleNotFoundError as error:
            raise AttributeError(f"{error}: LMS3D was built without CORBA") from error
        return vtkLMS3DRemoteSource
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
