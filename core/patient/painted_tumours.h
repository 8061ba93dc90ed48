// SPDX-License-Identifier: GPL-3.0-or-later
// Tumours of a patient: those that masks brought along at the reconstruction, as strokes of a brush
// have painted and erased them since. They are voxels of the organs and nothing of the vessels, so
// that no vessel has to be made anew.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/image/brush.h"
#include "core/patient/patient_case.h"

namespace hepatica {

struct Tumour {
    int number = 0;  // from 1, for good: label organ_label::first_tumour + number - 1
    double volume_ml = 0.0;
    Vec3 middle_mm = Vec3::Zero();  // the mean of its voxels
};

// By their numbers.
std::vector<Tumour> tumours_in(const Mask& organs);
// The numbers of tumours by voxel, and 0 elsewhere.
Mask tumour_voxels(const Mask& organs);
// "1, 3" of tumours 1 and 3, for messages; "none".
std::string numbers_of(const std::vector<Tumour>& tumours);
// The number of the tumour that a voxel of organs belongs to (0: none), and back.
int tumour_of(std::uint8_t label);
std::uint8_t label_of_tumour(int number);
// A number for one more, above those that are there, or else free between them; 0 where there are
// most_tumours.
int number_for_new(const std::vector<Tumour>& tumours);

// A stroke as a correction, and back.
TreeEdit tumour_edit(const BrushStroke& stroke, int tumour);
BrushStroke stroke_of(const TreeEdit& edit);
// Those of the edits that are strokes at tumours, in order, and the others.
std::vector<TreeEdit> tumour_strokes(const std::vector<TreeEdit>& edits);
std::vector<TreeEdit> tree_edits(const std::vector<TreeEdit>& edits);

// Whether the patient may have a tumour, as far as can be told without his voxels.
bool may_hold_tumours(const PatientCase& patient);

// The organs as they were before anybody painted; empty where there were none.
Mask unpainted_organs(const PatientCase& patient);
// The same with room for tumours that stick out of the liver, 30 mm where the CT goes on so far; on
// the grid of the vessels' voxels where there were none. Empty where the patient has no voxels.
Mask tumour_canvas(const PatientCase& patient);

// One stroke over organs that began as `canvas`. Painting gives to its tumour what is neither of
// another tumour nor of the vena cava: a tumour may enclose vessels and stick out of the liver.
// What is erased is again what it was before, or else liver. Returns how often a voxel changed.
std::size_t paint_tumour(const TreeEdit& stroke, const Mask& canvas, Mask& organs);

// Makes the organs anew as the strokes among these edits leave them, and keeps those from before;
// nothing where the patient has no voxels. The place of the first stroke that changed no voxel.
std::optional<std::size_t> paint_tumours(PatientCase& patient, const std::vector<TreeEdit>& edits);

// Exchanges the strokes among the patient's corrections for those of `edits`, which are else his
// own.
void set_tumour_strokes(PatientCase& patient, const std::vector<TreeEdit>& edits);

}  // namespace hepatica
