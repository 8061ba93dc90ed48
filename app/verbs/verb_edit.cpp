// SPDX-License-Identifier: GPL-3.0-or-later
// edit: corrects a case: links, branches, roots and systems of its tree, its bridges and its
// tumours (core/patient/corrections.h).
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include "app/output_place.h"
#include "app/verbs/brush_dab.h"
#include "app/verbs/reconstruction_json.h"
#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/base/patient_space.h"
#include "core/base/text_file.h"
#include "core/mesh/manifold_attempts.h"
#include "core/opening/patient_image.h"
#include "core/patient/case_digest.h"
#include "core/patient/corrections.h"
#include "core/patient/painted_tumours.h"
#include "core/tree/editing/doubtful_link.h"
#include "core/tree/editing/given_already.h"
#include "core/tree/editing/vessel_tracing.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

struct EditChoices {
    fs::path patient;
    fs::path edits;
    fs::path out;
    std::vector<double> places;  // points of a vessel to draw, three numbers each
    fs::path ct;
    std::vector<std::string> seeds;  // X,Y,Z,SYSTEM
    double accept = std::numeric_limits<double>::infinity();
    double refuse_below = -1.0;
    std::vector<int> accepted, refused, offered;  // numbers of bridges, counted from 1
    std::vector<std::string> painted, erased;     // strokes on tumours, X,Y,Z,RADIUS
    int tumour = 0;  // tumour of these strokes; 0: a new one to paint, any to erase
    int undo = 0;
    bool list = false;
    bool replace = false;

    bool decides_bridges() const {
        return refuse_below >= 0.0 || !accepted.empty() || !refused.empty() || !offered.empty();
    }
    bool does_nothing() const {
        return edits.empty() && places.empty() && seeds.empty() && accept > 1.0 &&
               !decides_bridges() && painted.empty() && erased.empty() && tumour == 0 && undo == 0;
    }
};

std::vector<TreeEdit> edits_in(const fs::path& file) {
    return edits_from_json(read_text_file(file, "Give a file of edits (docs/corrections.md)"),
                           file.string());
}

// Indices in corrections.bridges of the numbers given to an option.
std::vector<std::size_t> bridges_named(const std::string& option, const std::vector<int>& numbers,
                                       const PatientCase& patient) {
    std::vector<std::size_t> indices;
    const auto count = static_cast<int>(patient.corrections.bridges.size());
    for (const int number : numbers) {
        if (number < 1 || number > count)
            throw UsageError(
                "there is no bridge " + std::to_string(number), option,
                "The case holds " + std::to_string(count) + "; --list numbers them from 1");
        indices.push_back(static_cast<std::size_t>(number) - 1);
    }
    return indices;
}

void require_state(const PatientCase& patient, std::size_t index, const std::string& option,
                   std::initializer_list<BridgeState> fitting) {
    const BridgeState state = state_of_bridge(patient, index);
    if (std::ranges::find(fitting, state) != fitting.end()) return;
    throw UsageError("bridge " + std::to_string(index + 1) + " is " + name_of(state), option,
                     state == BridgeState::accepted ? "Take its edit back: --undo"
                                                    : "See what can be decided: --list");
}

// Refuses by confidence, then offers again, accepts and refuses the named bridges, as they are
// after `edits` and the decisions before.
void decide_bridges(const EditChoices& options, const PatientCase& patient,
                    std::vector<TreeEdit>& edits) {
    if (!options.decides_bridges()) return;
    PatientCase now = with_edited_tree(patient, edits);
    const std::vector<Bridge>& bridges = now.corrections.bridges;
    const auto make = [&](const TreeEdit& edit) {
        edits.push_back(edit);
        now.corrections.edits = edits;
    };
    const auto offer = [&](const Bridge& bridge) {
        std::erase_if(edits, [&](const TreeEdit& edit) {
            return edit.kind == TreeEditKind::refuse_gap && refuses(edit, bridge);
        });
        now.corrections.edits = edits;
    };
    for (std::size_t i = 0; i < bridges.size(); ++i)
        if (bridges[i].confidence < options.refuse_below &&
            state_of_bridge(now, i) == BridgeState::open)
            make(refusal_of(bridges[i]));
    for (const std::size_t i : bridges_named("--offer", options.offered, now)) offer(bridges[i]);
    for (const std::size_t i : bridges_named("--accept", options.accepted, now)) {
        require_state(now, i, "--accept", {BridgeState::open, BridgeState::refused});
        offer(bridges[i]);
        make(acceptance_of(bridges[i]));
    }
    for (const std::size_t i : bridges_named("--refuse", options.refused, now)) {
        require_state(now, i, "--refuse", {BridgeState::open, BridgeState::built});
        make(refusal_of(bridges[i]));
    }
}

