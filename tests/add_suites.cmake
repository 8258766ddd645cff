# add_suites(TARGET FILE...): adds the tests of a program that was built from these files.
#
# Each test is a process. With sanitizers a process takes more than a second to start and end, so each suite is one: the
# first argument of TEST, TEST_F or TEST_P.
include(GoogleTest)

function(add_suites target)
  if(NOT KERF_SANITIZE)
    gtest_discover_tests(${target} DISCOVERY_MODE PRE_TEST PROPERTIES TIMEOUT 600)
    return()
  endif()
  set(suites)
  foreach(file IN LISTS ARGN)
    file(STRINGS ${file} begun REGEX "^TEST(_F|_P)?\\(")
    foreach(line IN LISTS begun)
      string(REGEX REPLACE "^TEST(_F|_P)?\\(([A-Za-z0-9_]+).*" "\\2" suite "${line}")
      list(APPEND suites ${suite})
    endforeach()
  endforeach()
  list(REMOVE_DUPLICATES suites)
  foreach(suite IN LISTS suites)
    add_test(NAME ${suite} COMMAND ${target} --gtest_filter=${suite}.*:*/${suite}.*)
    set_tests_properties(${suite} PROPERTIES TIMEOUT 1800)
  endforeach()
endfunction()
