# cmake/new_filter.sh in a copy of the sources: what it writes passes the checks and
# compiles against the library of the main build, and its tests fail with "write me".
include("${CMAKE_CURRENT_LIST_DIR}/Common.cmake")

set(copy "${WORK_DIR}/new-filter/sources")
file(REMOVE_RECURSE "${WORK_DIR}/new-filter")
file(MAKE_DIRECTORY "${copy}")
foreach (folder IN ITEMS cmake Documentation Examples Filters Readers Plugin Testing Wrapping)
  file(COPY "${SOURCE_DIR}/${folder}" DESTINATION "${copy}")
endforeach ()
# READMEs and the guide link to these.
foreach (file IN ITEMS .clang-tidy .github CHANGELOG.md CITATION.cff CONTRIBUTING.md LICENSE README.md)
  file(COPY "${SOURCE_DIR}/${file}" DESTINATION "${copy}")
endforeach ()

run("${copy}/cmake/new_filter.sh" PhaseFlip Imaging)
foreach (check IN ITEMS check_modules check_links)
  run("${Python3_EXECUTABLE}" "${copy}/Testing/${check}.py" "${copy}")
endforeach ()
execute_process(COMMAND "${copy}/cmake/new_filter.sh" PhaseFlip Imaging
  RESULT_VARIABLE again OUTPUT_QUIET ERROR_QUIET)
if (again EQUAL 0)
  message(FATAL_ERROR "a filter that is there already was written a second time")
endif ()

# The panel is well-formed, and its class is the one written.
run("${Python3_EXECUTABLE}" -c
  "import sys, xml.etree.ElementTree as e; p = e.parse(sys.argv[1]).find('.//SourceProxy'); sys.exit(p.get('class') != 'vtkPhaseFlip')"
  "${copy}/Plugin/PhaseFlip.xml")

# The guide's page is complete but for its picture, and lists the arrays of the table.
run("${Python3_EXECUTABLE}" -c
  "import pathlib, sys
root = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(root / 'Testing'))
import check_guide, pages
site = pages.Site(root, '')
assert list(check_guide.check_panels(site, root)) == ['Documentation/filters/PhaseFlip.md has no picture']
page = site.filter_page(site.panels['PhaseFlip'], (root / 'Documentation/filters/PhaseFlip.md').read_text())
assert page.count('| `PhaseFlip` | points |') == 1, page"
  "${copy}")

set(folder "${WORK_DIR}/new-filter/build")
run("${CMAKE_COMMAND}" -S "${SOURCE_DIR}/Testing/Builds/new_filter" -B "${folder}" -G Ninja
  "-DSOURCES=${copy}" "-DNAME=PhaseFlip" "-DMODULE=Imaging" "-DVTK_DIR=${VTK_DIR}"
  "-DMAIN_BINARY_DIR=${MAIN_BINARY_DIR}")
run("${CMAKE_COMMAND}" --build "${folder}")
execute_process(COMMAND "${folder}/TestPhaseFlip" RESULT_VARIABLE result OUTPUT_VARIABLE said
  ERROR_VARIABLE said)
message(STATUS "${said}")
if (result EQUAL 0 OR NOT said MATCHES "write me" OR NOT said MATCHES "1 FAILED TEST")
  message(FATAL_ERROR "the new filter's test should have failed with 'write me', and it alone")
endif ()
