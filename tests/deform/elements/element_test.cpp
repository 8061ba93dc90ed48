// SPDX-License-Identifier: GPL-3.0-or-later
// Element functions against finite differences, rigid motion, the patch test and Hooke's law.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "core/base/error.h"
#include "core/deform/body/body.h"
#include "core/deform/body/element_dispatch.h"
#include "core/mesh/brick_mesh.h"
#include "tests/deform/support/element_choice.h"

namespace hepatica {
namespace {

using small::Tangent;

struct Choice : test::ElementChoice {
    double poisson_ratio;
};

// One irregular element of each kind.
Body one_element(const Choice& choice) {
    BodyDescription d;
    if (choice.hexahedra) {
        const HexMesh brick = hexahedral_brick(Vec3(2, 1.5, 1), {1, 1, 1});
        d.mesh.vertices_mm = brick.vertices_mm;
        d.hexahedra = brick.hexahedra;
        d.mesh.vertices_mm[6] += Vec3(0.3, 0.1, 0.2);
        d.mesh.vertices_mm[1] += Vec3(-0.2, 0.1, 0.05);
    } else {
        d.mesh.vertices_mm = {Vec3(0.1, 0, 0), Vec3(1.3, 0.2, 0.1), Vec3(0.2, 0.9, -0.1),
                              Vec3(0.3, 0.25, 1.2)};
        d.mesh.tetrahedra = {{0, 1, 2, 3}};
    }
    d.material.young_modulus_pa = 1000.0;
    d.material.poisson_ratio = choice.poisson_ratio;
    return build_body(d, choice.model, choice.order);
}

struct Response {
    double energy;
    Eigen::VectorXd force;
    Eigen::MatrixXd stiffness;
};

template <Tangent tangent>
Response respond(const Body& body, const std::vector<Vec3>& positions) {
    const ElementGroup& group = body.groups.front();
    const int n = group.nodes_per_element;
    small::Vector3<double> force[10];
    small::Matrix3<double> blocks[45];
    Response response{evaluate_element<tangent>(group, body.model, 0, positions, force, blocks),
                      Eigen::VectorXd::Zero(3 * body.node_count()),
                      Eigen::MatrixXd::Zero(3 * body.node_count(), 3 * body.node_count())};
    for (int a = 0, k = 0; a < n; ++a) {
        const int i = group.connectivity[a];
        response.force.segment<3>(3 * i) = small::to_eigen(force[a]);
        for (int b = a + 1; b < n && tangent != Tangent::none; ++b, ++k) {
            const int j = group.connectivity[b];
            const Mat3 block = small::to_eigen(blocks[k]);
            response.stiffness.block<3, 3>(3 * i, 3 * j) = block;
            response.stiffness.block<3, 3>(3 * j, 3 * i) = block.transpose();
            response.stiffness.block<3, 3>(3 * i, 3 * i) -= block;
            response.stiffness.block<3, 3>(3 * j, 3 * j) -= block.transpose();
        }
    }
    return response;
}

std::vector<Vec3> perturbed(const Body& body, double size, unsigned seed) {
    std::mt19937_64 random(seed);
    std::vector<Vec3> x = body.rest_positions_mm;
    for (Vec3& p : x)
        for (int i = 0; i < 3; ++i)
            p[i] += size * (static_cast<double>(random() >> 11) * 0x1.0p-52 - 1.0);
    return x;
}

class Element : public testing::TestWithParam<Choice> {};

// By central differences.
void expect_force_is_gradient(const Body& body, std::vector<Vec3> x, const std::string& shape) {
    const Response response = respond<Tangent::none>(body, x);
    const double h = 1e-6, scale = response.force.norm();
    for (int i = 0; i < body.node_count(); ++i)
        for (int c = 0; c < 3; ++c) {
            const double kept = x[i][c];
            x[i][c] = kept + h;
            const double above = respond<Tangent::none>(body, x).energy;
            x[i][c] = kept - h;
            const double below = respond<Tangent::none>(body, x).energy;
            x[i][c] = kept;
            EXPECT_NEAR(response.force[3 * i + c], -(above - below) / (2 * h), 3e-6 * scale)
                << shape << ", node " << i << ", component " << c;
        }
}

TEST_P(Element, ForceIsTheGradientOfTheEnergy) {
    const Body body = one_element(GetParam());
    for (unsigned seed = 1; seed <= 20; ++seed)
        expect_force_is_gradient(body, perturbed(body, 0.2, seed), "near rest");
}

// Every branch of the elements: the hexahedron's guard (below 0.3 of the volume), the rotation by
// decomposition (below 0.01 of the volume and beyond ten times the size), flat and inverted. All
// are away from where the rotation is not unique and an energy has no gradient.
TEST_P(Element, ForceIsTheGradientOfTheEnergyWhereItIsCrushedFlatInvertedAndStretched) {
    const Body body = one_element(GetParam());
    struct Shape {
        const char* name;
        Vec3 stretch;
        double noise;  // mm
    };
    for (const Shape& shape :
         {Shape{"guarded", Vec3(1, 1, 0.2), 0.03},
          Shape{"guarded sideways", Vec3(0.4, 1, 0.5), 0.03},
          Shape{"nearly flat", Vec3(1, 1, 0.005), 0.002}, Shape{"flat", Vec3(0.9, 1, 0), 0.0},
          Shape{"inverted", Vec3(1, 1.1, -0.3), 0.03},
          Shape{"far inverted", Vec3(1.5, 1.2, -0.7), 0.03},
          Shape{"small", Vec3(0.15, 0.2, 0.1), 0.005}, Shape{"stretched", Vec3(9, 6, 7), 0.3}})
        for (unsigned seed = 1; seed <= 5; ++seed) {
            std::vector<Vec3> x = perturbed(body, shape.noise, seed);
            const Eigen::Quaterniond turn = Eigen::Quaterniond(0.5, -0.2, 0.3, seed).normalized();
            for (Vec3& p : x) p = turn * p.cwiseProduct(shape.stretch);
            expect_force_is_gradient(body, x, shape.name);
        }
}

// Two corners in one place: that spring has no direction and pushes along none.
TEST(SpringElement, ACollapsedEdgeHasTheGradientOfItsEnergy) {
    const Body body =
        one_element(Choice{"spring", ElementModel::spring, ElementOrder::linear, false, 0.3});
    std::vector<Vec3> x = perturbed(body, 0.05, 7);
    x[1] = x[0];
    expect_force_is_gradient(body, x, "collapsed edge");
}

TEST_P(Element, RestIsFreeOfForceAndRigidMotionCostsNothing) {
    const Body body = one_element(GetParam());
    const Eigen::Quaterniond turn = Eigen::Quaterniond(0.3, -0.5, 0.7, 0.2).normalized();
    std::vector<Vec3> x = body.rest_positions_mm;
    const double stiff = respond<Tangent::rotated>(body, x).stiffness.norm();
    EXPECT_LT(respond<Tangent::none>(body, x).force.norm(), 1e-12 * stiff);
    for (Vec3& p : x) p = turn * p + Vec3(100, -50, 20);
    const Response response = respond<Tangent::none>(body, x);
    EXPECT_LT(response.force.norm(), 1e-10 * stiff);
    EXPECT_NEAR(response.energy, 0.0, 1e-10 * stiff);
}

TEST_P(Element, ForcesAndTorquesBalance) {
    const Body body = one_element(GetParam());
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const std::vector<Vec3> x = perturbed(body, 0.4, seed);
        const Eigen::VectorXd force = respond<Tangent::none>(body, x).force;
        Vec3 sum = Vec3::Zero(), torque = Vec3::Zero();
        for (int i = 0; i < body.node_count(); ++i) {
            sum += force.segment<3>(3 * i);
            torque += x[i].cross(Vec3(force.segment<3>(3 * i)));
        }
        EXPECT_LT(sum.norm(), 1e-13 * force.norm());
        EXPECT_LT(torque.norm(), 1e-11 * force.norm());
    }
}

// At rest every stiffness is the derivative of the force; everywhere it is positive semidefinite.
TEST_P(Element, StiffnessIsTheDerivativeAtRestAndNeverNegative) {
    const Body body = one_element(GetParam());
    std::vector<Vec3> x = body.rest_positions_mm;
    for (const bool projected : {false, true}) {
        const auto at = [&](const std::vector<Vec3>& p) {
            return projected ? respond<Tangent::projected>(body, p)
                             : respond<Tangent::rotated>(body, p);
        };
        const Eigen::MatrixXd k = at(x).stiffness;
        const double h = 1e-6;
        for (int i = 0; i < body.node_count(); ++i)
            for (int c = 0; c < 3; ++c) {
                const double kept = x[i][c];
                x[i][c] = kept + h;
                Eigen::VectorXd difference = respond<Tangent::none>(body, x).force;
                x[i][c] = kept - h;
                difference -= respond<Tangent::none>(body, x).force;
                x[i][c] = kept;
                EXPECT_LT((k.col(3 * i + c) + difference / (2 * h)).norm(), 1e-6 * k.norm());
            }
        for (unsigned seed = 1; seed <= 40; ++seed) {
            const Eigen::MatrixXd away = at(perturbed(body, seed % 2 ? 0.3 : 3.0, seed)).stiffness;
            const Eigen::VectorXd eigenvalues =
                Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(away).eigenvalues();
            EXPECT_GT(eigenvalues[0], -1e-10 * eigenvalues[eigenvalues.size() - 1]);
        }
    }
}

// Flat, inverted and collapsed elements: energy and finite forces.
TEST_P(Element, IsFiniteInAnyShape) {
    const Body body = one_element(GetParam());
    for (const Vec3& squash : {Vec3(1, 1, 0), Vec3(1, 0, 0), Vec3(1, 1, -1), Vec3(1, 1, 1e-12),
                               Vec3(0.1, 0.2, -3), Vec3(30, 20, 10)}) {
        std::vector<Vec3> x = body.rest_positions_mm;
        for (Vec3& p : x) p = p.cwiseProduct(squash);
        const Response response = respond<Tangent::projected>(body, x);
        ASSERT_TRUE(response.force.allFinite());
        ASSERT_TRUE(response.stiffness.allFinite());
        EXPECT_GT(response.energy, 0.0);
    }
    std::vector<Vec3> point(body.node_count(), Vec3(1, 2, 3));
    const Response response = respond<Tangent::projected>(body, point);
    EXPECT_TRUE(response.force.allFinite() && response.stiffness.allFinite());
}

// Descent of the energy along the forces, preconditioned by the projected stiffness, with a step
// length that halves until the energy falls.
double energy_after_descent(const Body& body, std::vector<Vec3>& x, int steps) {
    double energy = respond<Tangent::none>(body, x).energy;
    for (int step = 0; step < steps; ++step) {
        const Response response = respond<Tangent::projected>(body, x);
        Eigen::MatrixXd matrix = response.stiffness;
        matrix.diagonal().array() += 1e-4 * matrix.norm();
        const Eigen::VectorXd direction = matrix.ldlt().solve(response.force);
        for (double length = 1.0; length > 1e-12; length *= 0.5) {
            std::vector<Vec3> next = x;
            for (int i = 0; i < body.node_count(); ++i)
                next[i] += length * direction.segment<3>(3 * i);
            const double below = respond<Tangent::none>(body, next).energy;
            if (!(below < energy)) continue;
            energy = below;
            x = std::move(next);
            break;
        }
    }
    return energy;
}

// What was pressed flat, pushed through itself, crushed or stretched goes back to rest downhill by
// its forces alone. A small disturbance takes it off the ridge that symmetry makes of flatness.
TEST_P(Element, RecoversFromAnyShape) {
    const Body body = one_element(GetParam());
    for (const Vec3& squash :
         {Vec3(1, 1, 0), Vec3(1, 1, -0.2), Vec3(0.2, 0.3, 0.1), Vec3(3, 2, 2.5)}) {
        std::vector<Vec3> x = perturbed(body, 0.02, 3);
        for (Vec3& p : x) p = p.cwiseProduct(squash);
        const double start = respond<Tangent::none>(body, x).energy;
        EXPECT_LT(energy_after_descent(body, x, 500), 1e-6 * start) << squash.transpose();
    }
}

// Right-handed at all eight corners, inside out within: seen at an integration point only.
TEST(HexahedronElement, AFoldBetweenCornersIsSeen) {
    BodyDescription d;
    d.mesh.vertices_mm = {Vec3(-0.8, 0, -1.6),  Vec3(2.7, 0.2, -0.1),  Vec3(-0.2, 0.1, 1.2),
                          Vec3(-0.2, 1.7, 0.3), Vec3(-0.9, -0.8, 0.3), Vec3(0.2, -1.4, 3.9),
                          Vec3(0.8, 0.5, -1.2), Vec3(-0.5, 1.5, 1.5)};
    d.hexahedra = {{0, 1, 2, 3, 4, 5, 6, 7}};
    small::Vector3<double> x[8], gradient[8];
    for (int a = 0; a < 8; ++a) x[a] = small::from_eigen(d.mesh.vertices_mm[a]);
    for (int a = 0; a < 8; ++a) {
        int sign[3];
        small::detail::hexahedron_corner(a, sign);
        const double corner[3] = {1.0 * sign[0], 1.0 * sign[1], 1.0 * sign[2]};
        small::detail::parent_gradients(corner, gradient);
        EXPECT_GT(determinant(small::detail::jacobian(x, gradient)), 0.0);
    }
    EXPECT_LT(small::least_jacobian(x), 0.0);
    EXPECT_THROW(build_body(d, ElementModel::corotated, ElementOrder::linear), InputError);
}

// Constant small strain: the energy of Hooke's law, whatever the shape of the element.
TEST_P(Element, SmallConstantStrainObeysHooke) {
    if (GetParam().model == ElementModel::spring) GTEST_SKIP() << "springs are not an exact solid";
    const Body body = one_element(GetParam());
    Mat3 strain;
    strain << 3e-6, 1e-6, -2e-6, 1e-6, -4e-6, 5e-7, -2e-6, 5e-7, 2e-6;
    std::vector<Vec3> x = body.rest_positions_mm;
    for (Vec3& p : x) p += strain * p;
    double volume = 0.0;
    for (const double m : body.mass_g) volume += m / Material{}.density_g_mm3;
    const Lame lame =
        lame_of({.young_modulus_pa = 1000.0, .poisson_ratio = GetParam().poisson_ratio});
    const double density =
        0.5 * lame.lambda_pa * strain.trace() * strain.trace() + lame.mu_pa * strain.squaredNorm();
    EXPECT_NEAR(respond<Tangent::none>(body, x).energy / (volume * density), 1.0, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(
    All, Element,
    testing::Values(
        Choice{"spring", ElementModel::spring, ElementOrder::linear, false, 0.3},
        Choice{"corotated", ElementModel::corotated, ElementOrder::linear, false, 0.3},
        Choice{"neohookean", ElementModel::neohookean, ElementOrder::linear, false, 0.3},
        Choice{"corotated_nu0", ElementModel::corotated, ElementOrder::linear, false, 0.0},
        Choice{"neohookean_nu0", ElementModel::neohookean, ElementOrder::linear, false, 0.0},
        Choice{"corotated10", ElementModel::corotated, ElementOrder::quadratic, false, 0.3},
        Choice{"corotated10_nu0499", ElementModel::corotated, ElementOrder::quadratic, false,
               0.499},
        Choice{"neohookean10", ElementModel::neohookean, ElementOrder::quadratic, false, 0.45},
        Choice{"hexahedron", ElementModel::corotated, ElementOrder::linear, true, 0.3},
        Choice{"hexahedron_nu0499", ElementModel::corotated, ElementOrder::linear, true, 0.499}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace hepatica
