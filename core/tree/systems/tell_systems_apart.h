// SPDX-License-Identifier: GPL-3.0-or-later
// Portal vein and hepatic veins told apart on the vessel graph, by a minimal cut over its pieces:
// neighbours along straight ways of one brightness stay together, and anatomy decides what each
// side is (system_evidence.h). Where both systems touch in the image the cut runs.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "core/base/job.h"
#include "core/image/volume.h"
#include "core/tree/extraction/vessel_graph.h"
#include "core/tree/systems/anatomical_anchors.h"

namespace hepatica {

struct SystemSearch {
    // Pieces nearest to a seed have its system, whatever speaks against it.
    std::vector<VesselSeed> seeds;
    // Box around the liver (LPS, mm). Empty: the box around the vessels stands in.
    Eigen::AlignedBox3d liver_mm;
    // What the vessels were before some of them changed, as numbers of VascularSystem; null: not
    // known. A vessel stays what it was unless much speaks against it, so that a change in one
    // place does not turn over what was in balance elsewhere. Confidences do not count it.
    const Mask* before = nullptr;
};

struct SystemsFound {
    AnatomicalAnchors anchors;
    // Difference in mean brightness between the systems, in standard deviations of a piece.
    double brightness_difference = 0.0;
    // By how much two systems explain the vessels better than one, in log odds.
    double gain = 0.0;
};

// Gives every link a system and a confidence (the share of draws with perturbed evidence in which
// the same system came out); links are split where the system changes, and each system gets nodes
// of its own. Where nothing speaks for two systems the vessels are one, `unknown` unless a seed
// names it. Artery and other systems come from seeds only. `ct` may be null. Deterministic. Throws
// Cancelled.
SystemsFound tell_systems_apart(VesselGraph& graph, const Volume* ct, const SystemSearch& search,
                                const Job& job = Job());

// Where each component of the graph begins: a portal vein or an artery at the end nearest to the
// hilum, hepatic veins at that nearest to the confluence, wide ends before narrow ones. Components
// of an unknown system are left to directed().
std::vector<RootWish> anatomical_roots(const VesselGraph& graph, const AnatomicalAnchors& anchors);

}  // namespace hepatica
