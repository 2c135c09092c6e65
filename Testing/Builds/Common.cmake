# What the build scripts share. All paths come from Testing/Builds/CMakeLists.txt.

# run(COMMAND...): runs it, shows its output, ends the script when it fails.
function (run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE result)
  if (NOT result EQUAL 0)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "failed (${result}): ${command}")
  endif ()
endfunction ()

# build_plain(FOLDER OPTION...): the module as a plain VTK module.
function (build_plain folder)
  run("${CMAKE_COMMAND}" -S "${SOURCE_DIR}" -B "${folder}" -G Ninja
    -DISTHMUS_PARAVIEW=OFF -DISTHMUS_WERROR=ON "-DVTK_DIR=${VTK_DIR}"
    "-DPython3_EXECUTABLE=${Python3_EXECUTABLE}"
    "-DISTHMUS_DEFAULT_DATA_DIR=${DATA_DIR}" ${ARGN})
  run("${CMAKE_COMMAND}" --build "${folder}")
endfunction ()

# Builds the consumer project against the tree installed at `prefix` and runs it on a map of the
# test's own making. run_consumer(PREFIX FOLDER OPTION...)
function (run_consumer prefix folder)
  run("${CMAKE_COMMAND}" -S "${SOURCE_DIR}/Examples/Consumer" -B "${folder}" -G Ninja
    "-DCMAKE_PREFIX_PATH=${prefix}" ${ARGN})
  run("${CMAKE_COMMAND}" --build "${folder}")
  run("${Python3_EXECUTABLE}" "${SOURCE_DIR}/Testing/Builds/write_phantom.py"
    "${SOURCE_DIR}/Examples" "${folder}/phantom.mrc")
  run("${folder}/map_curvature" "${folder}/phantom.mrc" 0.5 "${folder}/surface.vtp")
  run("${folder}/mesh_curvature")
  run("${folder}/mesh_parts" "${folder}/phantom.mrc" 0.5)
  run("${folder}/surface_loops" "${folder}/surface.vtp")
endfunction ()