// The edit that draws a vessel along the given places.
TreeEdit drawn_vessel(const EditChoices& options, const PatientCase& patient, Job& job) {
    if (options.places.size() % 3 != 0)
        throw UsageError(std::to_string(options.places.size()) + " numbers are no places", "--draw",
                         "Give X,Y,Z in mm for each place, two or more");
    std::vector<Vec3> places;
    for (std::size_t i = 0; i < options.places.size(); i += 3)
        places.emplace_back(options.places[i], options.places[i + 1], options.places[i + 2]);
    const Volume ct = image_of(patient, options.ct, job);
    const double contrast_hu = blood_contrast_hu(ct, patient.tree);
    places = begun_in_vessel(ct, patient.tree, std::move(places), contrast_hu);
    return drawing_of(traced_vessel(ct, places, contrast_hu, job));
}

// Parses X,Y,Z,SYSTEM.
TreeEdit seed_in(const std::string& text) {
    const auto comma = text.find_last_of(',');
    const auto commas = std::ranges::count(text, ',');
    if (commas != 3) {
        // A system's number, as the 3 of 1,2,3 might be, stands behind three numbers.
        const bool place_alone =
            commas == 2 && text.find_first_not_of("+-.,0123456789eE") == std::string::npos;
        throw UsageError("\"" + text + "\" " + (place_alone ? "names no system" : "is no seed"),
                         "--seed",
                         "Write X,Y,Z,SYSTEM in mm, where SYSTEM is one of " + list_of_systems());
    }
    TreeEdit edit;
    edit.kind = TreeEditKind::seed_system;
    const auto numbers = parse_triple("--seed", text.substr(0, comma));
    edit.at_mm = Vec3(numbers[0], numbers[1], numbers[2]);
    const std::string name = text.substr(comma + 1);
    const auto system = system_named(name);
    if (!system)
        throw UsageError("there is no vascular system " + name, "--seed",
                         "Name one of these: " + list_of_systems());
    edit.system = *system;
    return edit;
}

// Adds the strokes on tumours to the edits: what is painted, then what is erased.
void add_tumour_strokes(const EditChoices& options, const PatientCase& patient,
                        std::vector<TreeEdit>& edits) {
    if (options.tumour != 0 && options.painted.empty() && options.erased.empty())
        throw UsageError("tumour " + std::to_string(options.tumour) + " is given nothing to do",
                         "--tumour", "Give --paint-tumour or --erase-tumour X,Y,Z,RADIUS, too");
    int painted = options.tumour;
    if (painted == 0 && !options.painted.empty()) {
        PatientCase now = patient;
        set_tumour_strokes(now, edits);
        painted = number_for_new(tumours_in(now.organs));
        if (painted == 0)
            throw UsageError("there is no room for another tumour", "--paint-tumour",
                             "Name one that is there: --tumour N");
    }
    for (const std::string& text : options.painted)
        edits.push_back(tumour_edit(dab("--paint-tumour", text, false), painted));
    for (const std::string& text : options.erased)
        edits.push_back(tumour_edit(dab("--erase-tumour", text, true), options.tumour));
    if (!tumour_strokes(edits).empty() && tumour_canvas(patient).voxels.empty())
        throw InputError("holds no voxels that could be tumour", options.patient.string(),
                         "Reconstruct the case from its CT");
}

// Appends the edits of a file, whose steps are no part of those of the case.
void append(const std::vector<TreeEdit>& more, std::vector<TreeEdit>& edits) {
    int step = 0;
    for (std::size_t i = 0; i < more.size(); ++i) {
        if (more[i].step > 0 && (i == 0 || !of_one_step(more[i - 1], more[i])))
            step = next_step(edits);
        edits.push_back(more[i]);
        if (more[i].step > 0) edits.back().step = step;
    }
}

