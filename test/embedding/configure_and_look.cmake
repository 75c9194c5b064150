# Configures a project that takes this one in, both ways, without building it: its build type stays empty, and only its own
# program would be installed.
# cmake -DPARENT_DIR= -DREPOSITORY= -DSCRATCH_DIR= -DGENERATOR= -DCXX_COMPILER= -DOPENCV_DIR= -P configure_and_look.cmake
cmake_minimum_required(VERSION 3.21)

foreach(how IN ITEMS add_subdirectory FetchContent)
    set(build "${SCRATCH_DIR}/${how}")
    file(REMOVE_RECURSE "${build}")
    execute_process(COMMAND "${CMAKE_COMMAND}" -S "${PARENT_DIR}" -B "${build}" -G "${GENERATOR}" "-DHOW=${how}"
        "-DREPOSITORY=${REPOSITORY}" "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}" "-DOpenCV_DIR=${OPENCV_DIR}"
        COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
    load_cache("${build}" READ_WITH_PREFIX parent_ CMAKE_BUILD_TYPE)
    if(parent_CMAKE_BUILD_TYPE)
        message(FATAL_ERROR "${how} sets the parent's build type to ${parent_CMAKE_BUILD_TYPE}")
    endif()
    file(GLOB_RECURSE scripts "${build}/cmake_install.cmake")
    foreach(script IN LISTS scripts)
        file(STRINGS "${script}" rules REGEX "file\\(INSTALL.*gcpw")
        list(FILTER rules EXCLUDE REGEX "gcpw_parent\"")
        if(rules)
            message(FATAL_ERROR "${how}: the parent would install ${rules}")
        endif()
    endforeach()
endforeach()
