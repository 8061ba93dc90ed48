// SPDX-License-Identifier: GPL-3.0-or-later
// One patient on disk: NAME.hep, a folder of open formats, or NAME.hepz, the same in one file
// (case_archive.h), which is unpacked to temporary files whenever it is read.
//   case.json (version, digest of the CT, parameters, the tree in numbers, SHA-256 of the rest),
//   mask.nii.gz (numbers of systems), skeleton.nii.gz, organs.nii.gz, couinaud.nii.gz, tree.vtp,
//   tree.swc, surface.vtp, mesh.vtu; after corrections also corrections.json (bridges offered,
//   edits), tree_extracted.vtp (the tree before the edits) and, after tumours were painted,
//   organs_unpainted.nii.gz (the organs before that); dial.json, if the dial was measured;
//   measurements.json, if something was measured by hand
// The CT is not copied, and no path of it or of a mask is kept, because folders are often named
// after the patient. This is format 2, or 3 where tumours were painted; format 1 is read, too
// (format_1.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/image/volume.h"
#include "core/mesh/tet_mesh.h"
#include "core/patient/doubts.h"
#include "core/patient/measurement.h"
#include "core/tree/editing/tree_edit.h"
#include "core/tree/extraction/gap_bridging.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

class Job;        // core/base/job.h
class KeptFiles;  // core/patient/kept_files.h

// Where a case came from and how it was made.
struct CaseSource {
    std::string name;                    // name chosen by the user; may be empty
    std::string image_sha256;            // digest of the CT (image_digest.h); empty: not known
    Grid image_grid;                     // geometry of the CT
    std::string parameters_json = "{}";  // options of the reconstruction, one JSON object
};

// A rebuilding of the vessels from painted voxels: the number of edits before it, and its number of
// brush strokes, 0 where they were not counted.
struct Rebuilding {
    std::size_t after_edits = 0, strokes = 0;
    bool operator==(const Rebuilding&) const = default;
};

// Possible and applied corrections; see corrections.h.
struct Corrections {
    std::vector<Bridge> bridges;  // gaps found: bridged by the reconstruction, or only offered
    std::vector<TreeEdit> edits;  // in order; they turn `extracted` into `tree`
    VesselTree extracted;         // the tree before the first edit; empty without edits
    // The organs before the first tumour stroke (painted_tumours.h), all 0 where there were none;
    // empty without strokes and where the patient was read without voxels.
    Mask unpainted;
    std::vector<Rebuilding> rebuilt;  // oldest first; for information: their voxels are in the mask
};

// Labels of organs.nii.gz.
namespace organ_label {
inline constexpr std::uint8_t liver = 1;
inline constexpr std::uint8_t cava = 2;
inline constexpr std::uint8_t first_tumour = 10;  // one label for each tumour, from here on
}  // namespace organ_label

struct PatientCase {
    CaseSource source;
    Mask mask;      // numbers of vascular systems, on the grid of the segmentation; may be empty
    Mask skeleton;  // its unit-width skeleton, on the same grid; may be empty
    Mask organs;    // organ_label, on a grid of its own; may be empty
    // Couinaud's segments 1 to 8 of the liver, on the grid of `organs`, from the portal vein of
    // `tree`; empty where either is missing. See liver_segments.h.
    Mask couinaud;
    VesselTree tree;
    TriangleMesh surface;  // boundary of `mesh`
    TetMesh mesh;
    Corrections corrections;
    // Of the reconstruction, before any correction; none in cases of older programs.
    std::optional<Doubts> doubts;
    // What the reconstruction warned of besides the doubts, in core's English sentences, with what
    // was said of the present mesh where the tree was corrected since; the first
    // `warnings_of_image` of them are of the image and hold for other vessels, too. Empty in cases
    // of older programs. Written to case.json without the names that they quote.
    std::vector<std::string> warnings;
    std::size_t warnings_of_image = 0;
    // The quality dial measured on this mesh, one JSON object (core/scene/measured_dial.h); empty
    // where it was not measured. Kept in dial.json, which may be removed.
    std::string dial_json;
    // What a person measured, kept in measurements.json, which may be removed.
    std::vector<KeptMeasurement> measured;
    // The case that holds the voxels, where the patient was read without them; else empty. Not
    // stored.
    std::filesystem::path voxels_at;
    // The files of those voxels as they were when he was read; null where he has them, and where
    // they could not be read. Not stored.
    std::shared_ptr<const KeptFiles> kept_voxels;
};

// Whether this is a folder with a case.json or an existing file NAME.hepz; it may be unreadable.
bool is_case(const std::filesystem::path& path);

// Whether write_case() would replace this: a folder or archive that holds a case.json.
bool is_replaceable_case(const std::filesystem::path& place);

// Whether a path relative to a case's folder is that of a file of a case.
bool is_of_a_case(const std::filesystem::path& file);

// Whether a case at this place is of the same patient: of the same CT or, where none is known, of
// the same vessels before any correction. False where this program cannot read it.
bool is_case_of(const std::filesystem::path& place, const PatientCase& patient);

// Throws InputError where write_case() would refuse the place for what is there: a file, or a
// folder that holds no case, even an empty one. To be called before long work.
void require_place_of_case(const std::filesystem::path& place);

// Writes the case atomically, as one file where the place is named NAME.hepz, and replaces an older
// case there. Other files in its folder stay; those in its archive, such as lessons, stay where it
// is of the same CT. Throws InputError where the place holds something else, cannot be written, or
// the disk is full.
void write_case(const std::filesystem::path& place, const PatientCase& patient);
// The same, with progress within the job's present stage. Throws Cancelled between two files; the
// place is then as it was.
void write_case_in_job(const std::filesystem::path& place, const PatientCase& patient, Job& job);

// Reads and checks a case of this format or an older one. Throws InputError with the reason where
// the version is unknown, a file is missing, or a digest differs from that in case.json.
PatientCase read_case(const std::filesystem::path& place);

// The same without the voxels (mask, skeleton, organs and couinaud stay empty), which the
// simulation does not need.
PatientCase read_case_without_voxels(const std::filesystem::path& place);

// Reads a case's voxels into a patient that was read without them. Throws InputError as above, and
// where the place holds a case of another CT or other parameters; only `source` is compared.
void add_voxels(const std::filesystem::path& place, PatientCase& patient);

// The same from `kept_voxels`, which must be there: whatever became of the case on disk. Throws
// InputError where the files are damaged, or there is no room for temporary ones.
void add_kept_voxels(PatientCase& patient);

// The labels of organs: the patient's own, or those on disk of the case it was read from; empty
// where there are none. Throws InputError as above.
Mask organs_of(const PatientCase& patient);

// Stores a measured dial in an existing case and changes nothing else. Throws InputError where it
// cannot be written.
void write_dial(const std::filesystem::path& place, const std::string& dial_json);

// Hash of what the simulation reads (tree and mesh), by which a recording names its case.
std::uint64_t hash_of(const PatientCase& patient);

// Hash of the extracted tree, which no correction changes: where it is the same, the same
// corrections can be applied again.
std::uint64_t hash_of_extracted(const PatientCase& patient);

}  // namespace hepatica
