// SPDX-License-Identifier: GPL-3.0-or-later
// reconstruct: makes a patient's case from a contrast CT (core/reconstruction/reconstruct.h), or
// cases from many (app/batch/batch_run.h).
#include <spdlog/spdlog.h>

#include <charconv>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "app/as_published.h"
#include "app/batch/batch_run.h"
#include "app/output_place.h"
#include "app/verbs/reconstruction_json.h"
#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/patient/doubts_json.h"
#include "core/patient/image_digest.h"
#include "core/patient/liver_segments.h"
#include "core/reconstruction/reconstruct.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

struct ReconstructChoices {
    ReconstructOptions reconstruct;
    fs::path out;
    fs::path liver_mask;
    fs::path vessel_mask;
    std::vector<double> window;
    std::vector<std::string> seeds;
    std::vector<std::string> vessel_labels;
    std::string method = "coherent";
    std::string model = "none";
    std::string offers = "shipped";
    std::string thinning = "queue";
    bool as_published = false;
    bool replace = false;
    BatchOptions batch;
};

VascularSystem parse_system(const std::string& option, const std::string& text) {
    if (const auto system = system_named(text)) return *system;
    throw UsageError("\"" + text + "\" is no vascular system", option,
                     "Choose a name or a number: " + list_of_systems());
}

// Parses "LABEL=SYSTEM", or "LABEL" for vessels of an unknown system.
VesselLabel parse_vessel_label(const std::string& text) {
    VesselLabel named;
    const std::size_t equals = text.find('=');
    const char* end = text.data() + std::min(equals, text.size());
    const auto [rest, error] = std::from_chars(text.data(), end, named.label);
    if (error != std::errc{} || rest != end || named.label < 1 || named.label > 65535)
        throw UsageError("\"" + text + "\" names no label", "--vessel-label",
                         "Write LABEL=SYSTEM, for example 64=portal; labels go from 1 to 65535");
    if (equals != std::string::npos)
        named.system = parse_system("--vessel-label", text.substr(equals + 1));
    return named;
}

std::vector<VesselLabel> parse_vessel_labels(const std::vector<std::string>& texts) {
    std::vector<VesselLabel> labels;
    for (const std::string& text : texts) {
        if (texts.size() > 1 && text.find('=') == std::string::npos)
            throw UsageError("it is not said which system the label " + text + " is",
                             "--vessel-label",
                             "Write LABEL=SYSTEM,LABEL=SYSTEM; systems: " + list_of_systems());
        labels.push_back(parse_vessel_label(text));
    }
    return labels;
}

// Parses "X,Y,Z" or "X,Y,Z,SYSTEM".
VesselSeed parse_seed(const std::string& text) {
    VesselSeed seed;
    std::string position = text;
    if (std::ranges::count(text, ',') == 3) {
        const std::size_t comma = text.rfind(',');
        seed.system = parse_system("--seed-mm", text.substr(comma + 1));
        position = text.substr(0, comma);
    }
    const auto numbers = parse_triple("--seed-mm", position);
    seed.position_mm = Vec3(numbers[0], numbers[1], numbers[2]);
    return seed;
}

// A model's file: nothing for "none", the program's own for "shipped".
std::optional<fs::path> model_named(const std::string& name) {
    if (name == "none") return std::nullopt;
    return name == "shipped" ? shipped_link_model() : fs::path(name);
}

std::optional<fs::path> parse_model(const ReconstructChoices& options) {
    if (options.model == "none") return std::nullopt;
    if (options.method != "coherent" || options.as_published || !options.window.empty() ||
        !options.vessel_mask.empty())
        throw UsageError("there is nothing to choose for a model", "--model",
                         "Give it with --method coherent, without --window, --vessel-mask and "
                         "--as-published, or leave it out");
    return model_named(options.model);
}

void parse(ReconstructChoices& options) {
    static const std::map<std::string, SegmentationMethod> methods{
        {"coherent", SegmentationMethod::coherent},
        {"multi-layer", SegmentationMethod::multi_layer},
        {"vesselness", SegmentationMethod::vesselness}};
    ReconstructOptions& reconstruct = options.reconstruct;
    if (!options.liver_mask.empty() && options.batch.folder.empty())
        reconstruct.liver_mask = options.liver_mask;
    if (!options.vessel_mask.empty()) reconstruct.vessel_mask = options.vessel_mask;
    if (!options.window.empty()) {
        if (options.window.size() != 2 || !(options.window[0] < options.window[1]))
            throw UsageError("is not a lower and an upper bound", "--window", "Write LO,HI in HU");
        reconstruct.window_hu = {options.window[0], options.window[1]};
    }
    for (const std::string& seed : options.seeds) reconstruct.seeds.push_back(parse_seed(seed));
    reconstruct.vessel_labels = parse_vessel_labels(options.vessel_labels);
    reconstruct.method = methods.at(options.method);
    reconstruct.model = parse_model(options);
    reconstruct.offers = model_named(options.offers);
    if (options.thinning == "parallel") reconstruct.thinning = ThinningMethod::parallel;
    require_utf8("--name", reconstruct.name);
    if (options.as_published) use_as_published(reconstruct);
}

