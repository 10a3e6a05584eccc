# Builds, wraps, exports and installs the VTK module outside of a VTK tree.

# Another python3 may come first on PATH: VTK's modules need the system's.
find_program(Python3_EXECUTABLE NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH
  DOC "The Python interpreter that VTK's Python modules were built for")

# Libraries outside of VTK, such as jsoncpp's, are known only to the folder that finds them first and those below it.
find_package(VTK 9.1 REQUIRED
  COMPONENTS
    CommonCore CommonDataModel CommonExecutionModel CommonMisc FiltersCore FiltersGeneral vtksys
    ParallelCore
  OPTIONAL_COMPONENTS
    FiltersSources InteractionStyle IOCore IOGeometry IOLegacy IOPLY IOXML Python RenderingCore
    RenderingOpenGL2 TestingCore TestingRendering WrappingPythonCore jsoncpp)

set(cmake_destination "${CMAKE_INSTALL_LIBDIR}/cmake/TopologyCarving")

vtk_module_scan(
  MODULE_FILES     "${CMAKE_CURRENT_LIST_DIR}/TopologyCarving.module"
  REQUEST_MODULES  TopologyCarving::Filters
  PROVIDES_MODULES modules
  ENABLE_TESTS     "${BUILD_TESTING}")
vtk_module_build(
  MODULES             ${modules}
  PACKAGE             TopologyCarving
  INSTALL_EXPORT      TopologyCarving
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  RUNTIME_DESTINATION "${CMAKE_INSTALL_BINDIR}"
  CMAKE_DESTINATION   "${cmake_destination}"
  HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/topologycarving"
  VERSION             "${PROJECT_VERSION}"
  SOVERSION           "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")

if (VTK_WRAP_PYTHON AND TARGET VTK::WrappingPythonCore)
  vtk_module_python_default_destination(python_destination)
  vtk_module_wrap_python(
    MODULES             ${modules}
    TARGET              TopologyCarving::Python
    INSTALL_EXPORT      TopologyCarvingPython
    PYTHON_PACKAGE      topologycarving
    MODULE_DESTINATION  "${python_destination}"
    CMAKE_DESTINATION   "${cmake_destination}"
    LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    SOABI               "${Python3_SOABI}"
    BUILD_STATIC        OFF
    INSTALL_HEADERS     OFF)
  # VTK 9.3 generates initializers that lack the latest members of Python 3.13's types.
  target_compile_options(vtkTopologyCarvingPython PRIVATE -Wno-missing-field-initializers)
  set(package_file "${CMAKE_BINARY_DIR}/${python_destination}/topologycarving/__init__.py")
  file(GENERATE OUTPUT "${package_file}" CONTENT
"\"\"\"Topology simplification of triangle meshes by carving: VTK filters.

vtkTopologyCarver       carves a mesh out of its convex hull, into levels of detail
vtkContourCarver        carves polygons and polylines in a plane
vtkExtractCarvedLOD     extracts any level from the stream of a carver
vtkEnclosingDecimation  decimates a closed surface into surfaces that enclose it

help(vtkTopologyCarver) explains properties, outputs and arrays.
\"\"\"
from .vtkTopologyCarving import *
")
  install(FILES "${package_file}" DESTINATION "${python_destination}/topologycarving" COMPONENT python)
else ()
  message(WARNING "The Python package is not built: VTK's Python wrapping was not found.")
endif ()

include(CMakePackageConfigHelpers)
set(package_directory "${CMAKE_BINARY_DIR}/${cmake_destination}")
configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/topologycarving-config.cmake.in"
  "${package_directory}/topologycarving-config.cmake"
  INSTALL_DESTINATION "${cmake_destination}")
write_basic_package_version_file("${package_directory}/topologycarving-config-version.cmake"
  COMPATIBILITY SameMinorVersion)
install(
  FILES
    "${package_directory}/topologycarving-config.cmake"
    "${package_directory}/topologycarving-config-version.cmake"
  DESTINATION "${cmake_destination}"
  COMPONENT development)
