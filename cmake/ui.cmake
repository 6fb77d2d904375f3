# What every target of the window is built with: Qt's headers are compiled once, and shared. The
# window computes little.
add_library(ostraka_qt STATIC ${CMAKE_SOURCE_DIR}/cmake/precompiled.cpp)
set_target_properties(ostraka_qt PROPERTIES OSTRAKA_LEVEL 1)
target_link_libraries(ostraka_qt PUBLIC ostraka_flags Qt6::Widgets Qt6::Svg Qt6::PrintSupport)
target_precompile_headers(ostraka_qt PRIVATE <QtWidgets>)
get_target_property(moc Qt6::moc LOCATION)
configure_file(cmake/moc.in ${CMAKE_BINARY_DIR}/moc @ONLY)

# ostraka_ui(name SOURCES a.cpp DEPENDS jobs LINKS ostraka_catalogue ostraka_upkeep ostraka_intake)
# One static library per folder of ui; DEPENDS are folders of ui, LINKS folders of core or others.
function(ostraka_ui name)
  cmake_parse_arguments(A "" "" "SOURCES;DEPENDS;LINKS" ${ARGN})
  # What moc writes is compiled with the folder's sources: alone it would read their headers again,
  # for ten seconds. A header that got its Q_OBJECT later is compiled by AUTOMOC meanwhile.
  set(mocs)
  file(GLOB headers RELATIVE ${CMAKE_SOURCE_DIR} *.h)
  foreach(header ${headers})
    file(STRINGS ${CMAKE_SOURCE_DIR}/${header} marked REGEX "^ *Q_OBJECT")
    get_filename_component(stem ${header} NAME_WE)
    if(marked)
      string(APPEND mocs "#include \"ui/${name}/moc_${stem}.cpp\"\n")
    endif()
  endforeach()
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/mocs.cpp CONTENT "${mocs}" @ONLY)
  add_library(ostraka_ui_${name} STATIC ${A_SOURCES} ${CMAKE_CURRENT_BINARY_DIR}/mocs.cpp)
  set_source_files_properties(
    ${CMAKE_CURRENT_BINARY_DIR}/ostraka_ui_${name}_autogen/mocs_compilation.cpp
    PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
  set_target_properties(ostraka_ui_${name} PROPERTIES AUTOMOC ON AUTORCC ON OSTRAKA_LEVEL 1
    AUTOMOC_EXECUTABLE ${CMAKE_BINARY_DIR}/moc)
  target_link_libraries(ostraka_ui_${name} PUBLIC ostraka_qt ${A_LINKS})
  target_precompile_headers(ostraka_ui_${name} REUSE_FROM ostraka_qt)
  foreach(d ${A_DEPENDS})
    target_link_libraries(ostraka_ui_${name} PUBLIC ostraka_ui_${d})
  endforeach()
endfunction()

# ostraka_ui_test(queue OFFSCREEN rows_test.cpp WINDOW screen_test.cpp LINKS ostraka_ui_queue)
# One QtTest program per folder (tests/ui/program.h), and one test per source, which it runs in a
# process of its own. WINDOW: in a real window on a virtual screen with a window manager; OFFSCREEN:
# without any display.
function(ostraka_ui_test name)
  cmake_parse_arguments(A "" "" "OFFSCREEN;WINDOW;LINKS" ${ARGN})
  set(target ui_${name}_test)
  add_executable(${target} ${A_OFFSCREEN} ${A_WINDOW})
  set_target_properties(${target} PROPERTIES AUTOMOC ON OSTRAKA_LEVEL 0
    AUTOMOC_EXECUTABLE ${CMAKE_BINARY_DIR}/moc)
  target_link_libraries(${target} PRIVATE ${A_LINKS} ostraka_ui_program opencv_imgcodecs)
  target_precompile_headers(${target} REUSE_FROM ostraka_qt_tests)
  set_source_files_properties(${CMAKE_CURRENT_BINARY_DIR}/${target}_autogen/mocs_compilation.cpp
    PROPERTIES SKIP_PRECOMPILE_HEADERS ON)  # it is empty, and reading them takes two seconds
  foreach(source ${A_OFFSCREEN} ${A_WINDOW})
    get_filename_component(stem ${source} NAME_WE)
    set(test ui_${name}_${stem})
    set(environment ${ostraka_no_wait})
    if(source IN_LIST A_WINDOW)
      set(screen ${CMAKE_SOURCE_DIR}/tests/ui/on_a_screen.sh)
    else()
      set(screen)
      list(APPEND environment QT_QPA_PLATFORM=offscreen)
    endif()
    add_test(NAME ${test} COMMAND ${screen} $<TARGET_FILE:${target}> ${stem})
    set_tests_properties(${test} PROPERTIES ENVIRONMENT "${environment}" TIMEOUT 300)
  endforeach()
endfunction()
