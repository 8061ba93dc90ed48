// SPDX-License-Identifier: GPL-3.0-or-later
// Repeats the second half of a reconstruction on other voxels and applies the earlier edits again.
#include "core/reconstruction/remade_case.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "core/base/error.h"
#include "core/base/patient_space.h"
#include "core/image/morphology.h"
#include "core/patient/branch_offers.h"
#include "core/patient/corrections.h"
#include "core/patient/painted_tumours.h"
#include "core/reconstruction/from_voxels.h"
#include "core/reconstruction/reconstruct_parameters.h"
#include "core/segmentation/vessel_systems.h"
#include "core/tree/extraction/component_pruning.h"
#include "core/tree/station.h"
#include "core/tree/system_summary.h"

namespace hepatica {

namespace {

// Where the widest portal tree began before any edit: cases of older programs do not keep where the
// trunk was seen.
std::optional<Vec3> portal_trunk_of(const PatientCase& patient) {
    const VesselTree& made =
        patient.corrections.edits.empty() ? patient.tree : patient.corrections.extracted;
    std::optional<Vec3> trunk;
    double widest_mm = 0.0;
    for (const SystemSummary& system : systems_of(made)) {
        if (system.system != VascularSystem::portal) continue;
        for (const SystemRoot& root : system.roots)
            if (root.radius_mm > widest_mm) {
                widest_mm = root.radius_mm;
                trunk = root.at_mm;
            }
    }
    return trunk;
}

// A seed only speaks for the vessel it lies in. Drops the seeds whose vessel was erased.
void drop_lost_seeds(const Mask& vessels, std::vector<VesselSeed>& seeds,
                     std::vector<std::string>& warnings) {
    std::erase_if(seeds, [&](const VesselSeed& seed) {
        try {
            require_seeds_in_vessels(vessels, {seed});
            return false;
        } catch (const InputError& error) {
            warnings.push_back("The seed at " + place_text(seed.position_mm) +
                               " is left out: " + error.problem());
            return true;
        }
    });
}

// The edits that are possible on `made`, in order. Repeats all earlier edits for each: quadratic.
std::vector<TreeEdit> possible_edits(const PatientCase& made, const std::vector<TreeEdit>& wanted,
                                     std::vector<std::string>& warnings, const Job& job) {
    std::vector<TreeEdit> possible;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        job.throw_if_cancelled();
        possible.push_back(wanted[i]);
        try {
            with_edited_tree(made, possible);
        } catch (const InputError& error) {
            possible.pop_back();
            warnings.push_back("The correction number " + std::to_string(i + 1) +
                               " is left out, because it cannot be made on these vessels: " +
                               error.problem() + " (" + error.place() + ")");
        }
    }
    return possible;
}

// A voxel of each connected part of what was painted, the nearest to its middle. They are vessels
// of the system that they had in the case before, if any.
std::vector<Vec3> take_painted_places(const Mask& before, Mask& vessels, const Job& job) {
    constexpr auto unknown = static_cast<std::uint8_t>(number_of(VascularSystem::unknown));
    const bool known = same_grid(before.grid, vessels.grid);
    Mask painted(vessels.grid);
    bool any = false;
    for (std::size_t i = 0; i < vessels.voxels.size(); ++i) {
        if (vessels.voxels[i] != painted_voxel) continue;
        painted.voxels[i] = 1;
        any = true;
        vessels.voxels[i] = known && before.voxels[i] != 0 ? before.voxels[i] : unknown;
    }
    if (!any) return {};
    const Components parts = connected_components(painted, Connectivity::all26, job);
    const auto place_of = [&](std::size_t offset) {
        const Index3 at = vessels.grid.index_of(offset);
        return vessels.grid.to_mm(at[0], at[1], at[2]);
    };
    std::vector<Vec3> middles(parts.sizes.size(), Vec3::Zero()), places(parts.sizes.size());
    std::vector<double> least(parts.sizes.size(), std::numeric_limits<double>::infinity());
    const auto for_each_painted = [&](const auto& see) {
        for (std::size_t i = 0; i < painted.voxels.size(); ++i)
            if (painted.voxels[i] != 0)
                see(static_cast<std::size_t>(parts.labels.voxels[i]) - 1, place_of(i));
    };
    for_each_painted([&](std::size_t part, const Vec3& place) {
        middles[part] += place / static_cast<double>(parts.sizes[part]);
    });
    for_each_painted([&](std::size_t part, const Vec3& place) {
        const double away = (place - middles[part]).squaredNorm();
        if (away >= least[part]) return;
        least[part] = away;
        places[part] = place;
    });
    return places;
}

// A ball has no centreline, for example.
void warn_of_painted_left_out(const std::vector<Vec3>& painted_mm, const VesselTree& tree,
                              std::vector<std::string>& warnings) {
    for (const Vec3& place : painted_mm) {
        const TreePoint at = nearest_point(tree, place);
        const double radius_mm =
            station_at(tree.segments[static_cast<std::size_t>(at.segment)], at.arclength_mm)
                .radius_mm;
        if (at.distance_mm <= radius_mm + kept_reach_mm) continue;
        warnings.push_back("What was painted at " + place_text(place) +
                           " is left out of the tree: it is too short or too round to be a vessel. "
                           "Paint along the vessel, or undo the rebuilding.");
    }
}

// Other vessels change nothing of what was said of the image.
void keep_warnings_of_image(const PatientCase& before, PatientCase& made) {
    made.warnings_of_image = before.warnings_of_image;
    made.warnings.insert(
        made.warnings.begin(), before.warnings.begin(),
        before.warnings.begin() + static_cast<std::ptrdiff_t>(before.warnings_of_image));
}

}  // namespace

RemadeCase remade(const PatientCase& patient, Mask vessels, const Volume& ct, Job& job) {
    RemadeCase result;
    FromVoxelsOptions options = from_voxels_options(patient.source.parameters_json);
    if (!options.portal_trunk_mm) options.portal_trunk_mm = portal_trunk_of(patient);
    options.systems_before = &patient.mask;
    if (patient.doubts) options.of_image = *patient.doubts;
    options.kept_mm = take_painted_places(patient.mask, vessels, job);
    drop_lost_seeds(vessels, options.seeds, result.warnings);
    job.begin_stage("Filling the vessels");
    PatientCase& made = result.patient;
    made.source = patient.source;
    made.measured = patient.measured;
    made.organs = unpainted_organs(patient);  // painted tumours change no vessel
    made.mask = std::move(vessels);
    make_tree(options, ct, made, result.warnings, job);
    if (made.tree.segments.empty())
        throw InputError("no vessel is left that is long enough for a tree", patient.source.name,
                         "Take back what was erased, or paint more of the vessels");
    warn_of_painted_left_out(options.kept_mm, made.tree, result.warnings);
    std::vector<Bridge> branches = patient.corrections.bridges;
    std::erase_if(branches, [](const Bridge& bridge) { return !bridge.is_branch(); });
    offer_branches(branches, made);
    const std::vector<TreeEdit> edits =
        possible_edits(made, patient.corrections.edits, result.warnings, job);
    if (!edits.empty()) made = with_edited_tree(made, edits);
    paint_tumours(made, edits);
    make_body(mesh_options_of(made), made, result.warnings, job);
    keep_warnings_of_image(patient, made);
    return result;
}

}  // namespace hepatica
