# The module on its own: target gcpw::gcpw, installed so that find_package(gcpw) finds it.

include(GNUInstallDirs)
include("${CMAKE_CURRENT_LIST_DIR}/version.cmake")

# A project that takes this one in decides itself what it installs.
set(gcpw_alone OFF)
if(CMAKE_PROJECT_NAME STREQUAL "gcpw")
    set(gcpw_alone ON)
endif()
option(GCPW_INSTALL "Install the library, its headers and its packages for CMake and pkg-config" ${gcpw_alone})

set(gcpw_opencv_version 4.5.1)
# A package of OpenCV 5 says it is not compatible with 4.5.1, so the version is looked at here.
find_package(OpenCV REQUIRED COMPONENTS core)
if(OpenCV_VERSION VERSION_LESS gcpw_opencv_version)
    message(FATAL_ERROR "OpenCV ${gcpw_opencv_version} or newer is needed; ${OpenCV_DIR} has ${OpenCV_VERSION}")
endif()
# OpenCV 5 renamed features2d, and split calib3d.
set(gcpw_features features2d)
set(gcpw_homography calib3d)
if(OpenCV_VERSION VERSION_GREATER_EQUAL 5)
    set(gcpw_features features)
    set(gcpw_homography geometry)
endif()
set(gcpw_opencv_modules core imgproc ${gcpw_features} ${gcpw_homography} stitching ximgproc)
find_package(OpenCV REQUIRED COMPONENTS ${gcpw_opencv_modules})
find_package(Eigen3 3.4 REQUIRED CONFIG)
get_target_property(gcpw_eigen_dirs Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)

set(gcpw_public_libs opencv_core opencv_imgproc opencv_${gcpw_features} opencv_stitching)
set(gcpw_private_libs opencv_${gcpw_homography} opencv_ximgproc)

# Compiled once. The library is made of these objects, and so are the tests, which look at private classes as well.
file(GLOB_RECURSE gcpw_sources CONFIGURE_DEPENDS src/*.cpp)
add_library(gcpw_objects OBJECT ${gcpw_sources})
target_compile_features(gcpw_objects PUBLIC cxx_std_17)
target_include_directories(gcpw_objects PUBLIC include src)
target_include_directories(gcpw_objects SYSTEM PUBLIC ${gcpw_eigen_dirs})
target_link_libraries(gcpw_objects PUBLIC ${gcpw_public_libs} ${gcpw_private_libs})
set_target_properties(gcpw_objects PROPERTIES
    POSITION_INDEPENDENT_CODE ON
    CXX_VISIBILITY_PRESET hidden
    VISIBILITY_INLINES_HIDDEN ON)
if(BUILD_SHARED_LIBS)
    target_compile_definitions(gcpw_objects PRIVATE CVAPI_EXPORTS)
endif()

# Until 1.0 the interface may change with every minor version.
string(REGEX REPLACE "^([0-9]+[.][0-9]+).*" "\\1" gcpw_soversion ${GCPW_VERSION})
add_library(gcpw $<TARGET_OBJECTS:gcpw_objects>)
add_library(gcpw::gcpw ALIAS gcpw)
target_include_directories(gcpw PUBLIC
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_link_libraries(gcpw PUBLIC ${gcpw_public_libs} PRIVATE ${gcpw_private_libs})
set_target_properties(gcpw PROPERTIES
    LINKER_LANGUAGE CXX
    VERSION ${GCPW_VERSION}
    SOVERSION ${gcpw_soversion})

if(GCPW_INSTALL)
    include(cmake/install.cmake)
endif()
