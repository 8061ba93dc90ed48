// SPDX-License-Identifier: GPL-3.0-or-later
// What is gathered from the slots against the plain sum over the elements, one by one.
#include "core/deform/step/assembly.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "core/deform/body/element_dispatch.h"
#include "core/mesh/brick_mesh.h"
#include "tests/deform/support/element_choice.h"
#include "tests/deform/support/random_field.h"

namespace hepatica {
namespace {

using test::random_field;

using small::Tangent;

struct AssemblyChoice : test::ElementChoice {
    Tangent tangent;
};

BodyDescription brick(bool hexahedra) {
    BodyDescription body;
    const Vec3 size(3, 2, 1);
    if (hexahedra) {
        const HexMesh mesh = hexahedral_brick(size, {3, 2, 1});
        body.mesh.vertices_mm = mesh.vertices_mm;
        body.hexahedra = mesh.hexahedra;
    } else {
        body.mesh = kuhn_brick(size, {3, 2, 1});
        body.mesh.tetrahedra.pop_back();  // 35: no multiple of the lanes
        for (std::size_t e = 0; e < body.mesh.tetrahedra.size(); ++e)
            body.stiffness_factor.push_back(1.0 + 0.1 * static_cast<double>(e % 7));
    }
    return body;
}

struct Sum {
    double energy = 0.0;
    Eigen::VectorXd force;
    Eigen::MatrixXd stiffness;
};

template <Tangent tangent>
Sum sum_over_elements(const Body& body, const std::vector<Vec3>& x) {
    const int size = 3 * body.node_count();
    Sum sum{0.0, Eigen::VectorXd::Zero(size), Eigen::MatrixXd::Zero(size, size)};
    for (const ElementGroup& group : body.groups)
        for (int e = 0; e < group.size(); ++e) {
            small::Vector3<double> force[10];
            small::Matrix3<double> blocks[45];
            sum.energy += evaluate_element<tangent>(group, body.model, e, x, force, blocks);
            const int* nodes = group.connectivity.data() + e * group.nodes_per_element;
            for (int a = 0, k = 0; a < group.nodes_per_element; ++a) {
                sum.force.segment<3>(3 * nodes[a]) += small::to_eigen(force[a]);
                for (int b = a + 1; b < group.nodes_per_element; ++b, ++k) {
                    const Mat3 block = small::to_eigen(blocks[k]);
                    const int i = 3 * nodes[a], j = 3 * nodes[b];
                    sum.stiffness.block<3, 3>(i, j) += block;
                    sum.stiffness.block<3, 3>(j, i) += block.transpose();
                    sum.stiffness.block<3, 3>(i, i) -= block;
                    sum.stiffness.block<3, 3>(j, j) -= block.transpose();
                }
            }
        }
    return sum;
}

class GatheredElements : public testing::TestWithParam<AssemblyChoice> {};

TEST_P(GatheredElements, AreTheSumOverTheElements) {
    const AssemblyChoice& choice = GetParam();
    const Body body = build_body(brick(choice.hexahedra), choice.model, choice.order);
    std::vector<Vec3> x = body.rest_positions_mm;
    const auto noise = random_field(x.size(), 0.1, 3);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += noise[i];
    const Sum sum = choice.tangent == Tangent::rotated
                        ? sum_over_elements<Tangent::rotated>(body, x)
                        : sum_over_elements<Tangent::projected>(body, x);
    Assembly assembly(body, choice.tangent);
    EXPECT_NEAR(assembly.evaluate(x), sum.energy, 1e-13 * sum.energy);
    EXPECT_NEAR(assembly.energy(x), sum.energy, 1e-13 * sum.energy);
    std::vector<Vec3> forces(x.size());
    assembly.gather_forces(forces);
    const double stiff = sum.stiffness.norm();
    for (std::size_t i = 0; i < x.size(); ++i)
        EXPECT_LT((forces[i] - sum.force.segment<3>(3 * static_cast<int>(i))).norm(),
                  1e-13 * sum.force.norm());
    BlockMatrix matrix;
    assembly.gather_stiffness(2.0, matrix);
    for (int i = 0; i < matrix.rows(); ++i)
        for (int k = matrix.row_begin[i]; k < matrix.row_begin[i + 1]; ++k) {
            const int j = matrix.column[k];
            EXPECT_LT((matrix.block[k] - 2.0 * sum.stiffness.block<3, 3>(3 * i, 3 * j)).norm(),
                      1e-13 * stiff);
        }
    const auto d = random_field(x.size(), 1.0, 5);
    const Eigen::VectorXd flat =
        Eigen::Map<const Eigen::VectorXd>(d.front().data(), 3 * body.node_count());
    const double form = flat.dot(sum.stiffness * flat);
    EXPECT_NEAR(assembly.quadratic_form(d), form, 1e-12 * form);
    // Carried along rigidly: nothing, far from the origin too.
    EXPECT_LE(std::abs(assembly.quadratic_form(std::vector<Vec3>(x.size(), Vec3(1e6, -2e6, 3e6)))),
              0.0);
}

INSTANTIATE_TEST_SUITE_P(
    All, GatheredElements,
    testing::Values(AssemblyChoice{"spring", ElementModel::spring, ElementOrder::linear, false,
                                   Tangent::rotated},
                    AssemblyChoice{"corotated", ElementModel::corotated, ElementOrder::linear,
                                   false, Tangent::rotated},
                    AssemblyChoice{"corotated, projected", ElementModel::corotated,
                                   ElementOrder::linear, false, Tangent::projected},
                    AssemblyChoice{"neohookean", ElementModel::neohookean, ElementOrder::linear,
                                   false, Tangent::projected},
                    AssemblyChoice{"corotated-10", ElementModel::corotated, ElementOrder::quadratic,
                                   false, Tangent::rotated},
                    AssemblyChoice{"neohookean-10", ElementModel::neohookean,
                                   ElementOrder::quadratic, false, Tangent::projected},
                    AssemblyChoice{"hexahedron", ElementModel::corotated, ElementOrder::linear,
                                   true, Tangent::rotated}));

}  // namespace
}  // namespace hepatica
