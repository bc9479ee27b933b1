# The packages that LMS3D stands on. Naming components keeps VTK from asking for Qt, HDF5 and
# whatever else a complete VTK was built with.

if (LMS3D_BUILD_PARAVIEW_PLUGIN)
  # ParaView's component for windows is an error, not missing, where one of these is not there.
  find_package(Qt5 QUIET COMPONENTS Core Gui Help OpenGL Svg Widgets)
  set(LMS3D_PARAVIEW_WINDOW ${Qt5_FOUND})
  set(components RemotingCore RemotingServerManager)
  if (LMS3D_PARAVIEW_WINDOW)
    list(APPEND components RemotingViews pqApplicationComponents)
    # Far below ParaView's windows are libraries whose headers nobody here includes. Debian's ParaView
    # names their packages without depending on them; empty ones save a user from installing them.
    foreach (target IN ITEMS Boost::boost LibXml2::LibXml2 NetCDF::NetCDF hdf5::hdf5
        hdf5::hdf5_hl)
      add_library(${target} INTERFACE IMPORTED)
    endforeach ()
  else ()
    message(STATUS "No Qt 5: the ParaView plugin gets neither icons nor the widget for the pose")
  endif ()
  # Also sets VTK_DIR to the VTK that ParaView was built with.
  find_package(ParaView 5.11 REQUIRED COMPONENTS ${components})
endif ()

# What the two modules stand on, and so whatever links to them.
set(LMS3D_VTK_MODULES
  CommonCore CommonDataModel CommonExecutionModel CommonMisc FiltersCore FiltersGeometry IOImport
  ParallelCore RenderingCore)
set(LMS3D_VTK_COMPONENTS ${LMS3D_VTK_MODULES})
if (LMS3D_BUILD_PYTHON)
  list(APPEND LMS3D_VTK_COMPONENTS Python WrappingPythonCore)
endif ()
if (BUILD_TESTING)
  list(APPEND LMS3D_VTK_COMPONENTS FiltersGeneral FiltersSources ImagingHybrid TestingCore)
endif ()
find_package(VTK 9.1 REQUIRED COMPONENTS ${LMS3D_VTK_COMPONENTS})

if (BUILD_TESTING)
  find_package(GTest REQUIRED)
endif ()
