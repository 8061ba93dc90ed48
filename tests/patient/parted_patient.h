// SPDX-License-Identifier: GPL-3.0-or-later
// A patient whose tree lies in two pieces, with two ways to bridge the gap.
#pragma once

#include "core/mesh/surface.h"
#include "core/mesh/tetrahedralize.h"
#include "core/patient/corrections.h"
#include "tests/support/test_trees.h"

namespace hepatica::test {

// The tree of test_trees.h, and a straight vessel that begins 8 mm beyond its last end.
inline VesselTree parted_tree() {
    VesselGraph graph = forked_graph();
    const int first = static_cast<int>(graph.nodes.size());
    graph.nodes.push_back({Vec3(29, 49, 3), 2.0});
    graph.nodes.push_back({Vec3(45, 60, 5), 1.8});
    graph.links.push_back(straight_link(graph, first, first + 1, 2.0, 1.8));
    return directed(graph);
}

inline Bridge bridge_over(const std::vector<Vec3>& path, double confidence) {
    Bridge bridge;
    bridge.path_mm = path;
    bridge.gap_mm = 8.0;
    bridge.confidence = confidence;
    bridge.from_radius_mm = 2.0;
    bridge.to_radius_mm = 2.2;
    return bridge;
}

inline const std::vector<Vec3> last_gap{Vec3(29, 49, 3), Vec3(25.5, 47.5, 2.5), Vec3(22, 45, 2)};
inline const std::vector<Vec3> other_gap{Vec3(29, 49, 3), Vec3(17, 50, 0), Vec3(5, 50, -4)};

inline PatientCase patient_with_bridges() {
    PatientCase patient;
    Job job;
    patient.tree = parted_tree();
    patient.source.parameters_json = R"({"mesh":{"target_tetrahedra":2000}})";
    patient.mesh = tetrahedralize(patient.tree, {.target_tetrahedra = 2000}, job);
    patient.surface = surface_of(patient.mesh).mesh;
    patient.corrections.bridges = {bridge_over(last_gap, 0.22), bridge_over(other_gap, 0.1)};
    return patient;
}

}  // namespace hepatica::test
