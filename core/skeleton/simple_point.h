// SPDX-License-Identifier: GPL-3.0-or-later
// Simple points of a digital object, with object 26-connected and background 6-connected: voxels
// whose removal changes no component, tunnel or cavity (Bertrand and Malandain 1994).
// Neighbourhoods are 27 bits as PaddedObject::neighbourhood() gives them; the centre's bit is
// ignored.
#pragma once

#include <bit>
#include <cstdint>

#include "core/skeleton/padded_object.h"

namespace hepatica {

// True if the object voxels among the 26 neighbours form exactly one 26-component, and the
// background voxels among the 18 nearest neighbours exactly one 6-component that shares a face with
// the centre.
bool is_simple(std::uint32_t neighbourhood);

// Number of object voxels among the 26 neighbours: the degree (valence) of a skeleton voxel.
inline int degree(std::uint32_t neighbourhood) {
    return std::popcount(neighbourhood & ~centre_bit);
}

// The end of a line: one neighbour.
inline bool is_line_end(std::uint32_t neighbourhood) {
    return degree(neighbourhood) == 1;
}

// Removable without changing the topology or shortening a line.
inline bool is_deletable(std::uint32_t neighbourhood) {
    return !is_line_end(neighbourhood) && is_simple(neighbourhood);
}

}  // namespace hepatica
