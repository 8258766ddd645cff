# cpack -G DEB: the packages kerf, libkerf0, libkerf-dev and python3-kerf, one per component.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME kerf)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "The Kerf project <kerf@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "laser cutter for triangle meshes")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(library libkerf${PROJECT_VERSION_MAJOR})
set(same_library "${library} (= ${PROJECT_VERSION})")
set(debian ${CMAKE_SOURCE_DIR}/assets/install/debian)

# add_package(COMPONENT NAME SECTION SYNOPSIS DESCRIPTION): a package with the files of a component.
set(CPACK_COMPONENTS_ALL)
macro(add_package component name section synopsis description)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  string(TOUPPER ${component} prefix)
  set(CPACK_DEBIAN_${prefix}_PACKAGE_NAME ${name})
  set(CPACK_DEBIAN_${prefix}_PACKAGE_SECTION ${section})
  set(CPACK_DEBIAN_${prefix}_DESCRIPTION "${synopsis}\n${description}")
  foreach(file copyright changelog)
    install(FILES ${CMAKE_BINARY_DIR}/debian/${file} DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name}
      COMPONENT ${component})
  endforeach()
endmacro()

add_package(program kerf graphics "editor in which a laser cuts triangle meshes"
  "Kerf cuts triangle meshes with a laser, live or along a path file. Pieces\nfall and collide, and a thermal model follows the power of the beam.\nThis package contains the editor, the game and the command line.")
add_package(library ${library} libs "laser cutter for triangle meshes, shared library"
  "Kerf cuts triangle meshes with a laser, live or along a path.\nThis package contains the library for programs in C and C++ and its\ntable of materials.")
add_package(development libkerf-dev libdevel "laser cutter for triangle meshes, headers"
  "Kerf cuts triangle meshes with a laser, live or along a path.\nThis package contains the headers for C and C++, and the files by which\nCMake and pkg-config find the library.")
if(TARGET kerf_python)
  add_package(python python3-kerf python "laser cutter for triangle meshes, Python module"
    "Kerf cuts triangle meshes with a laser, live or along a path.\nThis package contains the Python module, which exchanges meshes as NumPy\narrays.")
endif()

# shlibdeps finds linked libraries; the others are opened at run time: OpenGL with its drivers, libraries that GLFW
# loads, and the font of the panels. The table of materials is part of the library's package.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "${same_library}, libgl1, libegl1, libgl1-mesa-dri, libegl-mesa0, libxrandr2, libxcursor1, libxi6, libxinerama1, fonts-roboto-unhinted")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "python3-kerf")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA "${debian}/triggers;${CMAKE_BINARY_DIR}/debian/shlibs")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${same_library}")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
# The module is built for one minor version of Python.
if(TARGET kerf_python)
  math(EXPR next "${KERF_PYTHON_MINOR} + 1")
endif()
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "${same_library}, python3-numpy, python3 (>= 3.${KERF_PYTHON_MINOR}), python3 (<< 3.${next})")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA "${debian}/postinst;${debian}/prerm")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_BINARY_DIR})

file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/debian/shlibs CONTENT
  "libkerf ${PROJECT_VERSION_MAJOR} ${library} (>= ${PROJECT_VERSION})\n" @ONLY)
configure_file(${debian}/changelog.in ${CMAKE_BINARY_DIR}/debian/changelog @ONLY)
configure_file(${debian}/copyright ${CMAKE_BINARY_DIR}/debian/copyright COPYONLY)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_SOURCE_DIR}/finish_package.cmake)
include(CPack)
