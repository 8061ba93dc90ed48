// SPDX-License-Identifier: GPL-3.0-or-later
// Leads places of the patient at rest along with the deformed body: each moves as the nearest of
// the body's vertices does. No widgets.
#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "core/patient/patient_case.h"
#include "core/scene/frame.h"

namespace hepatica {

// The vertices at rest that the frame holds the positions of: the body's, or, in a scene without
// deformation, the surface's.
const std::vector<Vec3>& rest_vertices(const PatientCase& patient, const Frame& frame);

// Index of the nearest vertex within `reach_mm`; -1: there is none.
int nearest_vertex(const std::vector<Vec3>& vertices_mm, const Vec3& point_mm,
                   double reach_mm = std::numeric_limits<double>::infinity());

// By how much that vertex lies elsewhere in the frame; zero for one that there is not.
Vec3 displacement_mm(int vertex, const std::vector<Vec3>& rest_mm, const Frame& frame);

}  // namespace hepatica
