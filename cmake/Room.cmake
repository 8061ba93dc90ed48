# SPDX-License-Identifier: GPL-3.0-or-later
# hepatica_room(NAME SOURCES a.cpp ... [LINK target ...] [PRIVATE_LINK target ...])
# A room is a folder and a static library hepatica_NAME; LINK is what its headers may include.
function(hepatica_room name)
    cmake_parse_arguments(ROOM "" "" "SOURCES;LINK;PRIVATE_LINK" ${ARGN})
    add_library(hepatica_${name} STATIC ${ROOM_SOURCES})
    target_include_directories(hepatica_${name} PUBLIC ${PROJECT_SOURCE_DIR})
    target_compile_options(hepatica_${name} PRIVATE
        $<$<COMPILE_LANGUAGE:CXX>:${HEPATICA_COMPILE_OPTIONS}>)
    target_link_libraries(hepatica_${name} PUBLIC ${ROOM_LINK} PRIVATE ${ROOM_PRIVATE_LINK})
endfunction()

# hepatica_ctest(PREFIX [TOGETHER suite ...] [LABELS label ...]): what ctest knows of PREFIX_tests. Every TEST is
# an entry, and so a process, of its own; but a suite of TOGETHER is one entry, as its tests share a patient
# that costs more than most of them. Such entries begin first, so that none of them is left alone at the end.
function(hepatica_ctest prefix)
    cmake_parse_arguments(CTEST "" "" "TOGETHER;LABELS" ${ARGN})
    foreach(suite ${CTEST_TOGETHER})
        add_test(NAME ${prefix}.${suite} COMMAND ${prefix}_tests --gtest_filter=${suite}.*)
        set_tests_properties(${prefix}.${suite} PROPERTIES LABELS "${CTEST_LABELS}" TIMEOUT 1800 COST 1
            FAIL_REGULAR_EXPRESSION "Running 0 tests")
    endforeach()
    list(TRANSFORM CTEST_TOGETHER APPEND ".*")
    list(JOIN CTEST_TOGETHER ":" together)
    gtest_discover_tests(${prefix}_tests TEST_PREFIX "${prefix}." DISCOVERY_MODE PRE_TEST
        TEST_FILTER "-${together}" PROPERTIES LABELS "${CTEST_LABELS}" TIMEOUT 300)
endfunction()

# Tests are compiled at -O1, in two thirds of the time: of what they test, they compile hardly more than copies of structs.
function(hepatica_compile_quickly target)
    target_compile_options(${target} PRIVATE $<$<AND:$<CONFIG:Release>,$<COMPILE_LANGUAGE:CXX>>:-O1>)
endfunction()

# hepatica_tests(NAME [AS_SHIPPED] SOURCES a_test.cpp ... [OF_THREADS b_test.cpp ...] [LINK target ...]
# [TOGETHER suite ...] [LABELS label ...]): one test program per room. AS_SHIPPED are tests that compile templates of
# what they test, or of Eigen's that it computes with: the linker takes theirs for the room's, and so they are
# compiled as the room is. OF_THREADS are further sources, those with tests of what threads share: where they are
# named, the thread sanitizer builds nothing else.
function(hepatica_tests name)
    cmake_parse_arguments(TESTS "AS_SHIPPED" "" "SOURCES;OF_THREADS;LINK;TOGETHER;LABELS" ${ARGN})
    if(TESTS_OF_THREADS AND HEPATICA_SANITIZE MATCHES thread)
        set(TESTS_SOURCES)
    endif()
    add_executable(${name}_tests ${TESTS_SOURCES} ${TESTS_OF_THREADS}
        ${PROJECT_SOURCE_DIR}/tests/support/test_main.cpp)
    target_include_directories(${name}_tests PRIVATE ${PROJECT_SOURCE_DIR})
    target_compile_options(${name}_tests PRIVATE
        $<$<COMPILE_LANGUAGE:CXX>:${HEPATICA_COMPILE_OPTIONS}>)
    if(NOT TESTS_AS_SHIPPED)
        hepatica_compile_quickly(${name}_tests)
    endif()
    target_link_libraries(${name}_tests PRIVATE ${TESTS_LINK} hepatica_test_support GTest::gmock GTest::gtest)
    hepatica_ctest(${name} TOGETHER ${TESTS_TOGETHER} LABELS ${name} ${TESTS_LABELS})
endfunction()
