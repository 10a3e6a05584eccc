# Builds and installs the plugin for ParaView, with the VTK module as a part of it.

# Its Python has to be that of ParaView.
find_program(Python3_EXECUTABLE NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH
  DOC "The Python interpreter that ParaView's Python modules were built for")

find_package(ParaView 5.11 REQUIRED COMPONENTS RemotingCore RemotingServerManager RemotingViews)

# What needs ParaView's window is left out where there are no headers of Qt.
find_package(Qt5 QUIET COMPONENTS Widgets)
if (TARGET Qt5::Widgets AND TARGET ParaView::pqCore)
  set(TOPOLOGYCARVING_WINDOW ON)
  # These cannot be asked for above: what they depend on wants packages that paraview-dev does not bring
  # along. It is not needed for what is used of them.
  get_target_property(includes ParaView::qttesting INTERFACE_INCLUDE_DIRECTORIES)
  set_target_properties(ParaView::pqComponents ParaView::pqCore PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${includes}"
    INTERFACE_LINK_LIBRARIES      "Qt5::Widgets;$<TARGET_FILE:ParaView::RemotingViews>"
    IMPORTED_LINK_DEPENDENT_LIBRARIES_DEBUG "")
else ()
  set(TOPOLOGYCARVING_WINDOW OFF)
  message(WARNING "The plugin will not add to ParaView's window: its button beside the progress bar will "
    "not stop a carving. That takes Qt 5's headers (on Debian, the package qtbase5-dev).")
endif ()

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
