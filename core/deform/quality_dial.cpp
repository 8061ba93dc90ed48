// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/quality_dial.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "core/base/error.h"

namespace hepatica {
namespace {

constexpr double frame_s = 1.0 / 60.0;
constexpr double rest_damping_ratio = 0.5;  // or more, so that a body comes to rest within a second

double median(std::vector<double> values) {
    std::ranges::nth_element(values, values.begin() + values.size() / 2);
    return values[values.size() / 2];
}

}  // namespace

std::vector<std::size_t> pareto_front(std::span<const double> cost, std::span<const double> error) {
    std::vector<std::size_t> order(cost.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
        return cost[a] != cost[b] ? cost[a] < cost[b] : error[a] < error[b];
    });
    std::vector<std::size_t> front;
    for (const std::size_t i : order)
        if (front.empty() || error[i] < error[front.back()]) front.push_back(i);
    return front;
}

QualityDial::QualityDial(std::vector<QualityPoint> measured) {
    std::vector<double> cost, error;
    for (const QualityPoint& point : measured) {
        if (!std::isfinite(point.frame_ms) || !(point.frame_ms > 0.0) ||
            !std::isfinite(point.error_relative))
            throw InputError("a measurement is not finite", "the dial", "Measure again");
        cost.push_back(point.frame_ms);
        error.push_back(point.error_relative);
    }
    for (const std::size_t i : pareto_front(cost, error)) front_.push_back(measured[i]);
    if (front_.empty())
        throw InputError("there is no measurement", "the dial", "Measure at least one setting");
}

const QualityPoint& QualityDial::within(double frame_budget_ms) const {
    const auto beyond = std::ranges::find_if(
        front_, [&](const QualityPoint& point) { return point.frame_ms > frame_budget_ms; });
    return beyond == front_.begin() ? front_.front() : *(beyond - 1);
}

const QualityPoint& QualityDial::at(double quality) const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < front_.size(); ++i)
        if (std::abs(quality_of(i) - quality) < std::abs(quality_of(best) - quality)) best = i;
    return front_[best];
}

double QualityDial::quality_of(std::size_t index) const {
    if (front_.size() == 1) return 1.0;
    const double low = std::log(front_.front().frame_ms), high = std::log(front_.back().frame_ms);
    return (std::log(front_[index].frame_ms) - low) / (high - low);
}

double displacement_error(std::span<const Vec3> positions_mm, std::span<const Vec3> reference_mm,
                          std::span<const Vec3> rest_mm) {
    double missed = 0.0, moved = 0.0;
    for (std::size_t i = 0; i < rest_mm.size(); ++i) {
        missed += (positions_mm[i] - reference_mm[i]).squaredNorm();
        moved += (reference_mm[i] - rest_mm[i]).squaredNorm();
    }
    return std::sqrt(missed / moved);
}

std::vector<Vec3> converged_rest(const BodyDescription& body, const Vec3& gravity_mm_per_s2) {
    if (std::ranges::none_of(body.fixed, [](std::uint8_t f) { return f != 0; }))
        throw InputError("nothing of the body is fixed", "the dial", "Fix the ends of the tree");
    StepperOptions options;
    options.order = body.hexahedra.empty() ? ElementOrder::quadratic : ElementOrder::linear;
    options.linear.energy_tolerance = 1e-4;
    options.newton_iterations = 30;
    options.sleeping = false;
    const auto stepper = make_cpu_stepper(body, options);
    stepper->set_gravity(gravity_mm_per_s2);
    // Long steps, in which backward Euler forgets the motion.
    for (int i = 0; i < 6; ++i) stepper->step(100.0);
    return {stepper->positions_mm().begin(), stepper->positions_mm().end()};
}

QualityPoint measure_quality(const BodyDescription& description, const StepperOptions& options,
                             int frames, const Vec3& gravity_mm_per_s2,
                             std::span<const Vec3> converged_rest_mm) {
    BodyDescription body = description;
    body.material.damping_ratio = std::max(body.material.damping_ratio, rest_damping_ratio);
    const auto stepper = make_cpu_stepper(body, options);
    stepper->set_gravity(gravity_mm_per_s2);
    std::vector<double> frame_ms;
    for (int i = 0; i < frames; ++i) {
        const auto start = std::chrono::steady_clock::now();
        if (stepper->step(frame_s).asleep) break;
        frame_ms.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
                .count());
    }
    return {options, median(frame_ms),
            displacement_error(stepper->positions_mm(), converged_rest_mm, body.mesh.vertices_mm),
            body.hexahedra.empty() ? "the same mesh in quadratic order, converged"
                                   : "the same mesh, converged"};
}

}  // namespace hepatica
