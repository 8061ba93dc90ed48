// SPDX-License-Identifier: GPL-3.0-or-later
// What objects of this room hold before anyone has written to them.
#include "tests/support/initial_values.h"

#include <gtest/gtest.h>

#include "core/mesh/hex_mesh.h"
#include "core/mesh/manifold_attempts.h"
#include "core/mesh/quality.h"
#include "core/mesh/refinement.h"
#include "core/mesh/surface.h"
#include "core/mesh/tet_mesh.h"
#include "core/mesh/tetrahedralize.h"
#include "core/mesh/tube_field.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

TEST(MeshInitialFigures, AreThoseRecorded) {
    test::Figures figures;
    HEPATICA_ADD_INITIAL(figures, HexMesh);
    HEPATICA_ADD_INITIAL(figures, ManifoldMesh);
    HEPATICA_ADD_INITIAL(figures, MeshQuality);
    HEPATICA_ADD_INITIAL(figures, DihedralRange);
    HEPATICA_ADD_INITIAL(figures, MeshRefinementOptions);
    HEPATICA_ADD_INITIAL(figures, BodySurface);
    HEPATICA_ADD_INITIAL(figures, TetMesh);
    HEPATICA_ADD_INITIAL(figures, TriangleMesh);
    HEPATICA_ADD_INITIAL(figures, MeshOptions);
    HEPATICA_ADD_INITIAL(figures, TubeFieldOptions);
    test::expect_recorded("mesh", "initial", figures);
}

}  // namespace
}  // namespace hepatica
