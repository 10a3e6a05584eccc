# Debian packages, made by Packaging/make.sh: topologycarving, topologycarving-dev and python3-topologycarving, or
# paraview-topologycarving if the plugin is built. Each of them is an install component.
if (NOT CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  message(FATAL_ERROR "Files of packages are in folders of /usr: set CMAKE_INSTALL_PREFIX to /usr.")
endif ()
set(packaging "${CMAKE_CURRENT_LIST_DIR}")

if (TOPOLOGYCARVING_PARAVIEW)
  set(packages plugin paraview-topologycarving)
  # ParaView loads the plugins of the list paraview.conf when it starts.
  set(plugins "${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}")
  get_filename_component(list_folder "${plugins}" DIRECTORY)
  set(plugin_list "/usr/${list_folder}/paraview.conf")
  execute_process(COMMAND dpkg-divert --truename "${plugin_list}"
    OUTPUT_VARIABLE packaged_list OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  if (EXISTS "${packaged_list}")
    # The package paraview of Debian 13 has this list, which is diverted and replaced by a longer one.
    file(READ "${packaged_list}" list_text)
    string(APPEND list_text "plugins/topologycarving.plugins.xml\n")
    foreach (script IN ITEMS preinst postrm)
      configure_file("${packaging}/${script}.in" "${CMAKE_BINARY_DIR}/${script}" @ONLY)
      list(APPEND CPACK_DEBIAN_PLUGIN_PACKAGE_CONTROL_EXTRA "${CMAKE_BINARY_DIR}/${script}")
    endforeach ()
  else ()
    # On Debian 12, the list is beside the programs. It replaces the plugins that ParaView knows itself, so both are in it.
    set(list_folder "${CMAKE_INSTALL_BINDIR}")
    set(list_text "../${plugins}/paraview.plugins.xml\n../${plugins}/topologycarving.plugins.xml\n")
  endif ()
  file(WRITE "${CMAKE_BINARY_DIR}/paraview.conf" "${list_text}")
  install(FILES "${CMAKE_BINARY_DIR}/paraview.conf" DESTINATION "${list_folder}" COMPONENT plugin)
  install(TARGETS TopologyCarving LIBRARY DESTINATION "${TOPOLOGYCARVING_LIBRARY_DESTINATION}" COMPONENT plugin)
  install(FILES "${CMAKE_BINARY_DIR}/${plugins}/topologycarving.plugins.xml" DESTINATION "${plugins}" COMPONENT plugin)
else ()
  set(packages
    runtime topologycarving development topologycarving-dev python python3-topologycarving)

  # The help of the program is its manual page.
  set(manual_page "${CMAKE_BINARY_DIR}/carve.1.gz")
  add_custom_command(OUTPUT "${manual_page}"
    COMMAND bash "${packaging}/manual_page.sh" "$<TARGET_FILE:carve>" "${manual_page}"
    DEPENDS carve "${packaging}/manual_page.sh")
  add_custom_target(manual_page ALL DEPENDS "${manual_page}")
  install(FILES "${manual_page}" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT runtime)
  install(FILES "${packaging}/carve.bash-completion" RENAME carve
    DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" COMPONENT runtime)
endif ()

# A package made on a later release replaces one of an earlier release.
cmake_host_system_information(RESULT release QUERY DISTRIB_VERSION_ID)
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}+deb${release}")
string(TIMESTAMP CHANGELOG_DATE "%a, %d %b %Y %H:%M:%S +0000" UTC)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME topologycarving)
set(CPACK_PACKAGE_CONTACT "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

# Reads a license as the body of a field: lines begin with a space, and empty ones are a point.
function (read_license variable file first_words)
  file(READ "${file}" text)
  string(FIND "${text}" "${first_words}" begin)
  string(SUBSTRING "${text}" ${begin} -1 text)
  string(STRIP "${text}" text)
  string(REGEX REPLACE "\n *\n" "\n.\n" text "${text}")
  string(REPLACE "\n" "\n " text "${text}")
  set(${variable} "${text}" PARENT_SCOPE)
endfunction ()
read_license(BSD "${CMAKE_SOURCE_DIR}/LICENSE" "Redistribution and use")
read_license(AGPL "${CMAKE_SOURCE_DIR}/Filters/Helper/AGPL-3.0.txt" "GNU AFFERO")
configure_file("${packaging}/copyright.in" "${CMAKE_BINARY_DIR}/documents/copyright" @ONLY)

while (packages)
  list(POP_FRONT packages component package)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  string(TOUPPER "${component}" key)
  set("CPACK_DEBIAN_${key}_PACKAGE_NAME" ${package})
  set(documents "${CMAKE_BINARY_DIR}/documents/${package}")
  configure_file("${packaging}/changelog.in" "${documents}/changelog" @ONLY)
  execute_process(COMMAND gzip -9nf "${documents}/changelog" COMMAND_ERROR_IS_FATAL ANY)
  install(FILES "${documents}/changelog.gz" "${CMAKE_BINARY_DIR}/documents/copyright"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${package}" COMPONENT ${component})
endwhile ()

set(CPACK_DEBIAN_PACKAGE_SECTION science)
if (TOPOLOGYCARVING_PARAVIEW)
  # ParaView draws its icons with this package, but does not depend on it.
  if (PARAVIEW_QT_MAJOR_VERSION EQUAL 5)
    set(CPACK_DEBIAN_PLUGIN_PACKAGE_RECOMMENDS libqt5svg5)
  else ()
    set(CPACK_DEBIAN_PLUGIN_PACKAGE_RECOMMENDS qt6-svg-plugins)
  endif ()
  set(CPACK_COMPONENT_PLUGIN_DESCRIPTION "plugin for ParaView that simplifies the topology of meshes
Filters that carve a polygonal mesh out of its convex hull. The slider for the
time moves through the levels of detail from the hull to the mesh.

ParaView loads the plugin when it starts.")
else ()
  set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
  set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "simplify the topology of polygonal meshes by carving
Levels of detail of a polygonal mesh, carved out of its convex hull. From level
to level, components split off and tunnels open. Every level encloses the mesh
and does not cross itself.

This package contains the program carve and the library of VTK filters.")
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "topologycarving (= ${CPACK_PACKAGE_VERSION}), libvtk9-dev")
  set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "VTK filters that simplify the topology of meshes (headers)
Levels of detail of a polygonal mesh, carved out of its convex hull.

This package contains the headers and the CMake package TopologyCarving.")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  math(EXPR next_python "${Python3_VERSION_MINOR} + 1")
  string(JOIN ", " CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "topologycarving (= ${CPACK_PACKAGE_VERSION})" python3-vtk9
    "python3 (>= 3.${Python3_VERSION_MINOR}~)" "python3 (<< 3.${next_python})")
  # The module's only library that is not in a package yet is the one of the filters.
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION "VTK filters that simplify the topology of meshes (Python)
Levels of detail of a polygonal mesh, carved out of its convex hull.

This package contains the Python package topologycarving.")
endif ()
include(CPack)
