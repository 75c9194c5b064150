# Installs the built package into a scratch folder, then configures, builds and runs the consumer against it.
# cmake -DBUILD_DIR= -DCONFIG= -DCONSUMER_DIR= -DSCRATCH_DIR= -DGENERATOR= -DCXX_COMPILER= -DCXX_FLAGS= -DOPENCV_DIR=
#       -DVERSION= -P install_and_run.cmake
cmake_minimum_required(VERSION 3.21)

set(prefix "${SCRATCH_DIR}/prefix")
set(build "${SCRATCH_DIR}/build")
file(REMOVE_RECURSE "${SCRATCH_DIR}")

function(run)
    execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --config "${CONFIG}" --prefix "${prefix}")
run("${CMAKE_COMMAND}" -S "${CONSUMER_DIR}" -B "${build}" -G "${GENERATOR}"
    "-DCMAKE_BUILD_TYPE=${CONFIG}" "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}" "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}"
    "-DCMAKE_PREFIX_PATH=${prefix}" "-DOpenCV_DIR=${OPENCV_DIR}" "-DGCPW_EXPECTED_VERSION=${VERSION}"
    "-DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF")

# Found where it was installed, and not by chance somewhere else.
load_cache("${build}" READ_WITH_PREFIX consumer_ gcpw_DIR)
cmake_path(IS_PREFIX prefix "${consumer_gcpw_DIR}" NORMALIZE found_in_prefix)
if(NOT found_in_prefix)
    message(FATAL_ERROR "find_package(gcpw) took ${consumer_gcpw_DIR}, not the package in ${prefix}")
endif()

run("${CMAKE_COMMAND}" --build "${build}" --config "${CONFIG}")
find_program(consumer gcpw_consumer REQUIRED NO_DEFAULT_PATH PATHS "${build}" "${build}/${CONFIG}")
run("${consumer}")
