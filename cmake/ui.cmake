# What every target of the window is built with: Qt's headers are compiled once, and shared.
add_library(ostraka_qt STATIC ${CMAKE_SOURCE_DIR}/cmake/precompiled.cpp)
target_link_libraries(ostraka_qt PUBLIC ostraka_flags Qt6::Widgets Qt6::Svg Qt6::PrintSupport)
target_precompile_headers(ostraka_qt PRIVATE <QtWidgets>)

# ostraka_ui(name SOURCES a.cpp DEPENDS jobs LINKS ostraka_catalogue ostraka_upkeep ostraka_intake)
# One static library per folder of ui; DEPENDS are folders of ui, LINKS folders of core or others.
function(ostraka_ui name)
  cmake_parse_arguments(A "" "" "SOURCES;DEPENDS;LINKS" ${ARGN})
  add_library(ostraka_ui_${name} STATIC ${A_SOURCES})
  set_target_properties(ostraka_ui_${name} PROPERTIES AUTOMOC ON AUTORCC ON)
  target_link_libraries(ostraka_ui_${name} PUBLIC ostraka_qt ${A_LINKS})
  target_precompile_headers(ostraka_ui_${name} REUSE_FROM ostraka_qt)
  foreach(d ${A_DEPENDS})
    target_link_libraries(ostraka_ui_${name} PUBLIC ostraka_ui_${d})
  endforeach()
endfunction()

# ostraka_ui_test(review [WINDOW] [SHARED] SOURCES a_test.cpp LINKS ostraka_ui_review)
# One QtTest program per source. WINDOW: in a real window on a virtual screen with a window manager;
# otherwise without any display.
function(ostraka_ui_test name)
  cmake_parse_arguments(A "WINDOW;SHARED" "" "SOURCES;LINKS" ${ARGN})
  if(A_SHARED AND NOT EXISTS ${OSTRAKA_SHARED_DIR}/metrics.md)
    return()
  endif()
  foreach(source ${A_SOURCES})
    get_filename_component(stem ${source} NAME_WE)
    set(target ui_${name}_${stem})
    add_executable(${target} ${source})
    set_target_properties(${target} PROPERTIES AUTOMOC ON OSTRAKA_LEVEL 0)
    target_link_libraries(${target} PRIVATE ${A_LINKS} ostraka_qt Qt6::Test)
    target_precompile_headers(${target} REUSE_FROM ostraka_qt_tests)
    set_source_files_properties(${CMAKE_CURRENT_BINARY_DIR}/${target}_autogen/mocs_compilation.cpp
      PROPERTIES SKIP_PRECOMPILE_HEADERS ON)  # it is empty, and reading them takes two seconds
    target_compile_definitions(${target} PRIVATE OSTRAKA_SHARED_DIR="${OSTRAKA_SHARED_DIR}"
      OSTRAKA_TEST_DATA_DIR="${CMAKE_SOURCE_DIR}/tests/data")
    if(A_WINDOW)
      add_test(NAME ${target} COMMAND ${CMAKE_SOURCE_DIR}/tests/ui/on_a_screen.sh $<TARGET_FILE:${target}>)
    else()
      add_test(NAME ${target} COMMAND ${target})
      set_tests_properties(${target} PROPERTIES ENVIRONMENT QT_QPA_PLATFORM=offscreen)
    endif()
    set_tests_properties(${target} PROPERTIES TIMEOUT 300)
    if(A_SHARED)
      set_tests_properties(${target} PROPERTIES LABELS shared TIMEOUT 900)
    endif()
  endforeach()
endfunction()
