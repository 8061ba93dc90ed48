// SPDX-License-Identifier: GPL-3.0-or-later
// Four sizes of elements, and the message if none of them helps.
#include "core/mesh/manifold_attempts.h"

#include "core/base/error.h"
#include "core/mesh/surface.h"

namespace hepatica {

namespace {

constexpr std::string_view beginning = "The mesh is not sound: ";

}  // namespace

ManifoldMesh first_manifold(const std::function<TetMesh(double)>& mesher) {
    ManifoldMesh last;
    for (const double scale : attempt_scales) {
        last.mesh = mesher(scale);
        last.is_manifold = is_closed_manifold(surface_of(last.mesh).mesh);
        if (last.is_manifold) break;
    }
    return last;
}

void report_unclosed(int unclosed, int all, std::vector<std::string>* warnings) {
    if (unclosed == 0) return;
    const std::string problem = "the surface of " + std::to_string(unclosed) + " of " +
                                std::to_string(all) + (all == 1 ? " body" : " bodies") +
                                " meets itself along an edge or in a point, whatever the size of "
                                "the elements (\"closed\" is false)";
    const std::string remedy =
        "Branches that touch may be parted (hepatica-cli edit), or give another number of "
        "tetrahedra";
    if (warnings == nullptr) throw InputError(problem, "the mesh", remedy);
    warnings->push_back(std::string(beginning) + problem +
                        ". Forces pass through such places as through a hinge. " + remedy + ".");
}

bool is_of_unclosed(std::string_view warning) {
    return warning.starts_with(beginning);
}

}  // namespace hepatica
