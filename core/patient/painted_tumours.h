// SPDX-License-Identifier: GPL-3.0-or-later
// Tumours of a patient: those of masks given at the reconstruction, with the strokes of a brush
// that painted and erased tumours since. They are voxels of the organs, not of the vessels, so that
// no vessel has to be made anew.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/image/brush.h"
#include "core/patient/patient_case.h"

namespace hepatica {

struct Tumour {
    int number = 0;  // permanent, from 1: label organ_label::first_tumour + number - 1
    double volume_ml = 0.0;
    Vec3 middle_mm = Vec3::Zero();  // mean of its voxels
};

// The tumours, ordered by number.
std::vector<Tumour> tumours_in(const Mask& organs);
// The tumour number of each voxel; 0 elsewhere.
Mask tumour_voxels(const Mask& organs);
// The numbers for messages, as in "1, 3"; "none" where there are none.
std::string numbers_of(const std::vector<Tumour>& tumours);
// The tumour number of a label of organs (0: none), and the label of a number.
int tumour_of(std::uint8_t label);
std::uint8_t label_of_tumour(int number);
// A free number for a new tumour: above the highest, else the lowest free one; 0 where there are
// most_tumours already.
int number_for_new(const std::vector<Tumour>& tumours);

// A stroke as an edit, and back.
TreeEdit tumour_edit(const BrushStroke& stroke, int tumour);
BrushStroke stroke_of(const TreeEdit& edit);
// The edits that are tumour strokes, in order, and those that change the tree.
std::vector<TreeEdit> tumour_strokes(const std::vector<TreeEdit>& edits);
std::vector<TreeEdit> tree_edits(const std::vector<TreeEdit>& edits);

// Whether the patient may have a tumour; a guess where its voxels are not in memory.
bool may_hold_tumours(const PatientCase& patient);

// The organs before any stroke; empty where there were none.
Mask unpainted_organs(const PatientCase& patient);
// The same with a margin of 30 mm within the CT for tumours that stick out of the liver. Without
// organs, an empty map on the grid of the vessels' voxels. Empty where the patient has no voxels.
Mask tumour_canvas(const PatientCase& patient);

// Whether the ball of a stroke leaves this grid, outside of which nothing is painted.
bool reaches_beyond(const BrushStroke& stroke, const Grid& canvas);

// Applies one stroke to organs that began as `canvas`. Painting labels all voxels but those of
// other tumours and of the vena cava: a tumour may enclose vessels and stick out of the liver.
// Erased voxels get back their label in `canvas`, or liver where that was a tumour. Returns the
// number of changed voxels.
std::size_t paint_tumour(const TreeEdit& stroke, const Mask& canvas, Mask& organs);

// Applies the strokes among these edits to the unpainted organs, which are kept; does nothing where
// the patient has no voxels. Returns the index of the first stroke that changed no voxel.
std::optional<std::size_t> paint_tumours(PatientCase& patient, const std::vector<TreeEdit>& edits);

// Replaces the patient's edits by `edits`, which may differ in tumour strokes only, and paints
// them.
void set_tumour_strokes(PatientCase& patient, const std::vector<TreeEdit>& edits);

}  // namespace hepatica
