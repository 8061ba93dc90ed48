// SPDX-License-Identifier: GPL-3.0-or-later
// feeders: the branches through which blood reaches a tumour, for planning an injection
// (core/tree/territories/feeders.h).
#include <algorithm>
#include <filesystem>
#include <optional>
#include <vector>

#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/patient/liver_segments.h"
#include "core/patient/painted_tumours.h"
#include "core/tree/territories/couinaud_segments.h"
#include "core/tree/territories/feeders.h"

namespace hepatica {

namespace {

struct FeedersChoices {
    std::filesystem::path patient;
    int tumour = 0;  // counted from 1; 0: all
    std::string at_mm;
    double radius_mm = 10.0;
};

// Labels of the requested tumour, or of all, in the organs.
std::vector<std::uint8_t> wanted_tumours(const FeedersChoices& options, const Mask& organs) {
    const std::vector<Tumour> all = tumours_in(organs);
    if (all.empty())
        throw InputError("the case holds no tumour", options.patient.string(),
                         "Reconstruct with --tumour-mask FILE, paint one (edit --paint-tumour), or "
                         "name a place: --at-mm X,Y,Z");
    std::vector<std::uint8_t> labels;
    for (const Tumour& tumour : all)
        if (options.tumour == 0 || options.tumour == tumour.number)
            labels.push_back(label_of_tumour(tumour.number));
    if (labels.empty())
        throw UsageError("there is no tumour " + std::to_string(options.tumour), "--tumour",
                         "The case holds " + numbers_of(all));
    return labels;
}

// Labels the liver within a ball as the only tumour.
std::vector<std::uint8_t> mark_ball(const FeedersChoices& options, Mask& organs) {
    const auto [x, y, z] = parse_triple("--at-mm", options.at_mm);
    const Vec3 at(x, y, z);
    bool any = false;
    for (std::size_t i = 0; i < organs.voxels.size(); ++i) {
        const auto [u, v, w] = organs.grid.index_of(i);
        const bool inside = (organs.grid.to_mm(u, v, w) - at).norm() <= options.radius_mm;
        const bool liver = organs.voxels[i] != 0 && organs.voxels[i] != organ_label::cava;
        if (liver) organs.voxels[i] = inside ? organ_label::first_tumour : organ_label::liver;
        any = any || (inside && liver);
    }
    if (!any)
        throw InputError("nothing of the liver lies there", "--at-mm " + options.at_mm,
                         "Name a place inside the liver, X,Y,Z in LPS [mm]");
    return {organ_label::first_tumour};
}

Json to_json(const Feeder& feeder, const VesselTree& tree,
             const std::optional<LabelledPortalVein>& portal) {
    const VesselSegment& segment = tree.segments[feeder.segment];
    const Vec3& at = segment.points_mm.front();
    Json json{{"segment", feeder.segment},
              {"system", name_of(feeder.system)},
              {"share", feeder.share},
              {"begins_mm", {at.x(), at.y(), at.z()}},
              {"radius_mm", segment.radii_mm.front()}};
    if (portal && feeder.system == VascularSystem::portal)
        json["couinaud"] = portal->branches[feeder.segment].segment;
    return json;
}

Json run_feeders(const FeedersChoices& options, Job& job) {
    job.expect_stages(2);
    job.begin_stage("Reading the case");
    PatientCase patient = read_case(options.patient);
    const Mask liver = liver_of(patient.organs);
    if (liver.voxels.empty())
        throw InputError("the case holds no liver", options.patient.string(),
                         "Reconstruct with --liver-mask FILE");
    const std::vector<std::uint8_t> wanted = options.at_mm.empty()
                                                 ? wanted_tumours(options, patient.organs)
                                                 : mark_ball(options, patient.organs);
    job.begin_stage("Following the vessels");
    const auto feeders = feeders_of(patient.tree, liver, patient.organs, wanted, job);
    const auto portal = label_portal_vein(patient.tree, liver);
    Json list = Json::array();
    for (std::size_t w = 0; w < wanted.size(); ++w)
        for (const Feeder& feeder : feeders[w]) {
            Json one = to_json(feeder, patient.tree, portal);
            if (options.at_mm.empty()) one["tumour"] = tumour_of(wanted[w]);
            list.push_back(std::move(one));
        }
    if (list.empty())
        throw InputError("nothing tells which vessels bring blood", options.patient.string(),
                         "Reconstruct with a seed inside the portal vein: --seed-mm X,Y,Z,portal");
    return {{"case", options.patient.string()}, {"feeders", list}};
}

}  // namespace

void add_feeders(CommandLine& line) {
    auto options = std::make_shared<FeedersChoices>();
    CLI::App& verb = line.add_verb("feeders", "Branches that feed a case's tumours, with shares",
                                   [options](Job& job) { return run_feeders(*options, job); });
    verb.add_option("case", options->patient, "Case folder (NAME.hep)")->required();
    auto* tumour =
        verb.add_option("--tumour", options->tumour, "Only this one, as edit --list numbers them")
            ->check(CLI::Range(1, most_tumours));
    auto* at = verb.add_option("--at-mm", options->at_mm,
                               "Instead of a tumour: what of the liver lies about X,Y,Z [LPS mm]");
    verb.add_option("--radius-mm", options->radius_mm, "How far about it")
        ->check(CLI::Range(1.0, 100.0))
        ->needs(at)
        ->capture_default_str();
    at->excludes(tumour);
}

}  // namespace hepatica
