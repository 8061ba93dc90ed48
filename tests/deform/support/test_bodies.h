// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies and systems for the tests of the linear solvers: bars and branching trees of bricks cut
// into tetrahedra, and the matrix M + dt^2 K of their (rotated) linear elasticity.
#pragma once

#include <functional>
#include <vector>

#include "core/deform/body/body.h"
#include "core/deform/solvers/block_matrix.h"
#include "core/deform/solvers/coarse_skeleton.h"
#include "core/mesh/tet_mesh.h"

namespace hepatica::test {

struct SampleBody {
    TetMesh mesh;
    std::vector<char> fixed;  // per vertex
    CoarseSkeleton skeleton;
};

// A bar along x from the origin, square section, fixed at x = 0.
SampleBody make_bar(double length_mm, double width_mm, int cells_along, int cells_across);

// A tree of bricks: every branch forks into two of 0.8 times its radius; fixed at its root.
SampleBody make_brick_tree(int generations, double root_radius_mm, double cell_mm);

// The same for a stepper.
BodyDescription description_of(const SampleBody& body);

// The vertex nearest to the end of the last twig of the skeleton.
int tip_of(const BodyDescription& body);

// The body bent into a circle in the x-y plane: `angle_rad` over `length_mm` of x.
std::vector<Vec3> bend(const std::vector<Vec3>& positions_mm, double angle_rad, double length_mm);

struct SampleMaterial {
    double young_pa = 0.5e6;
    double poisson = 0.45;
    double density_g_mm3 = 1.06e-3;
    double dt_s = 1.0 / 60.0;
};

// Lumped at the vertices [g]: what assemble() adds to the diagonal.
std::vector<double> vertex_masses(const SampleBody& body, const SampleMaterial& material);

// M + dt^2 K, stiffness rotated by each tetrahedron's rotation from rest to `positions_mm`.
// Fixed vertices keep their mass only.
BlockMatrix assemble(const SampleBody& body, const std::vector<Vec3>& positions_mm,
                     const SampleMaterial& material);

// Gravity along -y over one step plus a pull at the last vertex; zero on fixed vertices.
std::vector<Vec3> make_load(const SampleBody& body, const SampleMaterial& material);

// Exact solution by Eigen's sparse factorisation.
std::vector<Vec3> solve_exactly(const BlockMatrix& matrix, const std::vector<Vec3>& rhs);

double energy_norm(const BlockMatrix& matrix, const std::vector<Vec3>& x);

// |x - exact|_A / |exact|_A
double energy_error(const BlockMatrix& matrix, const std::vector<Vec3>& x,
                    const std::vector<Vec3>& exact);

}  // namespace hepatica::test
