// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and writes the files of a case, in a folder or unpacked from an archive.
#include "core/patient/patient_case.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "core/base/flush_to_disk.h"
#include "core/base/job.h"
#include "core/base/json_number.h"
#include "core/base/json_problem.h"
#include "core/base/temporary_folder.h"
#include "core/base/text_file.h"
#include "core/image/volume_reader.h"
#include "core/image/volume_writer.h"
#include "core/mesh/mesh_io.h"
#include "core/patient/case_archive.h"
#include "core/patient/case_folder.h"
#include "core/patient/case_header.h"
#include "core/patient/corrections.h"
#include "core/patient/format_1.h"
#include "core/patient/kept_files.h"
#include "core/patient/painted_tumours.h"
#include "core/tree/files/tree_io.h"

namespace hepatica {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

// Whether the case holds an optional file, whose digest is then checked.
bool holds(const fs::path& folder, const CaseHeader& header, const char* name) {
    if (!header.digests.contains(name)) return false;
    check_case_file(folder, header, name);
    return true;
}

Mask read_voxels(const fs::path& folder, const CaseHeader& header, const char* name) {
    if (!holds(folder, header, name)) return {};
    Job job;
    const LabelMap labels = read_label_map(folder / name, job);
    return narrow_labels(labels, (folder / name).string());
}

const TreeFileFacts in_case{.in_case = true};

VesselTree extracted_tree(const fs::path& folder, const CaseHeader& header) {
    if (!holds(folder, header, case_file::extracted)) return {};
    return read_tree_vtp(folder / case_file::extracted, in_case);
}

Json json_of(const std::vector<Rebuilding>& rebuilt) {
    Json list = Json::array();
    for (const auto& [after_edits, strokes] : rebuilt)
        list.push_back({{"after_edits", after_edits}, {"strokes", strokes}});
    return list;
}

std::vector<Rebuilding> rebuilt_from(const Json& corrections) {
    std::vector<Rebuilding> rebuilt;
    if (const auto list = corrections.find("rebuilt"); list != corrections.end())
        for (const Json& one : *list)
            rebuilt.push_back({whole_number<std::size_t>(one.at("after_edits")),
                               whole_number<std::size_t>(one.at("strokes"))});
    return rebuilt;
}

Json json_of_corrections(const fs::path& file) {
    return Json::parse(read_text_file(file, "Reconstruct the patient again"), nullptr, true);
}

// Earlier programs marked a refused gap instead of keeping an edit.
void read_marked_refusals(const Json& bridges, PatientCase& patient) {
    Corrections& corrections = patient.corrections;
    for (std::size_t i = 0; i < bridges.size(); ++i) {
        if (!bridges[i].value("refused", false) || corrections.bridges[i].built) continue;
        if (corrections.edits.empty()) corrections.extracted = patient.tree;
        corrections.edits.push_back(refusal_of(corrections.bridges[i]));
    }
}

void read_corrections(const fs::path& folder, const CaseHeader& header, PatientCase& patient) {
    Corrections& corrections = patient.corrections;
    corrections.extracted = extracted_tree(folder, header);
    const bool old = header.version == 1;
    const bool seeded = is_seeded_format_1(
        corrections.extracted.segments.empty() ? patient.tree : corrections.extracted);
    Json marked = Json::array();
    if (holds(folder, header, case_file::corrections)) {
        const fs::path file = folder / case_file::corrections;
        const Json json = json_of_corrections(file);
        const std::string edits = json.at("edits").dump();
        corrections.bridges = bridges_from_json(json.at("bridges").dump(), file.string());
        if (json.contains("branches"))
            std::ranges::move(bridges_from_json(json["branches"].dump(), file.string()),
                              std::back_inserter(corrections.bridges));
        corrections.edits =
            edits_from_json(old ? edits_of_format_1(edits, seeded) : edits, file.string());
        corrections.rebuilt = rebuilt_from(json);
        marked = json.at("bridges");
    }
    if (corrections.edits.empty() != corrections.extracted.segments.empty())
        refuse_case(folder, "holds edits without the tree that they were made on");
    if (old && !seeded) rename_systems_of_format_1(patient.tree);
    read_marked_refusals(marked, patient);
}

// A file that a case may lack; none where it does.
std::optional<std::string> text_beside(const fs::path& file) {
    if (std::error_code ignored; !fs::exists(file, ignored)) return std::nullopt;
    return read_text_file(file, "Make it readable, or remove it: the case is whole without it");
}

std::vector<KeptMeasurement> measured_in(const fs::path& folder) {
    const fs::path file = folder / case_file::measurements;
    const std::optional<std::string> text = text_beside(file);
    if (!text) return {};
    return measurements_from_json(*text, file.string());
}

void read_all_voxels(const fs::path& folder, const CaseHeader& header, PatientCase& patient) {
    patient.mask = read_voxels(folder, header, case_file::mask);
    patient.skeleton = read_voxels(folder, header, case_file::skeleton);
    for (Mask* voxels : {&patient.mask, &patient.skeleton})
        if (header.mask_grid && same_grid(voxels->grid, *header.mask_grid))
            voxels->grid = *header.mask_grid;
    patient.organs = read_voxels(folder, header, case_file::organs);
    patient.corrections.unpainted = read_voxels(folder, header, case_file::unpainted);
    patient.couinaud = read_voxels(folder, header, case_file::couinaud);
    if (header.version > 1) return;
    const VesselTree extracted = extracted_tree(folder, header);
    relabel_format_1(patient.mask, extracted.segments.empty()
                                       ? read_tree_vtp(folder / case_file::tree, in_case)
                                       : extracted);
}

void write_corrections(const fs::path& folder, const Corrections& corrections) {
    if (corrections.bridges.empty() && corrections.edits.empty() && corrections.rebuilt.empty())
        return;
    // Branches stand apart: earlier programs would take them for gaps.
    std::vector<Bridge> gaps, branches;
    for (const Bridge& bridge : corrections.bridges)
        (bridge.is_branch() ? branches : gaps).push_back(bridge);
    Json json{{"bridges", Json::parse(bridges_to_json(gaps))},
              {"edits", Json::parse(edits_to_json(corrections.edits))}};
    if (!branches.empty()) json["branches"] = Json::parse(bridges_to_json(branches));
    if (!corrections.rebuilt.empty()) json["rebuilt"] = json_of(corrections.rebuilt);
    write_text_atomically(folder / case_file::corrections, json.dump(1) + "\n");
    if (!corrections.edits.empty())
        write_tree_vtp(folder / case_file::extracted, corrections.extracted);
}

void write_voxels(const fs::path& file, const Mask& mask) {
    if (!mask.voxels.empty()) write_nifti(file, mask);
}

PatientCase read(const fs::path& folder, bool with_voxels) {
    PatientCase patient;
    const CaseHeader header = read_case_header(folder);
    patient.source = header.source;
    patient.doubts = header.doubts;
    patient.warnings = header.warnings;
    patient.warnings_of_image = header.warnings_of_image;
    for (const char* name : {case_file::tree, case_file::surface, case_file::mesh})
        check_case_file(folder, header, name);
    patient.tree = read_tree_vtp(folder / case_file::tree, in_case);
    try {
        read_corrections(folder, header, patient);
    } catch (const nlohmann::json::exception& error) {
        refuse_case(folder / case_file::corrections, json_problem(error));
    }
    if (with_voxels) read_all_voxels(folder, header, patient);
    patient.surface = read_vtp(folder / case_file::surface);
    patient.mesh = read_vtu(folder / case_file::mesh);
    patient.dial_json = text_beside(folder / case_file::dial).value_or("");
    patient.measured = measured_in(folder);
    return patient;
}

// What read_all_voxels() reads; none where it cannot be read, which is no reason to refuse a
// patient whose voxels nobody asks for.
std::shared_ptr<const KeptFiles> kept_voxels_of(const fs::path& folder) {
    using namespace case_file;
    std::vector<const char*> names{header, mask, skeleton, organs, unpainted, couinaud};
    try {
        if (read_case_header(folder).version == 1)  // its systems are those of the tree
            names.insert(names.end(), {tree, extracted});
        return std::make_shared<const KeptFiles>(folder, names);
    } catch (const InputError&) {
        return nullptr;
    }
}

// The header, if the case is still that of the patient. Throws InputError where it was replaced.
CaseHeader header_of_same(const fs::path& folder, const fs::path& place,
                          const PatientCase& patient) {
    CaseHeader header = read_case_header(folder);
    if (header.source.image_sha256 != patient.source.image_sha256 ||
        header.source.parameters_json != patient.source.parameters_json)
        throw InputError("holds another patient than when it was opened", place.string(),
                         "Put the case back that was there, or open this one anew");
    return header;
}

std::vector<TreeEdit> strokes_in(const fs::path& folder, const CaseHeader& header) {
    if (header.version == 1 || !holds(folder, header, case_file::corrections)) return {};
    const fs::path file = folder / case_file::corrections;
    try {
        const Json json = json_of_corrections(file);
        return tumour_strokes(edits_from_json(json.at("edits").dump(), file.string()));
    } catch (const nlohmann::json::exception& error) {
        refuse_case(file, json_problem(error));
    }
}

// The organs of a case on disk with the tumour strokes of the patient's own list: he may have been
// corrected since he was read, and the case may have been saved with others.
Mask organs_with_strokes(const fs::path& folder, const CaseHeader& header,
                         const PatientCase& patient) {
    const std::vector<TreeEdit> wanted = tumour_strokes(patient.corrections.edits);
    if (wanted == strokes_in(folder, header)) return read_voxels(folder, header, case_file::organs);
    PatientCase voxels;
    voxels.source = patient.source;
    read_all_voxels(folder, header, voxels);
    paint_tumours(voxels, wanted);
    return std::move(voxels.organs);
}

void write_dial_and_measurements(const fs::path& folder, const PatientCase& patient) {
    if (!patient.dial_json.empty())
        write_text_atomically(folder / case_file::dial, patient.dial_json);
    if (!patient.measured.empty())
        write_text_atomically(folder / case_file::measurements,
                              measurements_to_json(patient.measured));
}

// Asks the job between two files whether it is cancelled.
void write_files(const fs::path& folder, const PatientCase& patient, Job& job) {
    const std::vector<std::function<void()>> files{
        [&] { write_voxels(folder / case_file::mask, patient.mask); },
        [&] { write_voxels(folder / case_file::skeleton, patient.skeleton); },
        [&] { write_voxels(folder / case_file::organs, patient.organs); },
        [&] { write_voxels(folder / case_file::unpainted, patient.corrections.unpainted); },
        [&] { write_voxels(folder / case_file::couinaud, patient.couinaud); },
        [&] { write_tree_vtp(folder / case_file::tree, patient.tree); },
        [&] { write_tree_swc(folder / case_file::swc, patient.tree); },
        [&] { write_vtp(folder / case_file::surface, patient.surface); },
        [&] { write_vtu(folder / case_file::mesh, patient.mesh); },
        [&] { write_corrections(folder, patient.corrections); },
        [&] { write_dial_and_measurements(folder, patient); },
        [&] { write_case_header(folder, patient); }};
    for (std::size_t i = 0; i < files.size(); ++i) {
        files[i]();
        job.advance(static_cast<double>(i + 1) / static_cast<double>(files.size()));
    }
}

// The older case is removed as soon as this one stands in its place, and after a power cut there
// would be neither.
void flush_files(const fs::path& folder, const fs::path& place) {
    for (const fs::directory_entry& file : fs::directory_iterator(folder))
        flush_to_disk(file.path(), place);
}

// Takes over what an archive holds besides the files of the case, as many as an archive may hold.
void keep_foreign_files(const fs::path& archive, const PatientCase& patient,
                        const fs::path& folder) {
    if (!is_case_archive(archive)) return;
    const TemporaryFolder before;
    try {
        unpack_case(archive, before.path());
    } catch (const InputError&) {
        return;  // nothing can be read of what is replaced
    }
    if (!is_case_of(before.path(), patient)) return;
    std::vector<fs::path> foreign;
    for (const fs::directory_entry& entry : fs::directory_iterator(before.path()))
        if (!is_of_a_case(entry.path().filename())) foreign.push_back(entry.path());
    std::ranges::sort(foreign);
    foreign.resize(std::min(foreign.size(), most_files_of_archive - case_file::all.size()));
    for (const fs::path& file : foreign) fs::copy_file(file, folder / file.filename());
}

}  // namespace

