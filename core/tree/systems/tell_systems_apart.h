// SPDX-License-Identifier: GPL-3.0-or-later
// Separates portal and hepatic veins on the vessel graph by a minimal cut over its pieces: straight
// continuations of equal brightness stay together, and anatomy decides the system of each side
// (system_evidence.h). The cut runs where the systems touch in the image.
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
    // The piece nearest to a seed has its system, whatever the evidence.
    std::vector<VesselSeed> seeds;
    // Box around the liver (LPS, mm); empty: the box around the vessels.
    Eigen::AlignedBox3d liver_mm;
    // The vessels' systems before some of them changed, as numbers of VascularSystem; null: not
    // known. A vessel keeps its system unless the evidence against it is strong, so that a change
    // in one place does not affect balanced decisions elsewhere. Confidences ignore it.
    const Mask* before = nullptr;
};

struct SystemsFound {
    AnatomicalAnchors anchors;
    // Mean brightness of hepatic minus portal veins, in standard deviations of a piece.
    double brightness_difference = 0.0;
    // Log odds by which two systems explain the vessels better than one, without seeds.
    double gain = 0.0;
};

// Gives every link a system and a confidence (the share of draws with perturbed evidence that give
// the same system). Links are split where the system changes, and each system gets its own nodes.
// Without enough evidence for two systems the vessels are one system, `unknown` unless a seed names
// it. Arteries come from seeds only. `ct` may be null. Deterministic. Throws Cancelled.
SystemsFound tell_systems_apart(VesselGraph& graph, const Volume* ct, const SystemSearch& search,
                                const Job& job = Job());

// The root of each component: for portal veins and arteries the end nearest to the hilum, for
// hepatic veins the one nearest to the confluence, with a bonus for wide ends. Components of an
// unknown system get none.
std::vector<RootWish> anatomical_roots(const VesselGraph& graph, const AnatomicalAnchors& anchors);

}  // namespace hepatica
