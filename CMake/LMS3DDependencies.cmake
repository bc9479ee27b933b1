# The packages that LMS3D depends on. Every find_package names components: without them VTK and ParaView
# search for Qt, HDF5 and all other libraries that Debian built them with.

if (LMS3D_BUILD_PARAVIEW_PLUGIN OR LMS3D_USE_PARAVIEW_VTK)
  include(LMS3DDebianParaView)
  lms3d_mend_debian_paraview("")
endif ()

if (LMS3D_BUILD_PARAVIEW_PLUGIN)
  # Also sets VTK_DIR to the VTK that ParaView was built with.
  find_package(ParaView 5.11 REQUIRED COMPONENTS RemotingCore RemotingServerManager)
  # Check Qt first: if it is missing, ParaView's component for windows stops CMake with an error.
  if (PARAVIEW_QT_MAJOR_VERSION GREATER 5)
    set(LMS3D_QT Qt${PARAVIEW_QT_MAJOR_VERSION})
    find_package(${LMS3D_QT} QUIET COMPONENTS Core Core5Compat Gui Help OpenGLWidgets Svg Widgets)
    find_package(${LMS3D_QT} QUIET OPTIONAL_COMPONENTS ToolsTools)
  else () # ParaView before 5.13 does not set the variable
    set(LMS3D_QT Qt5)
    find_package(${LMS3D_QT} QUIET COMPONENTS Core Gui Help OpenGL Svg Widgets)
  endif ()
  set(LMS3D_PARAVIEW_WINDOW ${${LMS3D_QT}_FOUND})
  if (LMS3D_PARAVIEW_WINDOW)
    # ParaView's windows link libraries whose headers LMS3D does not include, and Debian's package of
    # ParaView does not depend on their development packages. Empty targets replace them. The targets
    # are not global: a project that adds LMS3D as a subdirectory does not see them.
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
elseif (LMS3D_USE_PARAVIEW_VTK)
  # The smallest component: the call only has to set VTK_DIR.
  find_package(ParaView 5.11 REQUIRED COMPONENTS WrapClientServer)
endif ()

# Public dependencies of the two modules, and so of every program that links them.
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
    FiltersFlowPaths FiltersGeneral FiltersSources IOXML ImagingHybrid TestingCore)
endif ()
find_package(VTK 9.1 REQUIRED COMPONENTS ${LMS3D_VTK_COMPONENTS})

# Headers alone, without CMake files of their own.
find_path(LMS3D_RANDOM123_INCLUDE_DIR Random123/threefry.h
  DOC "The folder that has Random123/threefry.h")
if (NOT LMS3D_RANDOM123_INCLUDE_DIR)
  message(FATAL_ERROR "Random123 is missing. Install librandom123-dev, or set "
    "LMS3D_RANDOM123_INCLUDE_DIR to the folder that has Random123/threefry.h.")
endif ()
mark_as_advanced(LMS3D_RANDOM123_INCLUDE_DIR)

if (LMS3D_BUILD_CORBA)
  find_package(omniORB4 4.2 REQUIRED)
endif ()

if (BUILD_TESTING)
  find_package(GTest REQUIRED)
endif ()
