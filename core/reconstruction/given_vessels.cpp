// SPDX-License-Identifier: GPL-3.0-or-later
// Maps the labels of a given mask to systems.
#include "core/reconstruction/given_vessels.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/image/filters.h"
#include "core/image/volume_reader.h"
#include "core/image/voxel_loop.h"

namespace hepatica {

namespace {

constexpr int label_count = 1 << 16;  // of a label map's voxels

constexpr const char* name_the_labels =
    "Name those that are vessels: --vessel-label LABEL=SYSTEM,LABEL=SYSTEM, where SYSTEM is "
    "portal, "
    "hepatic, artery or unknown; the others are left out";

std::string listed(const std::set<int>& labels) {
    constexpr std::size_t most = 8;
    std::string text;
    std::size_t count = 0;
    for (const int label : labels) {
        if (++count > most) return text + " and others";
        text += (text.empty() ? "" : ", ") + std::to_string(label);
    }
    return text;
}

// The labels of all voxels, without 0.
std::set<int> labels_in(const LabelMap& labels, const Job& job) {
    std::array<bool, label_count> seen{};
    for_each_voxel_in_order(labels.voxels.size(), job,
                            [&](std::size_t i) { seen[labels.voxels[i]] = true; });
    std::set<int> found;
    for (int label = 1; label < label_count; ++label)
        if (seen[static_cast<std::size_t>(label)]) found.insert(label);
    return found;
}

std::map<int, VascularSystem> systems_of_numbers(const std::set<int>& labels,
                                                 const std::string& place,
                                                 std::vector<std::string>& warnings) {
    if (labels.size() == 1) return {{*labels.begin(), VascularSystem::unknown}};
    std::map<int, VascularSystem> systems;
    std::string meanings;
    for (const int label : labels) {
        const auto system = system_numbered(label);
        if (!system)
            throw InputError("holds the labels " + listed(labels) + ", and " +
                                 std::to_string(label) + " is no vascular system (" +
                                 list_of_systems() + ")",
                             place, name_the_labels);
        systems[label] = *system;
        meanings +=
            (meanings.empty() ? "" : ", ") + std::to_string(label) + " as " + title_of(*system);
    }
    if (!labels.empty())
        warnings.push_back("The labels of the vessel mask were taken for systems: " + meanings +
                           ". If they mean something else, name them: --vessel-label "
                           "LABEL=SYSTEM,LABEL=SYSTEM.");
    return systems;
}

}  // namespace

Mask systems_of_labels(const LabelMap& labels, const std::vector<VesselLabel>& names,
                       const std::string& place, std::vector<std::string>& warnings,
                       const Job& job) {
    std::map<int, VascularSystem> systems;
    for (const VesselLabel& name : names) systems[name.label] = name.system;
    if (names.empty()) systems = systems_of_numbers(labels_in(labels, job), place, warnings);
    std::array<std::uint8_t, label_count> number_for{};
    for (const auto& [label, system] : systems)
        if (label > 0 && label < label_count)
            number_for[static_cast<std::size_t>(label)] = static_cast<std::uint8_t>(system);
    Mask mask(labels.grid);
    bool any = false;
    for_each_voxel_in_order(mask.voxels.size(), job, [&](std::size_t i) {
        mask.voxels[i] = number_for[labels.voxels[i]];
        any = any || mask.voxels[i] != 0;
    });
    if (!any)
        throw InputError("no vessels were found", place,
                         names.empty() ? "Give a mask whose vessels are not 0" : name_the_labels);
    return mask;
}

Mask read_given_vessels(const std::filesystem::path& file, const std::vector<VesselLabel>& names,
                        const Grid& ct_grid, std::vector<std::string>& warnings, Job& job) {
    const LabelMap labels = on_grid_of(ct_grid, read_label_map(file, job), file.string());
    const Mask mask = systems_of_labels(labels, names, file.string(), warnings, job);
    constexpr double margin_mm = 5.0;
    return crop(mask, grow_box(bounding_box(mask), mask.grid, margin_mm));
}

}  // namespace hepatica
