# Run by cpack on what it is about to pack: brings files to where Debian looks for them.

foreach (root IN ITEMS "${CPACK_TEMPORARY_INSTALL_DIRECTORY}" "${CPACK_TEMPORARY_DIRECTORY}")
  if (EXISTS "${root}/usr")
    set(usr "${root}/usr")
  endif ()
endforeach ()
if (NOT usr)
  message(FATAL_ERROR "Nothing was installed below ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr.")
endif ()

# ParaView of Debian loads bin/plugins/X/X.so beside its programs by itself.
file(GLOB_RECURSE plugin "${usr}/lib*/Isthmus.so")
if (NOT plugin)
  message(FATAL_ERROR "The plugin is not there: was it built?")
endif ()
file(MAKE_DIRECTORY "${usr}/bin/plugins/Isthmus")
file(RENAME "${plugin}" "${usr}/bin/plugins/Isthmus/Isthmus.so")
get_filename_component(folder "${plugin}" DIRECTORY)
file(RENAME "${folder}/python" "${usr}/bin/plugins/Isthmus/python")
file(GLOB leftovers "${usr}/lib*/isthmus" "${usr}/lib*/*/isthmus")
file(REMOVE_RECURSE ${leftovers})

# Debian's Python looks into dist-packages only.
file(GLOB package "${usr}/lib*/python3*/site-packages/isthmus")
file(MAKE_DIRECTORY "${usr}/lib/python3/dist-packages")
file(RENAME "${package}" "${usr}/lib/python3/dist-packages/isthmus")
file(GLOB leftovers "${usr}/lib/python3.*")
file(REMOVE_RECURSE ${leftovers})

set(documents "${usr}/share/doc/isthmus")
file(MAKE_DIRECTORY "${documents}")
file(COPY_FILE "${CPACK_ISTHMUS_COPYRIGHT}" "${documents}/copyright")
file(COPY_FILE "${CPACK_ISTHMUS_CHANGELOG}" "${documents}/changelog")
execute_process(COMMAND gzip -9nf "${documents}/changelog" COMMAND_ERROR_IS_FATAL ANY)
