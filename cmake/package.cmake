# The Debian package: packaging/package.sh, or `cpack -G DEB` in the build folder. What it holds is
# listed in packaging/contents.txt.
include(GNUInstallDirs)
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)  # the program only, not the tests
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(icons ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable)
install(FILES packaging/ostraka.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES packaging/org.ostraka.ostraka.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
install(FILES packaging/ostraka-mime.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages
        RENAME ostraka.xml)
install(FILES resources/icons/ostraka.svg DESTINATION ${icons}/apps)
install(FILES resources/icons/ostraka.svg DESTINATION ${icons}/mimetypes
        RENAME application-x-ostraka-project.svg)
install(FILES packaging/udev/70-ostraka.rules DESTINATION lib/udev/rules.d)
install(FILES README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY packaging/cluster DESTINATION ${CMAKE_INSTALL_DOCDIR}/packaging)
install(FILES resources/docs/review-light.png resources/docs/catalogue-light.png
        DESTINATION ${CMAKE_INSTALL_DOCDIR}/resources/docs)
install(DIRECTORY resources/manual DESTINATION ${CMAKE_INSTALL_DOCDIR}
        PATTERN *.qrc EXCLUDE)
install(FILES packaging/debian/doc-base DESTINATION ${CMAKE_INSTALL_DATADIR}/doc-base
        RENAME ostraka)

# Manual pages and completions are what the program says of itself; packages want pages compressed.
set(says ${CMAKE_BINARY_DIR}/says)
install(CODE "
  file(REMOVE_RECURSE ${says})
  file(MAKE_DIRECTORY ${says}/completion)
  execute_process(COMMAND $<TARGET_FILE:ostraka> man-pages ${says}/man COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND sh -c \"gzip -9n ${says}/man/*.1\" COMMAND_ERROR_IS_FATAL ANY)
  foreach(shell bash zsh fish)
    execute_process(COMMAND $<TARGET_FILE:ostraka> completion \${shell}
      OUTPUT_FILE ${says}/completion/\${shell} COMMAND_ERROR_IS_FATAL ANY)
  endforeach()")
install(DIRECTORY ${says}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${says}/completion/bash RENAME ostraka
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${says}/completion/zsh RENAME _ostraka
        DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
install(FILES ${says}/completion/fish RENAME ostraka.fish
        DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME ostraka)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "Ostraka maintainers <maintainers@ostraka.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "libgl1-mesa-dri, qt6-translations-l10n, fonts-dejavu-core")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "colmap, openssh-client, rsync, slurm-client")
# Three packages: the program; the library; the headers, for those who build with it. A description
# is the summary and, below it, the rest; the common one of CPack would become each one's summary.
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program)
set(packages ostraka)
set(about "A plate of potsherds is photographed from all around, the sherds are turned
over by hand and photographed again. Ostraka finds out which back belongs
to which front, joins both sides along the broken edge, and keeps the
sherds in a catalogue with their measurements.")
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION
    "3D models of potsherds from photographs of both their sides\n${about}")
if(TARGET ostraka_shared)
  get_target_property(soversion ostraka_shared SOVERSION)
  list(APPEND CPACK_COMPONENTS_ALL library development)
  list(APPEND packages libostraka${soversion} libostraka-dev)
  set(CPACK_DEBIAN_LIBRARY_DESCRIPTION "3D models of potsherds (shared library)\n${about}
\nThis package has the library, which other programs use.")
  set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
  set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${CMAKE_SOURCE_DIR}/packaging/debian/triggers)
  set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
  set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "3D models of potsherds (headers)\n${about}
\nThis package has the headers of the C++ API, and what find_package(Ostraka)
reads.")
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
      "libostraka${soversion} (= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}), libeigen3-dev")
endif()

# What each of them has to hold: who owns it, what changed, and what lintian need not say.
set(changes ${CMAKE_BINARY_DIR}/changes)
configure_file(CHANGELOG.md ${changes}/changelog COPYONLY)
configure_file(packaging/changelog.in ${changes}/changelog.Debian @ONLY)
execute_process(COMMAND gzip -9nkf changelog changelog.Debian WORKING_DIRECTORY ${changes}
  COMMAND_ERROR_IS_FATAL ANY)
foreach(component package IN ZIP_LISTS CPACK_COMPONENTS_ALL packages)
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${package})
  install(FILES packaging/copyright ${changes}/changelog.gz ${changes}/changelog.Debian.gz
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component})
  install(FILES packaging/debian/${component}.lintian-overrides RENAME ${package}
    DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides COMPONENT ${component})
endforeach()
include(CPack)
