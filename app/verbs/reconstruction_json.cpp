// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/verbs/reconstruction_json.h"

#include "core/mesh/quality.h"
#include "core/tree/files/tree_json.h"

namespace hepatica {

Json to_json(const VesselTree& tree) {
    return {{"segments", tree.segments.size()},
            {"bifurcations", bifurcation_count(tree)},
            {"ends", end_count(tree)},
            {"components", roots(tree).size()},
            {"length_mm", length_mm(tree)},
            {"bridged_mm", bridged_length_mm(tree)},
            {"systems", json_of(systems_of(tree))}};
}

Json to_json(const TetMesh& mesh) {
    const MeshQuality quality = quality_of(mesh);
    return {{"vertices", mesh.vertices_mm.size()},
            {"tetrahedra", mesh.tetrahedra.size()},
            {"min_dihedral_deg", quality.min_dihedral_deg},
            {"max_dihedral_deg", quality.max_dihedral_deg},
            {"components", quality.components},
            {"closed", quality.closed},
            {"handles", quality.handles},
            {"volume_mm3", quality.volume_mm3}};
}

Json to_json(const std::vector<Bridge>& bridges) {
    Json list = Json::array();
    for (const Bridge& bridge : bridges) {
        const Vec3& from = bridge.path_mm.front();
        const Vec3& to = bridge.path_mm.back();
        list.push_back({{"kind", bridge.is_branch() ? "branch" : "gap"},
                        {"confidence", bridge.confidence},
                        {bridge.is_branch() ? "length_mm" : "gap_mm", bridge.gap_mm},
                        {"from_mm", {from.x(), from.y(), from.z()}},
                        {"to_mm", {to.x(), to.y(), to.z()}},
                        {"built", bridge.built}});
    }
    return list;
}

}  // namespace hepatica
