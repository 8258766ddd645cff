# Run by cpack on the installed files of all packages: compresses the pages as Debian requires, moves kerf.pc, which
# names no architecture, to where cross compilers find it, and removes the search path of the Python module, which
# finds the library in /usr/lib. A build configured for the prefix /usr has kerf.pc in the folder of the architecture,
# where they find it too.
set(root ${CPACK_TEMPORARY_INSTALL_DIRECTORY})
file(GLOB_RECURSE pages ${root}/kerf.1 ${root}/changelog)
foreach(page IN LISTS pages)
  execute_process(COMMAND gzip -9nf ${page} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
if(EXISTS ${root}/development/usr/lib/pkgconfig/kerf.pc)
  file(MAKE_DIRECTORY ${root}/development/usr/share/pkgconfig)
  file(RENAME ${root}/development/usr/lib/pkgconfig/kerf.pc ${root}/development/usr/share/pkgconfig/kerf.pc)
  file(REMOVE_RECURSE ${root}/development/usr/lib/pkgconfig)
endif()
file(GLOB_RECURSE modules ${root}/_kerf*.so)
foreach(module IN LISTS modules)
  file(RPATH_REMOVE FILE ${module})
endforeach()
