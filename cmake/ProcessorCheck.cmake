# SPDX-License-Identifier: GPL-3.0-or-later
# hepatica_check_processor(TARGET): a program that says which instructions the processor lacks, instead
# of ending without a word. Nothing where the tree is compiled for other processors than x86-64-v3, or
# by sanitizers, which must begin before anything else, or without programs.
set(HEPATICA_CHECKS_PROCESSOR OFF)
if("${HEPATICA_CPU}" STREQUAL "x86-64-v3" AND NOT HEPATICA_SANITIZE AND NOT HEPATICA_SOLVER_ONLY)
    set(HEPATICA_CHECKS_PROCESSOR ON)
    add_library(hepatica_processor_check OBJECT ${PROJECT_SOURCE_DIR}/app/processor_check.cpp)
    set_target_properties(hepatica_processor_check PROPERTIES UNITY_BUILD OFF)
    target_include_directories(hepatica_processor_check PRIVATE ${PROJECT_SOURCE_DIR})
    # The last -march holds: this one file must run on every x86-64.
    target_compile_options(hepatica_processor_check PRIVATE ${HEPATICA_COMPILE_OPTIONS}
        -march=x86-64)
endif()

function(hepatica_check_processor target)
    if(HEPATICA_CHECKS_PROCESSOR)
        target_sources(${target} PRIVATE $<TARGET_OBJECTS:hepatica_processor_check>)
    endif()
endfunction()
