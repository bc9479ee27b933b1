# The packages that LMS3D stands on. Naming components keeps VTK from asking for Qt, HDF5 and
# whatever else a complete VTK was built with.

if (LMS3D_BUILD_PARAVIEW_PLUGIN)
  # Also sets VTK_DIR to the VTK that ParaView was built with.
  find_package(ParaView 5.11 REQUIRED COMPONENTS RemotingCore RemotingServerManager)
  # The component for windows is an error, not missing, where one of its libraries is not there.
  if (PARAVIEW_QT_MAJOR_VERSION GREATER 5)
    set(LMS3D_QT Qt${PARAVIEW_QT_MAJOR_VERSION})
    find_package(${LMS3D_QT} QUIET COMPONENTS Core Core5Compat Gui Help OpenGLWidgets Svg Widgets)
    find_package(${LMS3D_QT} QUIET OPTIONAL_COMPONENTS ToolsTools)
  else () # ParaView before 5.13 does not tell
    set(LMS3D_QT Qt5)
    find_package(${LMS3D_QT} QUIET COMPONENTS Core Gui Help OpenGL Svg Widgets)
  endif ()
  set(LMS3D_PARAVIEW_WINDOW ${${LMS3D_QT}_FOUND})
  if (LMS3D_PARAVIEW_WINDOW)
    # Far below ParaView's windows are libraries whose headers nobody here includes. Debian's ParaView
    # names their packages without depending on them; empty ones save a user from installing them.
    foreach (target IN ITEMS Boost::boost LibXml2::LibXml2 NetCDF::NetCDF hdf5::hdf5
        hdf5::hdf5_hl Freetype::Freetype)
      if (NOT TARGET ${target})
        add_library(${target} INTERFACE IMPORTED)
      endif ()
    endforeach ()
    find_package(ParaView 5.11 REQUIRED COMPONENTS RemotingViews pqApplicationComponents)
  else ()
    message(STATUS "No ${LMS3D_QT}: the ParaView plugin gets neither icons nor the widget for the pose")
  endif ()
endif ()

# What the two modules stand on, and so whatever links to them.
set(LMS3D_VTK_MODULES
  CommonCore CommonDataModel CommonExecutionModel CommonMisc FiltersCore FiltersGeometry IOImport
  ParallelCore RenderingCore)
set(LMS3D_VTK_COMPONENTS ${LMS3D_VTK_MODULES})
if (LMS3D_BUILD_PYTHON)
  list(APPEND LMS3D_VTK_COMPONENTS Python WrappingPythonCore)
endif ()
if (LMS3D_BUILD_CORBA)
  list(APPEND LMS3D_VTK_COMPONENTS IOXML)
endif ()
if (BUILD_TESTING)
  list(APPEND LMS3D_VTK_COMPONENTS
    FiltersFlowPaths FiltersGeneral FiltersSources ImagingHybrid TestingCore)
endif ()
find_package(VTK 9.1 REQUIRED COMPONENTS ${LMS3D_VTK_COMPONENTS})

if (LMS3D_BUILD_CORBA)
  find_package(omniORB4 4.2 REQUIRED)
endif ()

if (BUILD_TESTING)
  find_package(GTest REQUIRED)
endif ()
