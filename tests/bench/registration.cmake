add_executable(registration_accuracy registration_accuracy.cpp)
target_link_libraries(registration_accuracy PRIVATE ostraka_registration ostraka_batch
  nlohmann_json::nlohmann_json opencv_imgcodecs)
# The rivals of the Point Cloud Library, by name: its CMake targets would pull in VTK and Qt 5.
find_path(OSTRAKA_PCL_INCLUDE pcl/registration/icp.h PATHS /usr/include/pcl-1.13 NO_DEFAULT_PATH)
find_library(OSTRAKA_PCL_REGISTRATION pcl_registration)
find_package(OpenMP QUIET)
if(OSTRAKA_PCL_INCLUDE AND OSTRAKA_PCL_REGISTRATION AND OpenMP_CXX_FOUND)
  target_sources(registration_accuracy PRIVATE registration_rivals.cpp)
  # gcc 12 takes Eigen's umeyama, as the library calls it, for an overrun.
  set_source_files_properties(registration_rivals.cpp PROPERTIES COMPILE_OPTIONS -Wno-array-bounds)
  target_include_directories(registration_accuracy SYSTEM PRIVATE ${OSTRAKA_PCL_INCLUDE})
  target_compile_definitions(registration_accuracy PRIVATE OSTRAKA_WITH_PCL)
  target_link_libraries(registration_accuracy PRIVATE pcl_registration pcl_features pcl_sample_consensus
    pcl_filters pcl_search pcl_kdtree pcl_octree pcl_common flann_cpp lz4 OpenMP::OpenMP_CXX)
endif()
add_executable(registration_processed registration_processed.cpp)
target_link_libraries(registration_processed PRIVATE ostraka_pipeline ostraka_scansets ostraka_review ostraka_registration
  nlohmann_json::nlohmann_json opencv_imgcodecs)
add_executable(joining_figures joining_figures.cpp)
target_link_libraries(joining_figures PRIVATE ostraka_base ostraka_files ostraka_paper nlohmann_json::nlohmann_json)
target_include_directories(joining_figures PRIVATE ${CMAKE_SOURCE_DIR}/core)
