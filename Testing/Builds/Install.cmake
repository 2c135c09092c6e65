include("${CMAKE_CURRENT_LIST_DIR}/Common.cmake")

set(prefix "${WORK_DIR}/installed")
file(REMOVE_RECURSE "${prefix}")
run("${CMAKE_COMMAND}" --install "${MAIN_BINARY_DIR}" --prefix "${prefix}")
run_consumer("${prefix}" "${WORK_DIR}/consumer")

# By components: the permissive modules bring nothing of the GPL along, on the link line or loaded.
set(folder "${WORK_DIR}/components")
file(REMOVE_RECURSE "${folder}")
run("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}/components" -B "${folder}" -G Ninja
  "-DCMAKE_PREFIX_PATH=${prefix}")
run("${CMAKE_COMMAND}" --build "${folder}")
run("${folder}/denoised_curvature" "${WORK_DIR}/consumer/phantom.mrc")
run("${folder}/all_modules" "${WORK_DIR}/consumer/phantom.mrc")
execute_process(COMMAND ninja -C "${folder}" -t commands denoised_curvature
  OUTPUT_VARIABLE link_line COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ldd "${folder}/denoised_curvature"
  OUTPUT_VARIABLE loaded COMMAND_ERROR_IS_FATAL ANY)
if (NOT link_line MATCHES "vtkIsthmusReadersMaps" OR NOT loaded MATCHES "vtkIsthmusFiltersCurvature")
  message(FATAL_ERROR "the program is not linked to the components:\n${link_line}\n${loaded}")
endif ()
foreach (name IN ITEMS CGAL gmp mpfr vtkIsthmusFiltersRemeshing vtkIsthmusFiltersPersistence
    vtkIsthmusFiltersContouring vtkIsthmusFiltersTetrahedra)
  if (link_line MATCHES "${name}" OR loaded MATCHES "${name}")
    message(FATAL_ERROR "a program of permissive components is linked to ${name}:\n${link_line}\n${loaded}")
  endif ()
endforeach ()

# Nothing of the build tree on the path: what is imported and loaded is what was installed.
file(GLOB python_path "${prefix}/lib*/python*/site-packages")
file(GLOB plugin_path "${prefix}/lib*/isthmus/plugins")
run("${CMAKE_COMMAND}" -E env
  "PYTHONPATH=${python_path}" "PV_PLUGIN_PATH=${plugin_path}"
  xvfb-run -a pvpython "${CMAKE_CURRENT_LIST_DIR}/check_installed.py" "${prefix}"
  "${WORK_DIR}/consumer/phantom.mrc")