bool is_case(const fs::path& path) {
    std::error_code unreadable;  // then it is no case
    return fs::is_regular_file(path / case_file::header, unreadable) || is_case_archive(path);
}

bool is_of_a_case(const fs::path& file) {
    return std::ranges::find(case_file::all, file.string()) != case_file::all.end();
}

bool is_replaceable_case(const fs::path& place) {
    return is_case_archive(place) ? archive_holds(place, case_file::header) : is_case(place);
}

bool is_case_of(const fs::path& place, const PatientCase& patient) {
    try {
        return in_folder(place, [&](const fs::path& folder) {
            const std::string& image = patient.source.image_sha256;
            if (read_case_header(folder).source.image_sha256 != image) return false;
            if (!image.empty()) return true;
            return hash_of_extracted(read_case(folder)) == hash_of_extracted(patient);
        });
    } catch (const InputError&) {
        return false;
    }
}

void require_place_of_case(const fs::path& place) {
    if (!fs::exists(place) || is_replaceable_case(place)) return;
    if (is_archive_name(place)) require_no_folder_at(place);
    throw InputError("is there already and is not a patient's case", place.string(),
                     "Give --out another name; only an older case is replaced");
}

void write_case(const fs::path& place, const PatientCase& patient) {
    Job unwatched;
    write_case_in_job(place, patient, unwatched);
}

