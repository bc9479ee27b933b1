# The ParaView plugin: client-server wrappers of the modules and the XML, nothing compiled twice.

paraview_plugin_scan(
  PLUGIN_FILES "${CMAKE_CURRENT_SOURCE_DIR}/Plugins/ParaView/paraview.plugin"
  PROVIDES_PLUGINS lms3d_plugins
  ENABLE_BY_DEFAULT ON
  HIDE_PLUGINS_FROM_CACHE ON)

paraview_plugin_build(
  PLUGINS ${lms3d_plugins}
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  LIBRARY_SUBDIRECTORY "${PARAVIEW_PLUGIN_SUBDIR}")
