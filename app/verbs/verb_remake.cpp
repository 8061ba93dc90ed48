// SPDX-License-Identifier: GPL-3.0-or-later
// remake: makes a case anew from other voxels of its vessels: given, painted, or found with another
// threshold (core/reconstruction/remade_case.h).
#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "app/output_place.h"
#include "app/verbs/brush_dab.h"
#include "app/verbs/reconstruction_json.h"
#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/base/patient_space.h"
#include "core/image/brush.h"
#include "core/image/volume_reader.h"
#include "core/opening/patient_image.h"
#include "core/patient/case_digest.h"
#include "core/patient/corrections.h"
#include "core/patient/painted_tumours.h"
#include "core/reconstruction/given_vessels.h"
#include "core/reconstruction/remade_case.h"
#include "core/reconstruction/vessel_preview.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

struct RemakeChoices {
    fs::path patient;
    fs::path vessels;
    fs::path ct;
    fs::path out;
    std::vector<std::string> painted, erased;  // X,Y,Z,RADIUS
    ThresholdChoice threshold;
    bool replace = false;
};

// Strokes in the order of their effect: what is painted, then what is erased.
std::vector<BrushStroke> dabs(const RemakeChoices& options) {
    std::vector<BrushStroke> strokes;
    for (const std::string& text : options.painted) strokes.push_back(dab("--paint", text, false));
    for (const std::string& text : options.erased) strokes.push_back(dab("--erase", text, true));
    return strokes;
}

constexpr auto unknown = static_cast<std::uint8_t>(number_of(VascularSystem::unknown));

// Whether the vessels are searched anew, with another threshold or a smoother surface.
bool searches(const RemakeChoices& options) {
    return options.threshold.line_share != 1.0 || options.threshold.refinement_recursions != 0;
}

// Where the case has one system and the file marks nothing but its number, that is meant; otherwise
// a mask of one number says nothing of systems.
std::vector<VesselLabel> only_system(const Mask& of_case, const LabelMap& labels) {
    std::uint8_t only = 0;
    for (const std::uint8_t voxel : of_case.voxels) {
        if (voxel == 0 || voxel == unknown || voxel == only) continue;
        if (only != 0) return {};
        only = voxel;
    }
    const auto system = system_numbered(only);
    if (!system || std::ranges::any_of(labels.voxels, [&](auto v) { return v != 0 && v != only; }))
        return {};
    return {{only, *system}};
}

// The vessels of the file, or else the case's.
Mask wanted_vessels(const RemakeChoices& options, const PatientCase& patient, const Grid& ct_grid,
                    std::vector<std::string>& warnings, Job& job) {
    Mask vessels = patient.mask;
    if (!options.vessels.empty()) {
        const LabelMap labels = read_label_map(options.vessels, job);
        if (same_grid(labels.grid, patient.mask.grid)) {
            vessels = systems_of_labels(labels, only_system(patient.mask, labels),
                                        options.vessels.string(), warnings, job);
            vessels.grid = patient.mask.grid;  // the file stores it in single precision
        } else {
            vessels = read_given_vessels(options.vessels, {}, ct_grid, warnings, job);
        }
    } else if (vessels.voxels.empty()) {
        throw InputError("holds no voxels of its vessels", options.patient.string(),
                         "Give some: --vessels FILE");
    }
    return vessels;
}

void paint(const std::vector<BrushStroke>& strokes, Mask& vessels,
           std::vector<std::string>& warnings) {
    for (const BrushStroke& stroke : strokes) {
        const Vec3& place = stroke.path_mm.front();
        if (!holds(vessels.grid, place))
            warnings.push_back("The ball at " + place_text(place) +
                               " lies outside of the vessels' voxels, which end near the liver: "
                               "what of it is outside changes nothing.");
        apply(stroke, painted_voxel, vessels);
    }
}

auto vessel_voxels(const Mask& mask) {
    return std::ranges::count_if(mask.voxels, [](auto voxel) { return voxel != 0; });
}