// The case with its new edits: the last ones undone if requested, then those of the file, drawn
// vessels, seeds, tumours and bridges.
PatientCase corrected(const EditChoices& options, PatientCase patient, Job& job) {
    std::vector<TreeEdit> edits = patient.corrections.edits;
    if (options.undo > static_cast<int>(edits.size()))
        throw UsageError(std::to_string(options.undo) + " edits cannot be taken back", "--undo",
                         "The case holds " + std::to_string(edits.size()));
    edits.resize(edits.size() - static_cast<std::size_t>(options.undo));
    if (!options.edits.empty()) append(edits_in(options.edits), edits);
    if (!options.places.empty()) {
        const PatientCase now = with_edited_tree(patient, edits);
        edits.push_back(drawn_vessel(options, now, job));
    }
    for (const std::string& seed : options.seeds) edits.push_back(seed_in(seed));
    add_tumour_strokes(options, patient, edits);
    decide_bridges(options, patient, edits);
    if (options.accept <= 1.0) {
        const std::vector<TreeEdit> links = acceptances_after(patient, edits, options.accept, job);
        edits.insert(edits.end(), links.begin(), links.end());
    }
    return with_edits(patient, edits, job);
}

// All bridges ever found, by number.
Json bridges_of(const PatientCase& patient) {
    Json list = to_json(patient.corrections.bridges);
    for (std::size_t i = 0; i < list.size(); ++i) {
        list[i].erase("built");
        list[i]["number"] = i + 1;
        list[i]["state"] = name_of(state_of_bridge(patient, i));
    }
    return list;
}

Json tumours_of(const PatientCase& patient) {
    Json list = Json::array();
    for (const Tumour& tumour : tumours_in(patient.organs)) {
        const Vec3& middle = tumour.middle_mm;
        list.push_back({{"tumour", tumour.number},
                        {"volume_ml", tumour.volume_ml},
                        {"middle_mm", {middle.x(), middle.y(), middle.z()}}});
    }
    return list;
}

// Of the new edits those that give a vessel to the system that it had before them, and links that
// may have been made by mistake.
std::vector<std::string> doubts_of_edits(const PatientCase& patient, std::size_t edits_before) {
    std::vector<std::string> warnings;
    const std::vector<TreeEdit>& edits = patient.corrections.edits;
    if (edits_before >= edits.size()) return warnings;
    const auto first = edits.begin() + static_cast<std::ptrdiff_t>(edits_before);
    VesselTree tree = with_edited_tree(patient, {edits.begin(), first}).tree;
    for (auto edit = first; edit != edits.end(); ++edit) {
        if (is_given_already(tree, *edit))
            warnings.push_back(
                "The vessel at " + place_text(edit->at_mm) +
                " was of the system that it is given to already: " + title_of(edit->system) +
                ". Nothing changes but that its system counts as sure; if another "
                "was meant, take the edit back (--undo).");
        for (const std::string& doubt : doubts_of_link(tree, *edit))
            warnings.push_back("Link from " + place_text(edit->at_mm) + " to " +
                               place_text(edit->to_mm) + ": " + doubt +
                               " If that was not meant, take the edit back (--undo).");
        tree = edited(tree, *edit);
    }
    return warnings;
}

// What is odd about the tree, and of the new edits which change nothing, which links are doubtful
// and which tumours are cut off.
std::vector<std::string> warnings_of(const PatientCase& patient, std::size_t edits_before) {
    std::vector<std::string> warnings = sentences(std::nullopt, patient.tree);
    std::ranges::copy_if(patient.warnings, std::back_inserter(warnings), is_of_unclosed);
    const std::vector<TreeEdit>& edits = patient.corrections.edits;
    const Grid canvas = tumour_canvas(patient).grid;
    for (std::size_t i = edits_before; i < edits.size(); ++i)
        if (edits[i].kind == TreeEditKind::paint_tumour &&
            reaches_beyond(stroke_of(edits[i]), canvas))
            warnings.push_back("Tumour " + std::to_string(edits[i].tumour) + " painted at " +
                               place_text(edits[i].at_mm) +
                               " reaches beyond the part of the CT about the liver that a case "
                               "keeps: what lies outside of it is left out. Paint it elsewhere, or "
                               "take the edit back (--undo).");
    std::ranges::move(doubts_of_edits(patient, edits_before), std::back_inserter(warnings));
    return warnings;
}

