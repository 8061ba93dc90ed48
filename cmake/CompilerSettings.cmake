# SPDX-License-Identifier: GPL-3.0-or-later
# One set of compiler settings for the whole tree.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

# -ffp-contract=off: a fused multiply-add rounds once instead of twice, and the compiler chooses
# where; without it the same input gives the same bytes whatever is inlined.
set(HEPATICA_COMPILE_OPTIONS -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
    -Werror -ffp-contract=off)

# GCC 12 warns of overlapping copies inside std::string's own operator+ (GCC bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    list(APPEND HEPATICA_COMPILE_OPTIONS -Wno-restrict)
endif()

# AVX2 has been in desktop processors since 2013; HEPATICA_CPU=native or x86-64 chooses otherwise.
# Applied to the whole tree, because Eigen's alignment is part of the binary interface.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    set(HEPATICA_CPU "x86-64-v3" CACHE STRING "Value of -march=")
    add_compile_options($<$<COMPILE_LANGUAGE:C,CXX>:-march=${HEPATICA_CPU}>)
    # Registers of 32 bytes are then pairs of smaller ones. GCC warns of passing them between files
    # that disagree on that, and none of these do.
    if(HEPATICA_CPU MATCHES "^x86-64(-v2)?$")
        list(APPEND HEPATICA_COMPILE_OPTIONS -Wno-psabi)
    endif()
endif()

set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O1 -g1 -fno-omit-frame-pointer")

if(HEPATICA_SANITIZE)
    add_compile_options(-fsanitize=${HEPATICA_SANITIZE} -fno-sanitize-recover=all)
    add_link_options(-fsanitize=${HEPATICA_SANITIZE})
    # The sanitizers' own code makes gcc warn of variables that are always set.
    list(APPEND HEPATICA_COMPILE_OPTIONS -Wno-maybe-uninitialized)
    # A quarter of the time to compile is spent on these. What null pointers and objects that are too small do, the
    # address sanitizer finds as well; alignment is checked by the fuzzers, which clang compiles.
    if(HEPATICA_SANITIZE MATCHES address AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        add_compile_options(-fno-sanitize=null,object-size,alignment)
    endif()
endif()

# What a file calls its own must then differ from what its neighbours call theirs; a parameter that is
# called as another file's constant is no mistake.
if(HEPATICA_UNITY)
    set(CMAKE_UNITY_BUILD ON)
    set(CMAKE_UNITY_BUILD_BATCH_SIZE 8)
    list(APPEND HEPATICA_COMPILE_OPTIONS -Wno-shadow)
    # GCC then collects its garbage from 1 GB on: 44 s of processor time for eight files of tests and not 48, for a
    # quarter of a gigabyte more.
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        add_compile_options($<$<COMPILE_LANGUAGE:CXX>:--param=ggc-min-heapsize=1000000>)
    endif()
endif()

# Clang words its warnings otherwise than gcc, which every other preset is built with.
if(HEPATICA_FUZZ)
    add_compile_options(-fsanitize=fuzzer-no-link)
    list(REMOVE_ITEM HEPATICA_COMPILE_OPTIONS -Werror)
endif()

find_program(HEPATICA_CCACHE ccache)
if(HEPATICA_CCACHE)
    # Precompiled headers are only cached when ccache is told to trust their time stamps.
    set(ccache_launcher ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=1
        CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
        ${HEPATICA_CCACHE})
    set(CMAKE_C_COMPILER_LAUNCHER ${ccache_launcher})
    set(CMAKE_CXX_COMPILER_LAUNCHER ${ccache_launcher})
endif()
