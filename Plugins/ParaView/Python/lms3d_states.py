# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the Python states that ParaView saves load the plugins that they need.

pqLMS3DPythonStates runs this code in the window's interpreter, so it leaves no names there.
"""


def _load_plugins_in_states():
    import functools

    from paraview import servermanager, smstate

    constructors = {
        "LMS3D": ("VRMLReader", "LMS3DScan", "LMS3DRangeError", "LMS3DSurfaceReconstruction",
                  "LMS3DMapComparison", "LMS3DMapFusion"),
        "LMS3DRemote": ("LMS3DRemote",),
    }
    start = "from paraview.simple import *\n"

    def list_files(information):
        return {information.GetPluginName(i): information.GetPluginFileName(i)
                for i in range(information.GetNumberOfPlugins()) if information.GetPluginLoaded(i)}

    def make_lines(state):
        manager = servermanager.vtkSMProxyManager.GetProxyManager().GetPluginManager()
        connection = servermanager.ActiveConnection
        local = list_files(manager.GetLocalInformation())
        remote = (list_files(manager.GetRemoteInformation(connection.Session))
                  if connection.IsRemote() else {})
        for plugin, names in constructors.items():
            if any(f" = {name}(" in state for name in names):
                if plugin in remote:
                    yield f"LoadPlugin({remote[plugin]!r}, remote=True, ns=globals())\n"
                if plugin in local:
                    yield f"LoadPlugin({local[plugin]!r}, remote=False, ns=globals())\n"

    plain_get_state = smstate.get_state

    @functools.wraps(plain_get_state)
    def get_state(*arguments, **options):
        state = plain_get_state(*arguments, **options)
        if not isinstance(state, str):
            return state
        before, line, after = state.partition(start)
        lines = "".join(make_lines(state)) if line else ""
        return f"{before}{line}\n# load the plugins of this state\n{lines}{after}" if lines else state

    smstate.get_state = get_state


_load_plugins_in_states()
del _load_plugins_in_states
