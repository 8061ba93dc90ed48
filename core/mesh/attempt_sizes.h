// SPDX-License-Identifier: GPL-3.0-or-later
// The element sizes of one attempt at meshing a body, and the factor by which its tubes are widened
// at these sizes so that the mesh has their volume.
#pragma once

namespace hepatica {

inline constexpr double finest_in_radii = 0.3;
// Above it cross-sections become triangles and tubes break.
inline constexpr double coarsest_in_radii = 1.0;

struct AttemptSizes {
    double facet_in_radii;  // largest circumradius of surface triangles, in local radii
    double cell_in_radii;   // the same of tetrahedra
    double radius_factor;   // of every radius
};

// The sizes times `scale`, which is 1 for the first attempt and less, down to 0.8, for later ones.
// Where that would be finer than the finest, later attempts become coarser instead, so that each
// makes another mesh. All sizes lie between the finest and the coarsest, as those that are asked
// for must.
AttemptSizes attempt_sizes(double facet_in_radii, double cell_in_radii, double scale);

}  // namespace hepatica
