# The packages that LMS3D stands on. Naming components keeps VTK from asking for Qt, HDF5 and
# whatever else a complete VTK was built with.

if (LMS3D_BUILD_PARAVIEW_PLUGIN)
  # Also sets VTK_DIR to the VTK that ParaView was built with.
  find_package(ParaView 5.11 REQUIRED COMPONENTS RemotingCore RemotingServerManager)
endif ()

# What the two modules stand on, and so whatever links to them.
set(LMS3D_VTK_MODULES
  CommonCore CommonDataModel CommonExecutionModel CommonMisc FiltersCore FiltersGeometry IOImport
  RenderingCore)
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
