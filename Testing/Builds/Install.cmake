include("${CMAKE_CURRENT_LIST_DIR}/Common.cmake")

set(prefix "${WORK_DIR}/installed")
file(REMOVE_RECURSE "${prefix}")
run("${CMAKE_COMMAND}" --install "${MAIN_BINARY_DIR}" --prefix "${prefix}")
run_consumer("${prefix}" "${WORK_DIR}/consumer")

# Nothing of the build tree on the path: what is imported and loaded is what was installed.
file(GLOB python_path "${prefix}/lib*/python*/site-packages")
file(GLOB plugin_path "${prefix}/lib*/isthmus/plugins")
run("${CMAKE_COMMAND}" -E env
  "PYTHONPATH=${python_path}" "PV_PLUGIN_PATH=${plugin_path}"
  xvfb-run -a pvpython "${CMAKE_CURRENT_LIST_DIR}/check_installed.py" "${prefix}"
  "${WORK_DIR}/consumer/phantom.mrc")
