# Builds and installs the plugin for ParaView, with the VTK module as a part of it.

# Its Python has to be that of ParaView.
find_program(Python3_EXECUTABLE NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH
  DOC "The Python interpreter that ParaView's Python modules were built for")

find_package(ParaView 5.11 REQUIRED COMPONENTS RemotingCore RemotingServerManager RemotingViews)

# The helper program lies beside the plugin.
set(TOPOLOGYCARVING_LIBRARY_DESTINATION
  "${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/TopologyCarving")
set(TOPOLOGYCARVING_HELPER_DESTINATION "${TOPOLOGYCARVING_LIBRARY_DESTINATION}")

paraview_plugin_scan(
  PLUGIN_FILES      "${CMAKE_CURRENT_LIST_DIR}/paraview.plugin"
  PROVIDES_PLUGINS  plugins
  ENABLE_BY_DEFAULT ON)
paraview_plugin_build(
  PLUGINS                   ${plugins}
  AUTOLOAD                  ${plugins}
  PLUGINS_FILE_NAME         "topologycarving.plugins.xml"
  RUNTIME_DESTINATION       "${CMAKE_INSTALL_BINDIR}"
  LIBRARY_DESTINATION       "${CMAKE_INSTALL_LIBDIR}"
  LIBRARY_SUBDIRECTORY      "${PARAVIEW_PLUGIN_SUBDIR}"
  HEADERS_DESTINATION       "${CMAKE_INSTALL_INCLUDEDIR}/topologycarving"
  DISABLE_XML_DOCUMENTATION ON)
