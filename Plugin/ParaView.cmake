# Builds and installs the plugin for ParaView, with the VTK module as a part of it.

# Its Python has to be that of ParaView.
find_program(Python3_EXECUTABLE NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH
  DOC "The Python interpreter that ParaView's Python modules were built for")

find_package(ParaView 5.11 REQUIRED COMPONENTS RemotingCore RemotingServerManager RemotingViews)

# What needs ParaView's window is left out where there are no headers of Qt.
find_package(Qt5 QUIET COMPONENTS Widgets)
if (TARGET Qt5::Widgets AND TARGET ParaView::pqCore)
  set(TOPOLOGYCARVING_WINDOW ON)
  # Debian's packages for development name dependencies of ParaView's window that they do not bring along,
  # which is why pqCore cannot be asked for above. Nothing of them is used here.
  foreach (target IN ITEMS
      Boost::boost LibXml2::LibXml2 NetCDF::NetCDF Qt5::OpenGL hdf5::hdf5 hdf5::hdf5_hl)
    if (NOT TARGET "${target}")
      add_library("${target}" INTERFACE IMPORTED)
    endif ()
  endforeach ()
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