Json to_json(const VoxelCounts& counts) {
    return {{"voxels", counts.voxels},
            {"components", counts.components},
            {"tunnels", counts.tunnels},
            {"cavities", counts.cavities}};
}

// Reconstructs many CTs: --batch replaces the CT, and --liver-mask names a folder of masks.
Json run_many(const ReconstructChoices& options, Job& job) {
    BatchOptions batch = options.batch;
    if (batch.task > batch.tasks)
        throw UsageError(
            "there is no task " + std::to_string(batch.task) + " of " + std::to_string(batch.tasks),
            "--task", "Tasks go from 1 to what --of says");
    batch.out = options.out;
    batch.liver_masks = options.liver_mask;
    batch.reconstruct = options.reconstruct;
    return run_batch(batch, job);
}

// As soon as the CT is read, before the long work.
void require_same_ct_at(const ReconstructChoices& options, const Volume& ct) {
    if (options.replace || !is_replaceable_case(options.out)) return;
    PatientCase patient;
    patient.source.image_sha256 = digest_of(ct);
    require_same_patient_at(options.out, patient, options.replace);
}

Json run_reconstruct(ReconstructChoices options, Job& job) {
    parse(options);
    if (!options.batch.folder.empty()) return run_many(options, job);
    if (options.reconstruct.ct.empty())
        throw UsageError("no CT is given", "ct", "Name one, or a folder of CTs with --batch");
    require_case_place(options.out);
    require_replaceable_case(options.out);
    job.expect_stages(stage_count(options.reconstruct) + 1);
    const Reconstruction made = reconstruct(
        options.reconstruct, job,
        [&](const std::shared_ptr<const Volume>& ct) { require_same_ct_at(options, *ct); });
    job.begin_stage("Writing the case");
    write_case_in_job(options.out, made.patient, job);
    for (const std::string& warning : made.warnings) spdlog::warn("{}", warning);

    Json answer;
    const Grid& grid = made.patient.source.image_grid;
    answer["case"] = options.out.string();
    answer["image"] = {
        {"dims", grid.dims},
        {"spacing_mm", {grid.spacing_mm.x(), grid.spacing_mm.y(), grid.spacing_mm.z()}}};
    answer["stages"] = Json::array();
    for (const StageTime& stage : job.stage_times())
        answer["stages"].push_back({{"name", stage.name}, {"seconds", stage.seconds}});
    answer["mask"] = to_json(made.checks.mask);
    answer["skeleton"] = to_json(made.checks.skeleton);
    answer["skeleton"]["crowded_points"] = made.checks.crowded_points;
    answer["tree"] = to_json(made.patient.tree);
    answer["bridges"] = to_json(made.patient.corrections.bridges);
    answer["mesh"] = to_json(made.patient.mesh);
    if (!made.patient.couinaud.voxels.empty())
        answer["segments_ml"] = segments_ml_json(made.patient.couinaud);
    answer["doubts"] = json_of(*made.patient.doubts);
    answer["warnings"] = made.warnings;
    return answer;
}

