// SPDX-License-Identifier: GPL-3.0-or-later
// The element functions in single precision, as a device will use them, through the published step
// written out once more: state, forces, stiffness and iteration in float, in differences; sums of
// energies in double. The stepper itself is double throughout.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/deform/body/body.h"
#include "core/deform/body/energy_ledger.h"
#include "core/deform/elements/tetrahedron_element.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/mesh/brick_mesh.h"

namespace hepatica {
namespace {

using Vector = small::Vector3<float>;
using Field = std::vector<Vector>;

constexpr float dt_s = 1.0F / 60.0F;
constexpr float gravity_mm_s2 = -9810.0F;

double dot(const Field& a, const Field& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (int c = 0; c < 3; ++c) sum += static_cast<double>(a[i][c]) * b[i][c];
    return sum;
}

// y + s x
Field sum_of(const Field& y, float s, const Field& x) {
    Field result(y);
    for (std::size_t i = 0; i < y.size(); ++i) result[i] = y[i] + s * x[i];
    return result;
}

class SingleBody {
  public:
    explicit SingleBody(const Body& body) : body_(body), x_(nodes()), v_(nodes()), f_(nodes()) {
        for (const auto& own : body.groups[0].tetrahedra) {
            small::TetrahedronRest<float> rest;
            for (int a = 0; a < 3; ++a)
                for (int i = 0; i < 3; ++i)
                    rest.gradient[a][i] = static_cast<float>(own.gradient[a][i]);
            rest.volume = static_cast<float>(own.volume);
            rest.lambda = static_cast<float>(own.lambda);
            rest.mu = static_cast<float>(own.mu);
            rest_.push_back(rest);
        }
        for (std::size_t i = 0; i < nodes(); ++i) {
            mass_.push_back(static_cast<float>(body.mass_g[i]));
            for (int c = 0; c < 3; ++c) {
                x_[i][c] = static_cast<float>(body.rest_positions_mm[i][c]);
                v_[i][c] = 0.0F;
            }
        }
        blocks_.resize(6 * rest_.size());
        evaluate();
    }

    EnergyLedger step();
    const Field& positions_mm() const { return x_; }

  private:
    std::size_t nodes() const { return body_.mass_g.size(); }
    const int* corners(std::size_t e) const { return &body_.groups[0].connectivity[4 * e]; }
    void release(Field& a) const {
        for (std::size_t i = 0; i < a.size(); ++i)
            if (body_.fixed[i]) a[i] = {{0.0F, 0.0F, 0.0F}};
    }
    double kinetic() const { return 0.5 * dot(v_, weighted(v_)); }
    Field weighted(const Field& a) const {
        Field result(a);
        for (std::size_t i = 0; i < a.size(); ++i) result[i] = mass_[i] * a[i];
        return result;
    }
    void evaluate();
    Field stiffness_times(const Field& d) const;
    Field system_times(const Field& d) const {
        Field result = sum_of(weighted(d), dt_s * dt_s, stiffness_times(d));
        release(result);
        return result;
    }
    Field solve(const Field& rhs) const;