void write_case_in_job(const fs::path& place, const PatientCase& patient, Job& job) {
    require_place_of_case(place);
    if (!is_archive_name(place) || fs::is_directory(place))
        return renew_folder_atomically(
            place,
            [&](const fs::path& temporary) {
                write_files(temporary, patient, job);
                flush_files(temporary, place);
            },
            is_of_a_case);
    const TemporaryFolder folder;
    write_files(folder.path(), patient, job);
    keep_foreign_files(place, patient, folder.path());
    pack_case(folder.path(), place);
}

void add_voxels(const fs::path& place, PatientCase& patient) {
    in_folder(place, [&](const fs::path& folder) {
        read_all_voxels(folder, header_of_same(folder, place, patient), patient);
    });
    patient.voxels_at.clear();
}

void add_kept_voxels(PatientCase& patient) {
    const TemporaryFolder files;
    patient.kept_voxels->write_to(files.path());
    in_place_of(files.path(), patient.voxels_at, [&](const fs::path& folder) {
        read_all_voxels(folder, header_of_same(folder, patient.voxels_at, patient), patient);
    });
    patient.voxels_at.clear();
    patient.kept_voxels.reset();
}

Mask organs_of(const PatientCase& patient) {
    if (!patient.organs.voxels.empty() || patient.voxels_at.empty()) return patient.organs;
    return in_folder(patient.voxels_at, [&](const fs::path& folder) {
        const CaseHeader header = header_of_same(folder, patient.voxels_at, patient);
        return organs_with_strokes(folder, header, patient);
    });
}

// A folder that is gone is not made anew: with a dial alone it would be no case, and none could be
// saved there.
void write_dial(const fs::path& place, const std::string& dial_json) {
    in_folder(place, [&](const fs::path& folder) {
        if (!is_case(folder))
            throw InputError("is not a patient's case: it holds no case.json", folder.string(),
                             "Check the path: a case is a folder NAME.hep or one file NAME.hepz");
        write_text_atomically(folder / case_file::dial, dial_json);
        if (folder != place) pack_case(folder, place);
    });
}

PatientCase read_case(const fs::path& place) {
    return in_folder(place, [](const fs::path& folder) { return read(folder, true); });
}

PatientCase read_case_without_voxels(const fs::path& place) {
    PatientCase patient = in_folder(place, [](const fs::path& folder) {
        PatientCase lean = read(folder, false);
        lean.kept_voxels = kept_voxels_of(folder);
        return lean;
    });
    patient.voxels_at = place;
    return patient;
}

}  // namespace hepatica
