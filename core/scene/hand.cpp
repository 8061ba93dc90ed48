// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/hand.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.h"

namespace hepatica {

Hold hold_around(int vertex, const Vec3& point_mm, const BodyVertices& body,
                 std::span<const Vec3> positions, double modulus_pa, double pressure_pa) {
    const double radius_mm = body.places()[vertex].radius_mm;
    const Vec3 centre_now = positions[vertex];
    const Vec3 centre_at_rest = body.rest_mm()[vertex];
    Hold hold;
    for (std::size_t v = 0; v < positions.size(); ++v) {
        // The vertices must be near at rest, too, so that another vessel that lies beside this one
        // is not held.
        const bool near = (positions[v] - centre_now).norm() <= radius_mm &&
                          (body.rest_mm()[v] - centre_at_rest).norm() <= 2.0 * radius_mm;
        if (near && body.fixed()[v] == 0) hold.vertices.push_back(static_cast<int>(v));
    }
    if (hold.vertices.empty()) hold.vertices.push_back(vertex);
    for (const int v : hold.vertices) hold.offsets_mm.push_back(positions[v] - point_mm);
    // All springs together are as stiff as a piece of the vessel one radius long. Their force limit
    // is high, because a weaker hand could not move a vessel that its tissue holds.
    const auto springs = static_cast<double>(hold.vertices.size());
    hold.target_mm = point_mm;
    hold.stiffness_un_per_mm = modulus_pa * M_PI * radius_mm / springs;
    hold.force_limit_un = pressure_pa * M_PI * radius_mm * radius_mm / springs;
    return hold;
}

std::vector<Grab> springs_of(const Hold& hold) {
    std::vector<Grab> grabs;
    for (std::size_t i = 0; i < hold.vertices.size(); ++i) {
        Grab spring;
        spring.vertices[0] = hold.vertices[i];
        spring.target_mm = hold.target_mm + hold.offsets_mm[i];
        spring.stiffness_un_per_mm = hold.stiffness_un_per_mm;
        spring.force_limit_un = hold.force_limit_un;
        grabs.push_back(spring);
    }
    return grabs;
}

GrabView view_of(const Hold& hold, std::span<const Vec3> positions) {
    GrabView view;
    view.target_mm = hold.target_mm;
    Vec3 force_un = Vec3::Zero();
    std::size_t limited = 0;
    for (std::size_t i = 0; i < hold.vertices.size(); ++i) {
        const Vec3 held = positions[hold.vertices[i]] - hold.offsets_mm[i];
        view.point_mm += held / static_cast<double>(hold.vertices.size());
        const Vec3 pull = hold.stiffness_un_per_mm * (hold.target_mm - held);
        limited += pull.norm() >= hold.force_limit_un ? 1 : 0;
        force_un += pull * std::min(1.0, hold.force_limit_un / std::max(pull.norm(), 1e-300));
    }
    view.force_un = force_un.norm();
    view.at_limit = 2 * limited >= hold.vertices.size();
    return view;
}

void require_hold_of(std::size_t vertices, const Hold& hold) {
    const auto exists = [&](int v) { return v >= 0 && static_cast<std::size_t>(v) < vertices; };
    if (hold.offsets_mm.size() != hold.vertices.size() ||
        !std::ranges::all_of(hold.vertices, exists))
        throw InputError("holds vertices that the body does not have", "checkpoint",
                         "Give a checkpoint of the same patient");
}

void add_to(Hasher& hasher, const Hold& hold) {
    const std::array<double, 2> spring{hold.stiffness_un_per_mm, hold.force_limit_un};
    hasher.add(std::span<const int>(hold.vertices));
    for (const Vec3& offset : hold.offsets_mm) hasher.add_bytes(offset.data(), sizeof(Vec3));
    hasher.add_bytes(hold.target_mm.data(), sizeof(Vec3));
    hasher.add(std::span<const double>(spring));
}

}  // namespace hepatica