Json run_edit(const EditChoices& options, Job& job) {
    if (options.list && !(options.does_nothing() && options.out.empty()))
        throw UsageError("changes nothing and writes nothing", "--list",
                         "Leave it out, or the corrections and --out");
    if (!options.out.empty()) require_case_place(options.out);
    if (options.does_nothing() && !options.list && options.out.empty())
        throw UsageError("is given nothing to do", "edit",
                         "Give a correction, --out for a copy, or --list; all are in edit --help");
    job.expect_stages(options.list ? 1 : options.places.empty() ? 4 : 5);
    job.begin_stage("Reading the case");
    const std::string digest = digest_of_case(options.patient);
    PatientCase patient = read_case(options.patient);
    if (!options.out.empty()) require_same_patient_at(options.out, patient, options.replace);
    const std::size_t before = patient.corrections.edits.size();
    if (!options.list) {
        patient = corrected(options, std::move(patient), job);
        job.begin_stage("Writing the case");
        if (is_in_place(options.out, options.patient)) require_as_read(options.patient, digest);
        write_case_in_job(options.out.empty() ? options.patient : options.out, patient, job);
    }
    Json answer;
    answer["case"] = (options.out.empty() ? options.patient : options.out).string();
    answer["edits_before"] = before;
    answer["edits"] = Json::parse(edits_to_json(patient.corrections.edits));
    const auto undone = static_cast<std::size_t>(options.undo);
    answer["warnings"] = warnings_of(patient, options.list ? before : before - undone);
    answer["tree"] = to_json(patient.tree);
    answer["mesh"] = to_json(patient.mesh);
    answer["tumours"] = tumours_of(patient);
    answer["bridges"] = bridges_of(patient);
    answer["open_bridges"] = to_json(open_bridges(patient));
    return answer;
}

}  // namespace

void add_edit(CommandLine& line) {
    auto options = std::make_shared<EditChoices>();
    CLI::App& verb = line.add_verb(
        "edit", "Correct a case: its tree's links, branches, roots, systems; its tumours",
        [options](Job& job) { return run_edit(*options, job); });
    verb.add_option("case", options->patient, "Case to correct")->required();
    verb.add_option("--edits", options->edits, "JSON array of edits, made after those it holds");
    CLI::Option* draw =
        verb.add_option("--draw", options->places,
                        "Draw a vessel through these places of the CT, X,Y,Z,X,Y,Z,... in mm, from "
                        "where its blood comes in")
            ->delimiter(',');
    verb.add_option("--ct", options->ct, "CT of the case, for --draw: a folder or a file")
        ->needs(draw);
    verb.add_option("--seed", options->seeds,
                    "X,Y,Z,SYSTEM: the vessel at this place is of SYSTEM, with all that goes with "
                    "it; once for each");
    verb.add_option("--paint-tumour", options->painted,
                    "X,Y,Z,RADIUS: this ball of voxels is tumour; once for each ball");
    verb.add_option("--erase-tumour", options->erased,
                    "X,Y,Z,RADIUS: this ball is no tumour; once for each, after what is painted");
    verb.add_option("--tumour", options->tumour,
                    "Which tumour that is, as --list numbers them; else a new one is painted, and "
                    "any erased")
        ->check(CLI::Range(1, most_tumours));
    verb.add_option("--undo", options->undo, "Take back so many of the last edits first")
        ->check(whole_number_from(0));
    verb.add_option("--accept-bridges", options->accept,
                    "Build the bridges that are offered with this confidence or more")
        ->check(CLI::Range(0.0, 1.0));
    verb.add_option("--refuse-bridges", options->refuse_below,
                    "Offer no more the bridges of less than this confidence")
        ->check(CLI::Range(0.0, 1.0));
    verb.add_option("--accept", options->accepted,
                    "Build these bridges, N,N as --list numbers them")
        ->delimiter(',');
    verb.add_option("--refuse", options->refused,
                    "Offer these no more; one that the reconstruction built is cut")
        ->delimiter(',');
    verb.add_option("--offer", options->offered, "Offer these again, which were refused")
        ->delimiter(',');
    verb.add_option("--out", options->out,
                    "Write another case, NAME.hep or NAME.hepz, instead of changing this one");
    verb.add_flag("--replace", options->replace, replace_help)->needs("--out");
    verb.add_flag("--list", options->list, "Change nothing: print edits, tumours and bridges");
}

}  // namespace hepatica
