// SPDX-License-Identifier: GPL-3.0-or-later
// Correcting a case: gaps that the reconstruction offers to bridge, and edits by hand. Edits are
// kept with the case as commands on the tree as it was extracted, so that any of them can be
// undone; the body always belongs to the tree.
#pragma once

#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/mesh/tetrahedralize.h"
#include "core/patient/patient_case.h"

namespace hepatica {

enum class BridgeState {
    open,      // offered, to be decided
    built,     // by the reconstruction
    accepted,  // built by an edit
    refused,   // by somebody; a built one by a cut
    needless,  // other vessels join its two ends already, or one is gone
};

// For files and the command line: open, built, accepted, refused or needless.
std::string name_of(BridgeState state);
// Of corrections.bridges[index].
BridgeState state_of_bridge(const PatientCase& patient, std::size_t index);

// The bridges that are still to be decided, best first.
std::vector<Bridge> open_bridges(const PatientCase& patient);

// The edit that builds a bridge.
TreeEdit acceptance_of(const Bridge& bridge);

// The edit that takes one away that the reconstruction built: a cut in its middle.
TreeEdit refusal_of(const Bridge& bridge);

// The edits that build all open bridges of this confidence or more, best first. A bridge that
// another one made needless is left out.
std::vector<TreeEdit> acceptances(const PatientCase& patient, double confidence);

// What the body was made with, as `source.parameters_json` says.
MeshOptions mesh_options_of(const PatientCase& patient);

// The case with another list of edits, but with the body it had: for looking ahead. Throws as
// with_edits() does.
PatientCase with_edited_tree(const PatientCase& patient, const std::vector<TreeEdit>& edits);

// The case with these edits, and no others, made on the tree as it was extracted; mesh and surface
// are made anew, as `source.parameters_json` says, unless only strokes at tumours differ. Where
// `patient` holds voxels his organs are as the strokes leave them, and the liver's segments are
// made anew. An unchanged list changes nothing. Throws InputError that names the edit which cannot
// be done (a stroke that touches nothing is one, too), or where nothing of the tree is left;
// Cancelled. `patient` itself stays as it is.
PatientCase with_edits(const PatientCase& patient, const std::vector<TreeEdit>& edits, Job& job);

// Says of a patient who was made anew from other voxels that his vessels were rebuilt, with so many
// strokes, after what had been done to him before.
void note_rebuilding(const PatientCase& before, std::size_t strokes, PatientCase& after);

}  // namespace hepatica
