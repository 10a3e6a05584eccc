# Builds and installs the ParaView plugin, which includes the VTK module.

# The Python interpreter has to be the one that ParaView uses.
find_program(Python3_EXECUTABLE NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH
  DOC "The Python interpreter that ParaView's Python modules were built for")

find_package(ParaView 5.11 REQUIRED COMPONENTS RemotingCore RemotingServerManager RemotingViews)

# Classes that need ParaView's window are left out if the headers of ParaView's Qt are missing. ParaView 5.11 does
# not name its Qt, which is Qt 5.
if (NOT PARAVIEW_QT_MAJOR_VERSION)
  set(PARAVIEW_QT_MAJOR_VERSION 5)
endif ()
set(qt "Qt${PARAVIEW_QT_MAJOR_VERSION}")
find_package(${qt} QUIET COMPONENTS Widgets)
if (TARGET ${qt}::Widgets AND TARGET ParaView::pqCore)
  set(TOPOLOGYCARVING_WINDOW ON)
  # find_package cannot request pqComponents and pqCore: their dependencies need packages on which
  # paraview-dev does not depend. The plugin uses none of these dependencies, so they are removed here.
  get_target_property(includes ParaView::qttesting INTERFACE_INCLUDE_DIRECTORIES)
  set_target_properties(ParaView::pqComponents ParaView::pqCore PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${includes}"
    INTERFACE_LINK_LIBRARIES      "${qt}::Widgets;$<TARGET_FILE:ParaView::RemotingViews>"
    IMPORTED_LINK_DEPENDENT_LIBRARIES_DEBUG "")
else ()
  set(TOPOLOGYCARVING_WINDOW OFF)
  message(WARNING "The headers of Qt ${PARAVIEW_QT_MAJOR_VERSION} were not found (Debian: qtbase5-dev or "
    "qt6-base-dev). The plugin will add nothing to ParaView's window: the button beside the progress bar will not "
    "stop a carving.")
endif ()

# The helper program is installed beside the plugin, and both in a component without ParaView's own rules, which install
# static libraries.
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME plugin)
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
