# The ParaView plugins: client-server wrappers of the modules, and XML. No source is compiled twice.

# A program of Qt 5 makes the help pages from the XML, for windows of Qt 6, too. ParaView finds the
# program through this variable.
set(LMS3D_PARAVIEW_HELP OFF)
if (LMS3D_PARAVIEW_WINDOW)
  find_program(qt_xmlpatterns_executable NAMES xmlpatterns
    HINTS /usr/lib/qt5/bin NO_DEFAULT_PATH)
  if (qt_xmlpatterns_executable AND TARGET ${LMS3D_QT}::qhelpgenerator)
    set(LMS3D_PARAVIEW_HELP ON)
  endif ()
endif ()

set(plugin_files "${CMAKE_CURRENT_SOURCE_DIR}/Plugins/ParaView/paraview.plugin")
if (LMS3D_BUILD_CORBA)
  list(APPEND plugin_files "${CMAKE_CURRENT_SOURCE_DIR}/Plugins/CORBA/ParaView/paraview.plugin")
endif ()
paraview_plugin_scan(
  PLUGIN_FILES ${plugin_files}
  PROVIDES_PLUGINS lms3d_plugins
  ENABLE_BY_DEFAULT ON
  HIDE_PLUGINS_FROM_CACHE ON)

paraview_plugin_build(
  PLUGINS ${lms3d_plugins}
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  LIBRARY_SUBDIRECTORY "${PARAVIEW_PLUGIN_SUBDIR}")
