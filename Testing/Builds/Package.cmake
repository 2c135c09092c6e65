# The Debian package that cpack makes: what is in it, what it depends on, its copyright; unpacked
# into a folder, its plugin and Python module work. (In a clean root by hand: see Testing/README.md.)
include("${CMAKE_CURRENT_LIST_DIR}/Common.cmake")

set(folder "${WORK_DIR}/package")
file(REMOVE_RECURSE "${folder}")
file(MAKE_DIRECTORY "${folder}")
run("${CMAKE_CPACK_COMMAND}" -G DEB -B "${folder}" --config "${MAIN_BINARY_DIR}/CPackConfig.cmake")
file(GLOB package "${folder}/isthmus_*.deb")
execute_process(COMMAND dpkg-deb -c "${package}" OUTPUT_VARIABLE contents COMMAND_ERROR_IS_FATAL ANY)
foreach (part IN ITEMS
  "/usr/bin/plugins/Isthmus/Isthmus.so" # where ParaView of Debian looks
  "/usr/bin/plugins/Isthmus/python/isthmus_plugin/pipelines.py"
  "/libvtkIsthmusFiltersCore.so"
  "/libvtkIsthmusReadersMaps.so"
  "/isthmus/CellComplex/StarTable.h"
  "/usr/lib/python3/dist-packages/isthmus/__init__.py"
  "/usr/lib/python3/dist-packages/isthmus/pipelines.py"
  "/vtkMapSurface.h"
  "/IsthmusConfig.cmake"
  "/usr/share/doc/isthmus/copyright"
  "/usr/share/doc/isthmus/changelog.gz")
  if (NOT contents MATCHES "${part}")
    message(FATAL_ERROR "${package} has no ${part}:\n${contents}")
  endif ()
endforeach ()
if (contents MATCHES "site-packages|isthmus/plugins")
  message(FATAL_ERROR "${package} has files where Debian does not look:\n${contents}")
endif ()
execute_process(COMMAND dpkg-deb -f "${package}" Depends OUTPUT_VARIABLE depends
  COMMAND_ERROR_IS_FATAL ANY)
foreach (name IN ITEMS paraview python3-paraview tetgen libgmp10 "libqt[56]core")
  if (NOT depends MATCHES "${name}")
    message(FATAL_ERROR "${package} does not depend on ${name}: ${depends}")
  endif ()
endforeach ()

execute_process(COMMAND dpkg-deb -I "${package}" prerm OUTPUT_VARIABLE prerm COMMAND_ERROR_IS_FATAL ANY)
if (NOT prerm MATCHES "__pycache__")
  message(FATAL_ERROR "${package} leaves compiled Python files behind when it is removed.")
endif ()

set(root "${folder}/root")
run(dpkg-deb -x "${package}" "${root}")
file(READ "${root}/usr/share/doc/isthmus/copyright" copyright)
if (NOT copyright MATCHES "CGAL" OR NOT copyright MATCHES "GPL-3.0-or-later")
  message(FATAL_ERROR "The copyright file does not name CGAL's GPL.")
endif ()
file(GLOB_RECURSE library "${root}/usr/lib*/libvtkIsthmusFiltersCore.so")
get_filename_component(library_folder "${library}" DIRECTORY)
run("${CMAKE_COMMAND}" -E env
  "LD_LIBRARY_PATH=${library_folder}"
  "PV_PLUGIN_PATH=${root}/usr/bin/plugins"
  "PYTHONPATH=${root}/usr/lib/python3/dist-packages"
  xvfb-run -a pvpython "${CMAKE_CURRENT_LIST_DIR}/check_package.py")
