// SPDX-License-Identifier: GPL-3.0-or-later
// Counts the voxels of each tumour in the territories of portal and arterial branches.
#include "core/tree/territories/feeders.h"

#include <algorithm>
#include <functional>
#include <map>
#include <span>

#include "core/tree/territories/nearest_branch.h"

namespace hepatica {

namespace {

void add_feeders(const Image<std::int32_t>& branch, const Mask& tumours, std::uint8_t label,
                 VascularSystem system, std::vector<Feeder>& feeders) {
    std::map<std::int32_t, std::size_t> voxels;
    std::size_t all = 0;
    for (std::size_t i = 0; i < tumours.voxels.size(); ++i)
        if (tumours.voxels[i] == label && branch.voxels[i] != no_owner) {
            ++voxels[branch.voxels[i]];
            ++all;
        }
    const std::size_t first = feeders.size();
    for (const auto& [segment, count] : voxels)
        feeders.push_back({segment, system, static_cast<double>(count) / static_cast<double>(all)});
    std::ranges::stable_sort(std::span(feeders).subspan(first), std::ranges::greater{},
                             &Feeder::share);
}

}  // namespace

std::vector<std::vector<Feeder>> feeders_of(const VesselTree& tree, const Mask& liver,
                                            const Mask& tumours,
                                            const std::vector<std::uint8_t>& wanted, Job& job) {
    std::vector<std::vector<Feeder>> feeders(wanted.size());
    for (const VascularSystem system : {VascularSystem::portal, VascularSystem::artery}) {
        std::vector<std::int32_t> owners(tree.segments.size(), no_owner);
        bool any = false;
        for (std::size_t s = 0; s < owners.size(); ++s)
            if (tree.segments[s].system == system) {
                owners[s] = static_cast<std::int32_t>(s);
                any = true;
            }
        if (!any) continue;
        const Image<std::int32_t> branch = nearest_branch(liver, tree, owners, job);
        for (std::size_t w = 0; w < wanted.size(); ++w)
            add_feeders(branch, tumours, wanted[w], system, feeders[w]);
    }
    return feeders;
}

}  // namespace hepatica
