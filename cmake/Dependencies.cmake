# SPDX-License-Identifier: GPL-3.0-or-later
# Everything comes from Debian's own packages: see scripts/packages.txt.
include(GoogleTest)

if(HEPATICA_SOLVER_ONLY)
    # A GPU server often has neither TBB nor GoogleTest nor Eigen installed: sources copied into
    # third_party_local/ (ignored by git) serve instead.
    find_package(Eigen3 QUIET NO_MODULE)
    if(NOT TARGET Eigen3::Eigen)
        add_library(Eigen3::Eigen INTERFACE IMPORTED)
        target_include_directories(Eigen3::Eigen SYSTEM INTERFACE
            ${PROJECT_SOURCE_DIR}/third_party_local/eigen3)
    endif()
    find_package(GTest QUIET)
    if(NOT TARGET GTest::gtest_main)
        add_subdirectory(${PROJECT_SOURCE_DIR}/third_party_local/googletest googletest
                         EXCLUDE_FROM_ALL)
        add_library(GTest::gtest ALIAS gtest)
        add_library(GTest::gmock ALIAS gmock)
        add_library(GTest::gtest_main ALIAS gtest_main)
    endif()
    find_package(Threads REQUIRED)
else()
    # VTK's targets name MPI::MPI_C, which must exist before VTK is found.
    find_package(MPI REQUIRED COMPONENTS C)
    find_package(Eigen3 3.4 REQUIRED NO_MODULE)
    find_package(TBB REQUIRED)
    find_package(Threads REQUIRED)
    find_package(nlohmann_json REQUIRED)
    find_package(CLI11 REQUIRED)
    find_package(spdlog REQUIRED)
    find_package(GTest REQUIRED)
    find_package(benchmark REQUIRED)
    find_package(ZLIB REQUIRED)
    find_package(PkgConfig REQUIRED)
    pkg_check_modules(minizip REQUIRED IMPORTED_TARGET minizip)
    find_package(OpenCV 4.6 REQUIRED COMPONENTS core imgproc ml)
    find_package(CGAL 5.5 REQUIRED)
    find_package(Bullet REQUIRED)
    find_package(GDCM 3.0 REQUIRED)
    # DCMTK's own CMake files want every library that any part of it could use; a few do here.
    find_path(DCMTK_INCLUDE_DIR dcmtk/dcmdata/dctk.h REQUIRED)
    add_library(hepatica_dcmtk INTERFACE)
    target_include_directories(hepatica_dcmtk SYSTEM INTERFACE ${DCMTK_INCLUDE_DIR})
    foreach(part dcmdata oflog ofstd dcmseg dcmfg dcmiod)
        find_library(DCMTK_${part}_LIBRARY ${part} REQUIRED)
    endforeach()
    target_link_libraries(hepatica_dcmtk INTERFACE
        ${DCMTK_dcmdata_LIBRARY} ${DCMTK_oflog_LIBRARY} ${DCMTK_ofstd_LIBRARY})
    add_library(hepatica_dcmtk_segmentation INTERFACE)
    target_link_libraries(hepatica_dcmtk_segmentation INTERFACE hepatica_dcmtk
        ${DCMTK_dcmseg_LIBRARY} ${DCMTK_dcmfg_LIBRARY} ${DCMTK_dcmiod_LIBRARY})
    find_package(ITK 5.2 REQUIRED COMPONENTS ITKCommon ITKIOImageBase ITKIOGDCM ITKIONIFTI
        ITKIOMeta ITKIONRRD)
    set(vtk_components CommonCore CommonDataModel IOXML IOLegacy)
    if(HEPATICA_WINDOW)
        list(APPEND vtk_components IOImage FiltersCore FiltersSources FiltersGeneral
            ImagingCore InteractionStyle RenderingCore RenderingOpenGL2 RenderingFreeType RenderingAnnotation
            RenderingUI RenderingVolume RenderingVolumeOpenGL2 ChartsCore ViewsContext2D RenderingContextOpenGL2)
        find_package(Qt6 6.4 REQUIRED COMPONENTS Core Gui Widgets OpenGL OpenGLWidgets Multimedia Test)
    endif()
    if(HEPATICA_UI_THREADS)
        find_package(Qt6 6.4 REQUIRED COMPONENTS Core)
    endif()
    find_package(VTK 9.1 REQUIRED COMPONENTS ${vtk_components})
endif()
