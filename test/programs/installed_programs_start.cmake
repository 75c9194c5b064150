# Installs the built package into an empty folder and starts its programs there.
# cmake -DBUILD_DIR= -DCONFIG= -DPREFIX= -DBIN= -P installed_programs_start.cmake
cmake_minimum_required(VERSION 3.21)

set(expected gcpw_evaluate gcpw_pair gcpw_stitch)

file(REMOVE_RECURSE "${PREFIX}")
execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD_DIR}" --config "${CONFIG}" --prefix "${PREFIX}"
    COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)

cmake_path(ABSOLUTE_PATH BIN BASE_DIRECTORY "${PREFIX}")
file(GLOB installed RELATIVE "${BIN}" "${BIN}/*")
list(TRANSFORM installed REPLACE "\\.exe$" "")
list(SORT installed)
if(NOT installed STREQUAL expected)
    message(FATAL_ERROR "in ${BIN} lie '${installed}', not '${expected}'")
endif()

foreach(program IN LISTS expected)
    execute_process(COMMAND "${BIN}/${program}" --help COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY
        OUTPUT_VARIABLE said)
    if(NOT said MATCHES "Exit code")
        message(FATAL_ERROR "${program} --help says: ${said}")
    endif()
endforeach()
