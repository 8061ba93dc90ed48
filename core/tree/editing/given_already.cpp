// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/editing/given_already.h"

#include "core/tree/editing/edit_reach.h"
#include "core/tree/system_summary.h"

namespace hepatica {

bool is_given_already(const VesselTree& tree, const TreeEdit& edit) {
    const bool gives_branch = edit.kind == TreeEditKind::reassign_system;
    if (tree.segments.empty() || (!gives_branch && edit.kind != TreeEditKind::seed_system))
        return false;
    const TreePoint at = nearest_point(tree, edit.at_mm);
    if (!(at.distance_mm <= edit_reach_mm)) return false;
    if (!gives_branch)
        return tree.segments[static_cast<std::size_t>(at.segment)].system == edit.system;
    const std::vector<std::uint8_t> hangs = downstream_of(tree, at.segment);
    for (std::size_t i = 0; i < hangs.size(); ++i)
        if (hangs[i] != 0 && tree.segments[i].system != edit.system) return false;
    return true;
}

bool settles_a_doubt(const VesselTree& tree, const TreeEdit& edit) {
    if (edit.kind != TreeEditKind::reassign_system || edit.system == VascularSystem::unknown ||
        !is_given_already(tree, edit))
        return false;
    const std::vector<std::uint8_t> hangs =
        downstream_of(tree, nearest_point(tree, edit.at_mm).segment);
    for (std::size_t i = 0; i < hangs.size(); ++i)
        if (hangs[i] != 0 && tree.segments[i].system_confidence < sure_confidence) return true;
    return false;
}

}  // namespace hepatica
