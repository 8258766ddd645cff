# cmake --install: the program with its data, and the library with its public headers. The target `distribution`
# builds exactly these. Each file belongs to the component of a package: program, library, development or python.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME program)
install(TARGETS kerf RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
# Images of the pages and generator scripts are not installed.
install(DIRECTORY ${CMAKE_SOURCE_DIR}/assets/ DESTINATION ${CMAKE_INSTALL_DATADIR}/kerf
  PATTERN "pictures" EXCLUDE PATTERN "install" EXCLUDE PATTERN "*.py" EXCLUDE PATTERN "*.md" EXCLUDE
  PATTERN "__pycache__" EXCLUDE PATTERN "materials.json" EXCLUDE)
# The library needs this one too.
install(FILES ${CMAKE_SOURCE_DIR}/assets/materials.json DESTINATION ${CMAKE_INSTALL_DATADIR}/kerf COMPONENT library)
set(extras ${CMAKE_SOURCE_DIR}/assets/install)
install(FILES ${extras}/kerf.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES ${extras}/kerf.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
install(FILES ${extras}/kerf.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages)
install(FILES ${extras}/kerf.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
install(FILES ${extras}/kerf.thumbnailer DESTINATION ${CMAKE_INSTALL_DATADIR}/thumbnailers)
install(FILES ${extras}/kerf.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME kerf)
install(FILES ${extras}/_kerf DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
install(FILES ${extras}/kerf.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
install(FILES ${CMAKE_BINARY_DIR}/kerf.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)

# find_package(kerf) provides kerf::core and kerf::c: the same library with and without C++20.
add_library(kerf_face_cpp INTERFACE)
target_link_libraries(kerf_face_cpp INTERFACE kerf_shared)
target_compile_features(kerf_face_cpp INTERFACE cxx_std_20)
add_library(kerf_face_c INTERFACE)
target_link_libraries(kerf_face_c INTERFACE kerf_shared)
set_target_properties(kerf_face_cpp PROPERTIES EXPORT_NAME core)
set_target_properties(kerf_face_c PROPERTIES EXPORT_NAME c)
set_target_properties(kerf_shared PROPERTIES EXPORT_NAME shared)
target_include_directories(kerf_shared INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
install(TARGETS kerf_shared kerf_face_cpp kerf_face_c EXPORT kerf_targets
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME development)
install(FILES ${CMAKE_SOURCE_DIR}/core/kerf.h ${CMAKE_SOURCE_DIR}/core/kerf_c.h
  ${CMAKE_SOURCE_DIR}/core/kerf_c_mesh.h
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/kerf)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/kerf)
install(EXPORT kerf_targets NAMESPACE kerf:: DESTINATION ${package} FILE kerfConfig.cmake)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/kerfConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/kerfConfigVersion.cmake DESTINATION ${package})
cmake_path(RELATIVE_PATH CMAKE_INSTALL_PREFIX BASE_DIRECTORY ${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_LIBDIR}/pkgconfig
  OUTPUT_VARIABLE up)
configure_file(${extras}/kerf.pc.in ${CMAKE_BINARY_DIR}/kerf.pc @ONLY)
install(FILES ${CMAKE_BINARY_DIR}/kerf.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
include(packages.cmake)