Json run_remake(const RemakeChoices& options, Job& job) {
    if (options.vessels.empty() && options.painted.empty() && options.erased.empty() &&
        !searches(options))
        throw UsageError("there is nothing to change", "remake",
                         "Give --vessels FILE, --paint X,Y,Z,RADIUS, --erase X,Y,Z,RADIUS, "
                         "--line-share SHARE or --refine N");
    if (!options.vessels.empty() && searches(options))
        throw UsageError("vessels of a file are taken as they are", "--vessels",
                         "Leave --line-share and --refine out, or --vessels");
    const fs::path& out = options.out.empty() ? options.patient : options.out;
    if (!options.out.empty()) require_case_place(options.out);
    const std::vector<BrushStroke> strokes =
        dabs(options);  // parsed first, so that errors precede the long work
    job.expect_stages(remade_stages + 3 + (searches(options) ? preview_stages : 0));
    job.begin_stage("Reading the case");
    const std::string digest = digest_of_case(options.patient);
    const PatientCase patient = read_case(options.patient);
    if (!options.out.empty()) require_same_patient_at(options.out, patient, options.replace);
    const Volume ct = image_of(patient, options.ct, job);
    std::vector<std::string> warnings;
    Mask vessels = wanted_vessels(options, patient, ct.grid, warnings, job);
    if (searches(options))
        vessels = VesselPreview(ct, unpainted_organs(patient), job)
                      .vessels(vessels, options.threshold, unknown, job);
    paint(strokes, vessels, warnings);  // last, so that what is erased stays away
    RemadeCase made = remade(patient, std::move(vessels), ct, job);
    note_rebuilding(patient, strokes.size(), made.patient);
    warnings.insert(warnings.end(), made.warnings.begin(), made.warnings.end());
    for (const std::string& warning : warnings) spdlog::warn("{}", warning);
    job.begin_stage("Writing the case");
    if (is_in_place(options.out, options.patient)) require_as_read(options.patient, digest);
    write_case_in_job(out, made.patient, job);
    Json answer;
    answer["case"] = out.string();
    answer["vessel_voxels_before"] = vessel_voxels(patient.mask);
    answer["vessel_voxels"] = vessel_voxels(made.patient.mask);
    answer["edits_before"] = patient.corrections.edits.size();
    answer["edits"] = made.patient.corrections.edits.size();
    answer["tree"] = to_json(made.patient.tree);
    answer["mesh"] = to_json(made.patient.mesh);
    answer["warnings"] = warnings;
    return answer;
}

}  // namespace

void add_remake(CommandLine& line) {
    auto options = std::make_shared<RemakeChoices>();
    CLI::App& verb = line.add_verb("remake", "Make a case anew from other voxels of its vessels",
                                   [options](Job& job) { return run_remake(*options, job); });
    verb.add_option("case", options->patient, "Case to change")->required();
    verb.add_option("--vessels", options->vessels,
                    "The vessels as another program left them: on the grid of the case's "
                    "mask.nii.gz, or on the CT's");
    verb.add_option("--paint", options->painted,
                    "X,Y,Z,RADIUS [mm]: a ball of vessel; may be repeated");
    verb.add_option("--erase", options->erased,
                    "X,Y,Z,RADIUS [mm]: a ball without vessel, after what is painted; may be "
                    "repeated");
    verb.add_option(
            "--line-share", options->threshold.line_share,
            "Share of the usual strength from which a line is believed to be a vessel, "
            "0.75 to 1.35: below 1 more and fainter vessels come in, above 1 the faintest go")
        ->check(CLI::Range(least_line_share, most_line_share));
    verb.add_option("--refine", options->threshold.refinement_recursions,
                    "Recursions of the Gaussian refinement of the surface, 0 to 10")
        ->check(CLI::Range(0, most_recursions));
    verb.add_option("--ct", options->ct,
                    "CT of the case: a folder or a file; the built-in patient needs none");
    verb.add_option("--out", options->out,
                    "Write another case, NAME.hep or NAME.hepz, instead of changing this one");
    verb.add_flag("--replace", options->replace, replace_help)->needs("--out");
}

}  // namespace hepatica
