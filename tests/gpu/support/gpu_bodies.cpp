// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gpu/support/gpu_bodies.h"

#include <algorithm>
#include <cmath>

#include "gpu/machine/device_machine.h"

namespace hepatica::test {

std::unique_ptr<gpu::Machine> machine_of(const std::string& kind) {
    if (kind == "emulated") return gpu::make_emulator();
    return gpu::device_info().reason.empty() ? gpu::make_device_machine() : nullptr;
}

std::string no_device_because() {
    return gpu::device_info().reason;
}

BodyDescription gpu_bar() {
    BodyDescription description = description_of(make_bar(24.0, 6.0, 8, 2));
    description.tether_pa_per_mm2 = 3.0;
    return description;
}

BodyState lively(const Body& body) {
    BodyState state{body.rest_positions_mm, {}};
    for (std::size_t i = 0; i < state.positions_mm.size(); ++i) {
        Vec3& x = state.positions_mm[i];
        const double s = x.x() / 24.0;
        x += Vec3(0.1 * s, 1.5 * s * s, 0.3 * std::sin(3.0 * s + x.y()) * s);
        state.velocities_mm_per_s.push_back(
            body.fixed[i] ? Vec3(Vec3::Zero()) : Vec3(4.0 * s, -20.0 * s, 7.0 * s * x.y()));
    }
    return state;
}

Grab pull_at_end(const BodyDescription& description) {
    const auto& corners = description.mesh.tetrahedra.back();
    Grab grab;
    grab.vertices = {corners[0], corners[1], corners[2], -1};
    grab.weights = {0.2, 0.5, 0.3, 0.0};
    grab.target_mm = description.mesh.vertices_mm[corners[0]] + Vec3(1.0, 4.0, 2.0);
    grab.stiffness_un_per_mm = 5e4;
    grab.force_limit_un = 1e5;
    return grab;
}

StepperOptions exact_options(const std::string& element) {
    StepperOptions options;
    std::tie(options.model, options.order) = element_of(element);
    options.solver = LinearSolverKind::block_jacobi;
    options.linear = {
        .energy_tolerance = 0.0, .residual_tolerance = 1e-13, .max_iterations = 20000};
    options.sleeping = false;
    options.tension = false;  // the device has none
    return options;
}

double relative_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double most = 0.0, size = 0.0;
    for (std::size_t i = 0; i < b.size(); ++i) {
        most = std::max(most, (a[i] - b[i]).norm());
        size = std::max(size, b[i].norm());
    }
    return std::isfinite(most) ? most / size : INFINITY;
}

std::vector<Vec3> difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    std::vector<Vec3> d(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) d[i] = a[i] - b[i];
    return d;
}

}  // namespace hepatica::test
