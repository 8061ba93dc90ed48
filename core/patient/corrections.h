// SPDX-License-Identifier: GPL-3.0-or-later
// Corrections of a case: gaps that the reconstruction offers to bridge, branches that may be
// vessels, and edits by hand. Edits are kept with the case as commands on the extracted tree, so
// that any of them can be undone; the body always matches the tree.
#pragma once

#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/mesh/tetrahedralize.h"
#include "core/patient/patient_case.h"

namespace hepatica {

enum class BridgeState {
    open,      // offered, undecided; a branch leads out of the tree
    built,     // by the reconstruction
    accepted,  // built by an edit
    refused,   // by an edit; a built bridge by a cut
    needless,  // its ends are joined already, or one of them is gone; a branch hangs on no vessel,
               // or lies in one
};

// Name for files and the command line: open, built, accepted, refused or needless.
std::string name_of(BridgeState state);
// State of corrections.bridges[index].
BridgeState state_of_bridge(const PatientCase& patient, std::size_t index);

// The undecided bridges, best first; and those of them that are gaps, which are few enough for
// every picture.
std::vector<Bridge> open_bridges(const PatientCase& patient);
std::vector<Bridge> open_gaps(const PatientCase& patient);

// The edit that builds a bridge, or draws a branch.
TreeEdit acceptance_of(const Bridge& bridge);

// Whether the edit builds or draws this one.
bool accepts(const TreeEdit& edit, const Bridge& bridge);

// The edit that refuses a bridge. One that the reconstruction built is removed by a cut in its
// middle; any other is offered no more.
TreeEdit refusal_of(const Bridge& bridge);
// Whether the edit refuses this bridge. Other voxels may move the ends of an offered gap by a
// little (3 mm), and turn it round, without making another of it.
bool refuses(const TreeEdit& edit, const Bridge& bridge);

// The edits that build all open bridges of this confidence or more, best first, without those that
// earlier ones make needless; and branches that hang on others of these. Reports the share that is
// looked at. Throws Cancelled.
std::vector<TreeEdit> acceptances(const PatientCase& patient, double confidence, Job& job);

// Likewise of the case with these edits. Throws as with_edits() does.
std::vector<TreeEdit> acceptances_after(const PatientCase& patient,
                                        const std::vector<TreeEdit>& edits, double confidence,
                                        Job& job);

// Options of the body's mesh, from `source.parameters_json`. Missing ones take their defaults.
// Throws InputError where one is of another type.
MeshOptions mesh_options_of(const PatientCase& patient);

// The case with another list of edits but its old body, for previews. Throws as with_edits() does.
PatientCase with_edited_tree(const PatientCase& patient, const std::vector<TreeEdit>& edits);

// What is doubtful about the links by hand among the edits (doubtful_link.h), each against the tree
// that it was made on. Not of a link that joins its two ends no more, because it was cut or one of
// them was deleted. One sentence stands once.
std::vector<std::string> doubts_of_links(const PatientCase& patient);

// The case with exactly these edits applied to the extracted tree. Mesh and surface are made anew
// as `source.parameters_json` says, unless only tumour strokes differ. Where `patient` holds
// voxels, its organs follow the strokes and the liver's segments are made anew. An unchanged list
// changes nothing. `patient` itself stays as it is. A body whose surface meets itself is warned of
// in `warnings` of the result, and no longer where the new one does not. Begins two stages. Throws
// InputError that names an edit which is not possible (including a stroke that changes nothing), or
// where nothing of the tree is left; Cancelled.
PatientCase with_edits(const PatientCase& patient, const std::vector<TreeEdit>& edits, Job& job);

// Puts what tetrahedralize() warned of a new mesh in the place of what was said of the old one.
void replace_warnings_of_mesh(const std::vector<std::string>& of_mesh, PatientCase& patient);

// The rebuildings of a case among another list of its edits: what is added, or made again, once a
// body without those that were taken back is there comes after the rebuildings.
std::vector<Rebuilding> rebuildings_among(const std::vector<TreeEdit>& edits,
                                          const Corrections& corrections);

// Records in `after` that the vessels were rebuilt from other voxels, with this number of strokes,
// after the rebuildings of `before`.
void note_rebuilding(const PatientCase& before, std::size_t strokes, PatientCase& after);

}  // namespace hepatica
