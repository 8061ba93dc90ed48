# SPDX-License-Identifier: GPL-3.0-or-later
# HEPATICA_CUDA: whether the GPU's back end is compiled with nvcc. AUTO does so where nvcc is; ON
# fails where it is not; without it the back end runs emulated on the processor alone.
set(HEPATICA_CUDA "AUTO" CACHE STRING "Compile for CUDA devices: ON, OFF or AUTO")
set_property(CACHE HEPATICA_CUDA PROPERTY STRINGS ON OFF AUTO)
# Machine code for Turing to Hopper, and PTX for what comes after.
set(HEPATICA_CUDA_ARCHITECTURES "75-real;80-real;86-real;90" CACHE STRING "As CUDA_ARCHITECTURES")

set(HEPATICA_HAS_CUDA OFF)
# A sanitizer sees nothing of a device's code, which takes minutes to compile.
if(NOT HEPATICA_CUDA STREQUAL "OFF" AND NOT (HEPATICA_SANITIZE AND HEPATICA_CUDA STREQUAL "AUTO"))
    find_program(HEPATICA_NVCC nvcc PATHS /usr/local/cuda/bin)
    if(HEPATICA_NVCC AND NOT DEFINED ENV{CUDACXX})
        set(ENV{CUDACXX} ${HEPATICA_NVCC})
    endif()
    include(CheckLanguage)
    check_language(CUDA)
    if(CMAKE_CUDA_COMPILER)
        enable_language(CUDA)
        set(HEPATICA_HAS_CUDA ON)
    elseif(HEPATICA_CUDA STREQUAL "ON")
        message(FATAL_ERROR "HEPATICA_CUDA is ON, but there is no nvcc that works. "
            "Install the CUDA toolkit or choose AUTO.")
    endif()
endif()
