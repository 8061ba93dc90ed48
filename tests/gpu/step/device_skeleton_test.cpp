// SPDX-License-Identifier: GPL-3.0-or-later
// The coarse correction of the device against P (P^T A P)^-1 P^T r, with the processor's P and a
// dense factor.
#include "gpu/step/device_skeleton.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <random>

#include "gpu/machine/emulator.h"
#include "tests/gpu/support/gpu_bodies.h"

namespace hepatica {
namespace {

using small::Matrix3;
using small::Vector3;

// A = m I + sum of differences, on the machine as SystemView has it and on the host in full.
template <class Real>
class Skeletal {
  public:
    Skeletal(const test::SampleBody& sample, std::shared_ptr<gpu::Machine> machine)
        : machine_(std::move(machine)),
          body_(build_body(description_of(sample), ElementModel::corotated, ElementOrder::linear)),
          plan_(plan_assembly(body_, small::Tangent::rotated)),
          skeleton_(sample.skeleton),
          device_(*machine_, skeleton_, body_.rest_positions_mm, plan_) {
        const std::size_t nodes = body_.rest_positions_mm.size();
        test::SampleBody free = sample;  // whose rows are whole where the body is held
        free.fixed.assign(nodes, 0);
        const BlockMatrix stiffness = test::assemble(free, free.mesh.vertices_mm, {});
        std::vector<int> row_begin{0}, column;
        std::vector<Matrix3<Real>> block;
        full_ = stiffness;
        for (std::size_t i = 0; i < nodes; ++i) {
            Mat3 diagonal = mass * Mat3::Identity();
            for (int k = stiffness.row_begin[i]; k < stiffness.row_begin[i + 1]; ++k) {
                if (k == stiffness.diagonal[i]) continue;
                column.push_back(stiffness.column[k]);
                Matrix3<Real> rounded;
                for (int r = 0; r < 3; ++r)
                    for (int c = 0; c < 3; ++c) {
                        rounded(r, c) = static_cast<Real>(stiffness.block[k](r, c));
                        full_.block[k](r, c) = double(rounded(r, c));
                    }
                block.push_back(rounded);
                diagonal -= full_.block[k];
            }
            full_.block[stiffness.diagonal[i]] = diagonal;
            row_begin.push_back(static_cast<int>(column.size()));
        }
        row_begin_ = {*machine_, row_begin};
        column_ = {*machine_, column};
        block_ = {*machine_, gpu::in_planes<Real>(block)};
        mass_ = {*machine_, std::vector<double>(nodes, mass)};
        tether_ = {*machine_, nodes};
        held_ = {*machine_, body_.fixed};
    }

    // What the device adds to 0, and what it should.
    std::array<std::vector<Vec3>, 2> corrections(const std::vector<Vec3>& shape,
                                                 const std::vector<Vec3>& residual) {
        return {on_device(shape, residual), exact(shape, residual)};
    }
    const Body& body() const { return body_; }
    // r . B r, B being the correction on the device: positive for every r that it answers.
    double work(const std::vector<Vec3>& shape, const std::vector<Vec3>& residual) {
        on_device(shape, residual);
        return work_;
    }

  private:
    static constexpr double mass = 0.01;

    std::vector<Vec3> on_device(const std::vector<Vec3>& shape, const std::vector<Vec3>& residual) {
        std::vector<Vector3<double>> positions;
        std::vector<Vector3<Real>> r;
        for (const Vec3& x : shape) positions.push_back({{x[0], x[1], x[2]}});
        for (const Vec3& x : residual)
            r.push_back(
                {{static_cast<Real>(x[0]), static_cast<Real>(x[1]), static_cast<Real>(x[2])}});
        const gpu::Array<Vector3<double>> position(*machine_, positions);
        const gpu::Array<Vector3<Real>> loads(*machine_, r);
        const gpu::Array<Vector3<Real>> z(*machine_, r.size());
        const gpu::Array<double> sums(*machine_, 2);
        gpu::WholeSum nodes(*machine_);
        nodes.resize(r.size());
        gpu::SystemView<Real> system{row_begin_.read(),
                                     column_.read(),
                                     {},
                                     gpu::MatrixPlanes<Real>(block_.read()),
                                     mass_.read(),
                                     tether_.read(),
                                     held_.read(),
                                     {},
                                     {},
                                     {.mass = 1.0, .stiffness = 1.0}};
        device_.prepare(system, position.read());
        device_.correct(nodes, loads.read(), z.view(), gpu::KeepSums<2>{sums.view()});
        z.download(r);
        std::array<double, 2> both{};
        sums.download(both);
        work_ = both[0];
        std::vector<Vec3> added;
        for (const Vector3<Real>& one : r) added.push_back({one[0], one[1], one[2]});
        return added;
    }
    std::vector<Vec3> exact(const std::vector<Vec3>& shape, const std::vector<Vec3>& residual) {
        AffineCoarseSpace space(skeleton_, bind_vertices(skeleton_, body_.rest_positions_mm),
                                full_);
        space.set_shape(shape, std::vector<char>(body_.fixed.begin(), body_.fixed.end()));
        BlockMatrix coarse = space.coarse_pattern();
        space.project(full_, coarse);
        Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(3 * coarse.rows(), 3 * coarse.rows());
        for (int i = 0; i < coarse.rows(); ++i)
            for (int k = coarse.row_begin[i]; k < coarse.row_begin[i + 1]; ++k)
                dense.block<3, 3>(3 * i, 3 * coarse.column[k]) = coarse.block[k];
        // A node that moves no vertex answers nothing; some vectors of a few vertices depend on
        // each other.
        for (int i = 0; i < dense.rows(); ++i)
            dense(i, i) = dense(i, i) > 0.0 ? (1.0 + 1e-12) * dense(i, i) : 1.0;
        std::vector<Vec3> load;
        space.restrict_to_nodes(residual, load);
        const Eigen::VectorXd motion =
            dense.ldlt().solve(Eigen::Map<const Eigen::VectorXd>(load[0].data(), dense.rows()));
        std::vector<Vec3> coarse_motion(load.size()), fine(residual.size(), Vec3::Zero());
        for (std::size_t k = 0; k < load.size(); ++k)
            coarse_motion[k] = motion.segment<3>(3 * static_cast<int>(k));
        space.add_motion(coarse_motion, fine);
        return fine;
    }

