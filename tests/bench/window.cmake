if(TARGET ostraka_ui_main)
  add_executable(window_heartbeat window_heartbeat.cpp)
  target_link_libraries(window_heartbeat PRIVATE ostraka_ui_main)
endif()
