set(capture_tests ${CMAKE_SOURCE_DIR}/tests/core/capture)
add_executable(capture_torture capture_torture.cpp ${capture_tests}/torture.cpp
  ${capture_tests}/flat_rig.cpp ${capture_tests}/simulated_controllers.cpp)
target_link_libraries(capture_torture PRIVATE ostraka_flags ostraka_capture opencv_aruco
  opencv_imgproc opencv_imgcodecs)
