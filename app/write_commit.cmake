# Writes the commit of the checkout ROOT into the header OUT unless it holds it already; an empty one where there is no git.
set(commit "")
find_program(GIT git)
if(GIT AND EXISTS ${ROOT}/.git)
  execute_process(COMMAND ${GIT} -C ${ROOT} rev-parse --short=10 HEAD OUTPUT_VARIABLE commit
    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
file(CONFIGURE OUTPUT ${OUT} CONTENT "#define KERF_COMMIT \"${commit}\"\n" @ONLY)
