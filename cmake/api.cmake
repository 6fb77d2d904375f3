# libostraka: the functions of core/api with all of core inside and hidden, its headers, and the
# files by which find_package(Ostraka) finds both.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(compatible ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})  # from 1.0 on: the major alone
add_library(ostraka_shared SHARED $<TARGET_OBJECTS:ostraka_api>)
# Errors carry messages, whose functions are seen from outside, too.
target_sources(ostraka_shared PRIVATE ${CMAKE_SOURCE_DIR}/core/base/message.cpp)
target_include_directories(ostraka_shared PRIVATE ${CMAKE_SOURCE_DIR}/core)
set_source_files_properties(${CMAKE_SOURCE_DIR}/core/base/message.cpp
  PROPERTIES COMPILE_OPTIONS -fvisibility=default)
target_link_libraries(ostraka_shared PRIVATE ostraka_api INTERFACE Eigen3::Eigen)
target_link_options(ostraka_shared PRIVATE LINKER:--exclude-libs,ALL)
target_compile_features(ostraka_shared INTERFACE cxx_std_20)
target_include_directories(ostraka_shared INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/ostraka>)
set_target_properties(ostraka_shared PROPERTIES OUTPUT_NAME ostraka EXPORT_NAME Ostraka
  LINKER_LANGUAGE CXX VERSION ${PROJECT_VERSION} SOVERSION ${compatible})

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/Ostraka)
install(TARGETS ostraka_shared EXPORT Ostraka
  LIBRARY COMPONENT library NAMELINK_COMPONENT development)
install(EXPORT Ostraka DESTINATION ${package} NAMESPACE Ostraka:: FILE OstrakaTargets.cmake
  COMPONENT development)
configure_package_config_file(${CMAKE_SOURCE_DIR}/cmake/OstrakaConfig.cmake.in
  ${CMAKE_BINARY_DIR}/OstrakaConfig.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/OstrakaConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/OstrakaConfig.cmake ${CMAKE_BINARY_DIR}/OstrakaConfigVersion.cmake
  DESTINATION ${package} COMPONENT development)

# A header names another by its place below core/, which is its place below include/ostraka/, too.
set(headers ${CMAKE_INSTALL_INCLUDEDIR}/ostraka)
set(core ${CMAKE_SOURCE_DIR}/core)
install(FILES ${core}/api/catalogue.h ${core}/api/close_model.h ${core}/api/dense.h
  ${core}/api/point_files.h ${core}/api/register.h ${core}/api/version.h
  DESTINATION ${headers} COMPONENT development)
install(FILES ${core}/base/limits.h ${core}/base/message.h ${core}/base/progress.h
  ${core}/base/result.h DESTINATION ${headers}/base COMPONENT development)
install(FILES ${core}/cloud/points_and_meshes.h DESTINATION ${headers}/cloud COMPONENT development)
