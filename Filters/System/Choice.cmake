# Chooses the implementations of what differs between operating systems.
if (CMAKE_SYSTEM_NAME STREQUAL "Linux")
  set(portable OFF)
else ()
  set(portable ON)
endif ()
option(TOPOLOGYCARVING_PORTABLE "Use only what all systems have: temporary files, and programs instead of forks"
  ${portable})
if (TOPOLOGYCARVING_PORTABLE)
  set(TOPOLOGYCARVING_SYSTEM "Portable") # the end of the names of sources that depend on the system
else ()
  set(TOPOLOGYCARVING_SYSTEM "Linux")
endif ()
