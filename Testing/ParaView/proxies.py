# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""What tests in pvpython share."""


def algorithm(proxy):
    """The VTK filter behind a proxy."""
    return proxy.SMProxy.GetClientSideObject()