CLI::Option* add_batch_options(CLI::App& verb, BatchOptions& batch) {
    CLI::Option* folder =
        verb.add_option("--batch", batch.folder,
                        "Instead of a CT: all CTs of this folder, into the folder --out; goes on "
                        "where it stopped. --liver-mask then names a folder of masks");
    verb.add_option("--task", batch.task, "Of the batch only this share ...")
        ->check(CLI::Range(1, 100'000))
        ->needs(folder)
        ->capture_default_str();
    verb.add_option("--of", batch.tasks, "... of so many, as in an array of cluster jobs")
        ->check(CLI::Range(1, 100'000))
        ->needs(folder)
        ->capture_default_str();
    verb.add_flag("--retry", batch.retry, "Of the batch those that failed, too")->needs(folder);
    verb.add_flag(
            "--keep-names", batch.keep_names,
            "Call patients as their scans are called; else by pseudonyms, which OUT/names.csv "
            "resolves")
        ->needs(folder);
    return folder;
}

// Returns the option of the CT.
CLI::Option* add_images(CLI::App& verb, ReconstructChoices& options) {
    ReconstructOptions& reconstruct = options.reconstruct;
    CLI::Option* ct =
        verb.add_option("ct", reconstruct.ct, "DICOM folder, or .nii .nii.gz .mha .nrrd file");
    verb.add_option("--series", reconstruct.series,
                    "Which series of a DICOM folder, as the warnings number them; 1 is the best")
        ->check(CLI::Range(1, 10000));
    CLI::Option* liver_mask =
        verb.add_option("--liver-mask", options.liver_mask, "Image whose nonzero voxels are liver");
    CLI::Option* vessel_mask =
        verb.add_option("--vessel-mask", options.vessel_mask,
                        "Image of the vessels, its labels their systems: nothing is segmented");
    verb.add_option("--tumour-mask", reconstruct.tumour_masks,
                    "Image whose nonzero pieces are tumours, for `feeders`; may be repeated");
    verb.add_option("--liver-label", reconstruct.liver_labels,
                    "Labels of the liver mask that are liver; without it all that are not 0")
        ->delimiter(',')
        ->needs(liver_mask);
    verb.add_option(
            "--vessel-label", options.vessel_labels,
            "LABEL=SYSTEM,LABEL=SYSTEM: labels of the vessel mask that are vessels; without "
            "it a single label is an unknown system, several are 1 portal, 2 hepatic, "
            "3 artery, 255 unknown")
        ->delimiter(',')
        ->needs(vessel_mask);
    return ct;
}

void add_methods(CLI::App& verb, ReconstructChoices& options) {
    ReconstructOptions& reconstruct = options.reconstruct;
    verb.add_option("--window", options.window, "Vessels lie within LO,HI [HU]")->delimiter(',');
    verb.add_option(
        "--seed-mm", options.seeds,
        "X,Y,Z[,SYSTEM] inside a vessel [LPS mm], SYSTEM portal, hepatic or artery; may be "
        "repeated");
    verb.add_option("--method", options.method, "How vessels are segmented")
        ->check(CLI::IsMember({"coherent", "multi-layer", "vesselness"}))
        ->capture_default_str();
    verb.add_option("--model", options.model,
                    "What chooses among lines that are fainter than --method coherent believes: a "
                    "file that `train` made, shipped (the one that comes with the program) or none")
        ->capture_default_str();
    verb.add_option("--offers", options.offers,
                    "What offers branches among those lines where --model chooses none: shipped, a "
                    "file or none. `edit` takes or refuses them")
        ->capture_default_str();
    verb.add_option("--accept-bridges", reconstruct.bridge_confidence,
                    "Bridge gaps of this confidence or more; the others are offered")
        ->check(CLI::Range(0.0, 1.0))
        ->capture_default_str();
    verb.add_option("--thinning", options.thinning, "How the mask is thinned")
        ->check(CLI::IsMember({"queue", "parallel"}))
        ->capture_default_str();
    verb.add_option("--refine", reconstruct.refinement_recursions,
                    "Recursions of the Gaussian refinement, 0 to 10")
        ->check(CLI::Range(0, 10))
        ->capture_default_str();
    verb.add_option("--spacing-mm", reconstruct.spacing_mm,
                    "Working grid, isotropic; 0 stands for 0.65")
        ->check(CLI::Range(0.0, 1.5))
        ->capture_default_str();
    verb.add_option("--tetrahedra", reconstruct.mesh.target_tetrahedra,
                    "About so many tetrahedra; 0 lets the radii decide")
        ->check(CLI::Range(0, 2'000'000))
        ->capture_default_str();
    CLI::Option* as_published =
        verb.add_flag("--as-published", options.as_published,
                      "As the paper has it: --method multi-layer --refine 1 --thinning parallel");
    for (const char* other : {"--method", "--refine", "--thinning"})
        as_published->excludes(verb.get_option(other));
}

}  // namespace

void add_reconstruct(CommandLine& line) {
    auto options = std::make_shared<ReconstructChoices>();
    CLI::App& verb = line.add_verb("reconstruct", "Make a patient's case from a contrast CT",
                                   [options](Job& job) { return run_reconstruct(*options, job); });
    CLI::Option* ct = add_images(verb, *options);
    verb.add_option("--out", options->out,
                    "Case to make: NAME.hep, a folder, or NAME.hepz, one file")
        ->required();
    verb.add_flag("--replace", options->replace, replace_help);
    verb.add_option("--name", options->reconstruct.name,
                    "What pictures and reports call the patient; nothing else names them");
    add_methods(verb, *options);
    for (const char* of_segmenting : {"--method", "--window", "--spacing-mm"})
        verb.get_option("--vessel-mask")->excludes(verb.get_option(of_segmenting));
    // One value each time: they would take the CT for a further one.
    for (const char* of_several :
         {"--tumour-mask", "--liver-label", "--vessel-label", "--window", "--seed-mm"})
        verb.get_option(of_several)->allow_extra_args(false);
    CLI::Option* batch = add_batch_options(verb, options->batch)->excludes(ct);
    for (const char* of_one :
         {"--replace", "--series", "--name", "--vessel-mask", "--tumour-mask", "--seed-mm"})
        batch->excludes(verb.get_option(of_one));
}

}  // namespace hepatica
