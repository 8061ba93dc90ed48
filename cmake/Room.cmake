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

# hepatica_tests(NAME SOURCES a_test.cpp ... [OF_THREADS b_test.cpp ...] [LINK target ...] [LABELS label ...])
# One test program per room; ctest sees every TEST by its own name. OF_THREADS are further sources, those
# with tests of what threads share: where they are named, the thread sanitizer builds nothing else.
function(hepatica_tests name)
    cmake_parse_arguments(TESTS "" "" "SOURCES;OF_THREADS;LINK;LABELS" ${ARGN})
    if(TESTS_OF_THREADS AND HEPATICA_SANITIZE MATCHES thread)
        set(TESTS_SOURCES)
    endif()
    add_executable(${name}_tests ${TESTS_SOURCES} ${TESTS_OF_THREADS}
        ${PROJECT_SOURCE_DIR}/tests/support/test_main.cpp)
    target_include_directories(${name}_tests PRIVATE ${PROJECT_SOURCE_DIR})
    target_compile_options(${name}_tests PRIVATE
        $<$<COMPILE_LANGUAGE:CXX>:${HEPATICA_COMPILE_OPTIONS}>)
    target_link_libraries(${name}_tests PRIVATE ${TESTS_LINK} hepatica_test_support GTest::gmock GTest::gtest)
    gtest_discover_tests(${name}_tests TEST_PREFIX "${name}." DISCOVERY_MODE PRE_TEST
        PROPERTIES LABELS "${name};${TESTS_LABELS}" TIMEOUT 300)
endfunction()