    std::shared_ptr<gpu::Machine> machine_;
    Body body_;
    AssemblyPlan plan_;
    CoarseSkeleton skeleton_;
    gpu::DeviceSkeleton<Real> device_;
    BlockMatrix full_;
    gpu::Array<int> row_begin_, column_;
    gpu::Array<Real> block_;
    gpu::Array<double> mass_, tether_;
    gpu::Array<std::uint8_t> held_;
    double work_ = 0.0;
};

std::vector<Vec3> random_residual(std::size_t nodes, unsigned seed = 7) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    std::vector<Vec3> residual;
    for (std::size_t i = 0; i < nodes; ++i)
        residual.push_back({any(random), any(random), any(random)});
    return residual;
}

struct SkeletalCase {
    std::string name;
    test::SampleBody body;
};

std::vector<SkeletalCase> skeletal_cases() {
    return {{"tree", test::make_brick_tree(3, 4.0, 2.0)},
            // Of more cuts than one block of threads solves.
            {"long bar", test::make_bar(600.0, 4.0, 150, 1)}};
}

std::vector<Vec3> bent(const Body& body) {
    std::vector<Vec3> shape = body.rest_positions_mm;
    for (Vec3& x : shape) x += Vec3(0.1 * std::sin(x.y()), 2.0 * std::sin(0.05 * x.x()), 0.0);
    return shape;
}

template <class Real>
double worst_difference(const test::SampleBody& body, std::shared_ptr<gpu::Machine> machine) {
    Skeletal<Real> skeletal(body, std::move(machine));
    const auto [device, exact] =
        skeletal.corrections(bent(skeletal.body()), random_residual(skeletal.body().fixed.size()));
    return test::relative_distance(device, exact);
}

TEST(DeviceSkeleton, CorrectsAsADenseFactorDoes) {
    for (const auto& [name, body] : skeletal_cases()) {
        SCOPED_TRACE(name);
        EXPECT_LT(worst_difference<double>(body, gpu::make_emulator()), 1e-6);
        EXPECT_LT(worst_difference<float>(body, gpu::make_emulator()), 1e-2);
    }
}

// A skeleton with more vectors than the mesh has numbers, as a patient's has, half of whose nodes
// have a thousandth of a vertex: many vectors all but depend on others. Conjugate gradients break
// down unless the correction stays positive definite.
test::SampleBody bar_of_too_many_nodes() {
    test::SampleBody body = test::make_bar(60.0, 4.0, 30, 1);
    CoarseSkeleton& dense = body.skeleton;
    dense = {};
    std::mt19937 random(11);
    std::uniform_real_distribution<double> any(-0.3, 0.3);
    for (int n = 0; n <= 60; ++n) {
        dense.positions_mm.emplace_back(n + 1e-3, 2.0 + any(random), 2.0 + any(random));
        dense.radii_mm.push_back(2.0);
        dense.parent.push_back(n - 1);
    }
    return body;
}

TEST(DeviceSkeleton, AnswersNoResidualWithItsOpposite) {
    Skeletal<float> skeletal(bar_of_too_many_nodes(), gpu::make_emulator());
    const std::vector<Vec3> shape = bent(skeletal.body());
    for (unsigned seed = 1; seed <= 12; ++seed)
        EXPECT_GT(skeletal.work(shape, random_residual(shape.size(), seed)), 0.0) << seed;
}

TEST(DeviceSkeleton, CorrectsOnADeviceAsWell) {
    const std::shared_ptr<gpu::Machine> machine = test::machine_of("device");
    if (!machine) GTEST_SKIP() << test::no_device_because();
    for (const auto& [name, body] : skeletal_cases()) {
        SCOPED_TRACE(name);
        EXPECT_LT(worst_difference<double>(body, machine), 1e-6);
    }
}

}  // namespace
}  // namespace hepatica
