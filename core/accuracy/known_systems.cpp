// SPDX-License-Identifier: GPL-3.0-or-later
// Prepares the truths: checks them, crops them to the liver, and computes missing centrelines.
#include "core/accuracy/known_systems.h"

#include <algorithm>
#include <cmath>

#include "core/accuracy/trunk_of_truth.h"
#include "core/base/error.h"
#include "core/image/section.h"

namespace hepatica {

namespace {

constexpr double margin_mm = 12.0;  // kept around the liver; larger than any tolerance

void require_truths(std::span<const SystemTruth> truths, const Mask* liver, const Mask* cava) {
    if (truths.empty()) throw InputError("there is no truth", "", "Give a mask of a system");
    const Grid& grid = truths[0].mask.grid;
    for (const SystemTruth& truth : truths) {
        if (std::ranges::all_of(truth.mask.voxels, [](auto v) { return v == 0; }))
            throw InputError("the true mask is empty", name_of(truth.system),
                             "Give the mask that is the truth");
        if (!same_grid(truth.mask.grid, grid))
            throw InputError("the true mask lies on another grid than the first one",
                             name_of(truth.system), "Give masks of one image");
    }
    if (liver != nullptr && std::ranges::all_of(liver->voxels, [](auto v) { return v == 0; }))
        throw InputError("the liver's mask is empty", "",
                         "Give the mask of the liver, or leave it out");
    for (const Mask* organ : {liver, cava})
        if (organ != nullptr && !same_grid(organ->grid, grid))
            throw InputError("the organ's mask lies on another grid than the vessels'", "",
                             "Give masks of one image");
}

std::optional<Mask> cropped(const Mask* mask, const IndexBox& box) {
    return mask != nullptr ? std::optional(crop(*mask, box)) : std::nullopt;
}

// The voxels of an object that lie inside or outside a region.
Mask part_of(const Mask& object, const Mask& region, bool inside) {
    Mask part = object;
    for (std::size_t i = 0; i < part.voxels.size(); ++i)
        if ((region.voxels[i] != 0) != inside) part.voxels[i] = 0;
    return part;
}

const Mask* pointer_to(const std::optional<Mask>& mask) {
    return mask ? &*mask : nullptr;
}

}  // namespace

KnownSystems::KnownSystems(std::span<const SystemTruth> truths, const Mask* liver, const Mask* cava,
                           const CavaNeighbourhood& size, Job& job) {
    require_truths(truths, liver, cava);
    const Grid& whole = truths[0].mask.grid;
    step_mm_ = 0.5 * std::cbrt(whole.spacing_mm.prod());
    IndexBox box{{0, 0, 0}, whole.dims};
    if (liver != nullptr) box = grow_box(bounding_box(*liver), whole, margin_mm);
    set_region(truths, liver, cava, box, size, job);
    for (const SystemTruth& truth : truths) {
        const bool given = !truth.tree.segments.empty();
        VesselTree lines = given ? truth.tree : centrelines_of(truth.mask, job);
        CentrelineSamples samples = sampled(lines, step_mm_, &judged_);
        CentrelineLocator locator(lines);
        Mask lumen = crop(truth.mask, box);
        for (std::uint8_t& voxel : lumen.voxels) voxel = voxel != 0;
        all_.push_back({truth.system, std::move(lumen), std::move(lines), given, std::move(samples),
                        std::move(locator)});
    }
}

void KnownSystems::set_region(std::span<const SystemTruth> truths, const Mask* liver,
                              const Mask* cava, const IndexBox& box, const CavaNeighbourhood& size,
                              Job& job) {
    const auto veins = std::ranges::find_if(truths, [](const SystemTruth& truth) {
        return truth.system == VascularSystem::hepatic && truth.tree.segments.empty();
    });
    const std::optional<Mask> hepatic =
        cropped(veins != truths.end() ? &veins->mask : nullptr, box);
    const std::optional<Mask> drawn = cropped(cava, box), organ = cropped(liver, box);
    cava_ = hepatic || drawn ? near_cava(pointer_to(hepatic), pointer_to(drawn), size, job)
                             : Mask(crop(truths[0].mask.grid, box));
    judged_ = judged_region(pointer_to(organ), cava_, job);
}

std::uint8_t KnownSystems::system_at(const Vec3& p, double reach_mm) const {
    const KnownSystem *nearest = nullptr, *holder = nullptr;
    int holders = 0;
    for (const KnownSystem& known : all_) {
        if (holds(known.lumen, p)) {
            ++holders;
            holder = &known;
        }
        const auto found = known.locator.nearest(p, reach_mm);
        if (!found || (nearest != nullptr && found->distance_mm >= reach_mm)) continue;
        nearest = &known;
        reach_mm = found->distance_mm;
    }
    if (holders == 1) nearest = holder;
    return nearest == nullptr ? 0 : static_cast<std::uint8_t>(nearest->system);
}

std::vector<Vec3> KnownSystems::trunk_ends(const KnownSystem& known) const {
    std::vector<Vec3> ends;
    if (known.tree_given) {
        for (const int root : roots(known.tree))
            ends.push_back(known.tree.segments[root].points_mm.front());
    } else if (known.system == VascularSystem::hepatic) {
        for (std::size_t i = 0; i < cava_.voxels.size(); ++i)
            if (cava_.voxels[i] != 0 && known.lumen.voxels[i] != 0) {
                const auto [x, y, z] = cava_.grid.index_of(i);
                ends.push_back(cava_.grid.to_mm(x, y, z));
            }
    } else if (const std::optional<int> end = end_of_trunk(known.samples);
               end && !known.samples.samples[*end].judged) {
        ends.push_back(known.samples.samples[*end].position_mm);
    } else if (const std::optional<Section> section = largest_section(
                   part_of(known.lumen, judged_, true), part_of(known.lumen, judged_, false))) {
        ends.push_back(section->middle_mm);
    }
    if (!ends.empty()) return ends;
    if (const std::optional<int> end = widest_end(known.samples))
        ends.push_back(known.samples.samples[*end].position_mm);
    return ends;
}

std::optional<Vec3> KnownSystems::point_in_trunk(const KnownSystem& known,
                                                 double inwards_mm) const {
    const std::optional<int> end = widest_end(known.samples);
    if (!end) return std::nullopt;
    return known.samples.samples[last_of_run(known.samples, *end, inwards_mm).back()].position_mm;
}

}  // namespace hepatica