    const Body& body_;
    std::vector<small::TetrahedronRest<float>> rest_;
    std::vector<float> mass_;
    Field x_, v_, f_;
    std::vector<small::Matrix3<float>> blocks_;
    double elastic_ = 0.0;
};

void SingleBody::evaluate() {
    elastic_ = 0.0;
    f_.assign(nodes(), {{0.0F, 0.0F, 0.0F}});
    for (std::size_t e = 0; e < rest_.size(); ++e) {
        Vector x[4], force[4];
        for (int a = 0; a < 4; ++a) x[a] = x_[corners(e)[a]] - x_[corners(e)[0]];
        elastic_ += small::evaluate_tetrahedron<4, small::Tangent::rotated, small::CorotatedLaw>(
            rest_[e], x, force, &blocks_[6 * e]);
        for (int a = 0; a < 4; ++a) f_[corners(e)[a]] = f_[corners(e)[a]] + force[a];
    }
}

// In differences: a translation costs nothing, exactly.
Field SingleBody::stiffness_times(const Field& d) const {
    Field result(nodes(), {{0.0F, 0.0F, 0.0F}});
    for (std::size_t e = 0; e < rest_.size(); ++e) {
        const int* n = corners(e);
        for (int a = 0, k = 0; a < 4; ++a)
            for (int b = a + 1; b < 4; ++b, ++k) {
                const auto& block = blocks_[6 * e + static_cast<std::size_t>(k)];
                const Vector change = d[n[b]] - d[n[a]];
                result[n[a]] = result[n[a]] + block * change;
                result[n[b]] = result[n[b]] - transposed_times(block, change);
            }
    }
    return result;
}

// Conjugate gradients, preconditioned by the mass.
Field SingleBody::solve(const Field& rhs) const {
    Field x(nodes(), {{0.0F, 0.0F, 0.0F}}), r = rhs, p = rhs;
    const double first = dot(rhs, rhs);
    double squared = first;
    for (int k = 0; k < 2000 && squared > 1e-10 * first; ++k) {
        const Field product = system_times(p);
        const auto step = static_cast<float>(squared / dot(p, product));
        x = sum_of(x, step, p);
        r = sum_of(r, -step, product);
        const double next = dot(r, r);
        p = sum_of(r, static_cast<float>(next / squared), p);
        squared = next;
    }
    return x;
}

EnergyLedger SingleBody::step() {
    EnergyLedger ledger;
    const double before = kinetic() + elastic_, elastic_before = elastic_;
    Field weight(nodes(), {{0.0F, 0.0F, gravity_mm_s2}});
    weight = weighted(weight);
    const Field pull = sum_of(f_, 1.0F, weight);
    Field rhs = sum_of(Field(nodes(), {{0.0F, 0.0F, 0.0F}}), dt_s, pull);
    rhs = sum_of(rhs, -dt_s * dt_s, stiffness_times(v_));
    release(rhs);
    const Field change = solve(rhs);
    const Field unbalanced = sum_of(system_times(change), -1.0F, rhs);
    const Field next = sum_of(v_, 1.0F, change);
    const double start_work = dt_s * dot(f_, next);
    const double curvature = static_cast<double>(dt_s) * dt_s * dot(next, stiffness_times(next));
    ledger.gravity_work = dt_s * dot(weight, next);
    ledger.solver_work = dot(next, unbalanced);
    ledger.integrator_loss = 0.5 * (dot(change, weighted(change)) + curvature);
    v_ = next;
    x_ = sum_of(x_, dt_s, v_);
    evaluate();
    ledger.nonlinear_loss = elastic_before - elastic_ - start_work + 0.5 * curvature;
    ledger.kinetic = kinetic();
    ledger.elastic = elastic_;
    ledger.imbalance = stored_energy(ledger) - before - explained_change(ledger);
    return ledger;
}

TEST(SinglePrecision, TheLedgerClosesAndTheBodyIsThatOfDoublePrecision) {
    BodyDescription description;
    description.mesh = kuhn_brick(Vec3(120, 12, 12), {20, 2, 2});
    for (const Vec3& x : description.mesh.vertices_mm) description.fixed.push_back(x[0] == 0.0);
    description.material.damping_ratio = 0.0;
    const Body body = build_body(description, ElementModel::corotated, ElementOrder::linear);
    SingleBody single(body);
    const auto reference = make_cpu_stepper(
        description, {.linear = {.energy_tolerance = 1e-8}, .published = true, .sleeping = false});
    reference->set_gravity(Vec3(0, 0, gravity_mm_s2));
    double furthest = 0.0, largest = 0.0;
    for (int k = 0; k < 60; ++k) {
        largest = std::max(largest, relative_imbalance(single.step()));
        EXPECT_LE(relative_imbalance(reference->step(dt_s).energy), 1e-10) << k;
        const Vec3 tip = reference->positions_mm().back();
        const Vector& own = single.positions_mm().back();
        furthest = std::max(furthest, (tip - description.mesh.vertices_mm.back()).norm());
        EXPECT_LT((Vec3(own[0], own[1], own[2]) - tip).norm(), 2e-3 * furthest + 1e-4) << k;
    }
    EXPECT_GT(furthest, 1.0);
    EXPECT_LE(largest, 1e-4);
    RecordProperty("largest_imbalance", std::to_string(1e6 * largest) + "e-6");
}

}  // namespace
}  // namespace hepatica
