// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces of a body that were meshed separately may overlap at rest. Overlaps are left out of
// contact until they have separated, which happens gently since nothing pushes them, and count from
// then on:
//   a pair of patches of two pieces whose triangles cross or nearly touch, until all of them are
//   farther from each other than a reach;
//   a patch with a vertex inside another piece, with all patches of that piece, until none is.
// A point is inside where rays from it cross the surface outwards more often than inwards. A piece
// does not overlap itself, because its surface bounds tetrahedra that share faces. Beside obstacles
// only moving patches may lie in fixed pieces. A shell is meant to contain the body: a patch with a
// vertex outside is left out with all of the shell for good, because it passes through the shell's
// wall or does not belong inside.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "core/contact/surface_features.h"

namespace hepatica {

struct OverlapsBefore;

// Not thread-safe.
class Overlaps {
  public:
    // Patches a < b, or a patch and a piece; ascending.
    using Pairs = std::vector<std::array<int, 2>>;

    // Keeps a reference.
    explicit Overlaps(const SurfaceFeatures& features) : features_(features) {}

    // Finds all overlaps at these positions, counting triangles nearer than touch_mm, and adds what
    // `at_rest` has left out for good.
    void find(std::span<const Vec3> positions_mm, double touch_mm,
              const Overlaps* at_rest = nullptr);

    // Lets separated pairs count again; true where anything changed. A patch that came out of a
    // piece is still left out with patches near it, one that slipped into a piece with all of
    // it.
    bool let_go(std::span<const Vec3> positions_mm, double reach_mm);

    // The overlaps after a tear, from those before it. `node_before` is the former node of each
    // vertex. Pairs that counted before still count, however near they are. Left out are
    //   what was left out before, where it is nearer than reach_mm or lies in the other piece;
    //   faces that the tear has exposed, where they cross or lie in pieces that were separate
    //   before; of pieces torn from each other the patches in `parted`, pairs in ascending order,
    //   or, without them, those nearer than reach_mm that have vertices split from one another.
    void follow_split(const OverlapsBefore& before, std::span<const int> node_before,
                      std::span<const Vec3> positions_mm, double reach_mm,
                      const Pairs* parted = nullptr);

    // Whether a pair of patches does not count.
    bool left_out(int patch, int other) const;
    bool any() const { return !touching_.empty() || !buried_.empty(); }

    // For checkpoints: pairs of patches, and pairs of a patch and the piece that it lies in. set()
    // takes such pairs; false where they do not fit this surface.
    const Pairs& touching() const { return touching_; }
    const Pairs& buried() const { return buried_; }
    bool set(const Pairs& touching, const Pairs& buried);

  private:
    bool may_lie_in(int patch, int piece) const;
    bool for_good(int piece) const { return features_.kind_of_piece(piece) == SurfaceKind::shell; }
    bool slipped_in(const std::array<int, 2>& touching, std::span<const Box> boxes,
                    std::span<const Vec3> positions_mm, Pairs& buried) const;
    bool nearer_than(double gap_mm, int patch, int other, std::span<const Vec3> positions_mm) const;
    bool within(const Vec3& point, int piece, std::span<const Box> boxes,
                std::span<const Vec3> positions_mm) const;
    bool lies_in(int patch, int piece, std::span<const Box> boxes,
                 std::span<const Vec3> positions_mm) const;

    const SurfaceFeatures& features_;
    Pairs touching_, buried_;
    // The witness that last showed a pair to overlap (two near triangles, or a vertex inside); it
    // is tried first the next time.
    mutable std::map<std::array<int, 2>, std::array<int, 2>> near_;
    mutable std::map<std::array<int, 2>, int> within_;
};

// The overlaps of the surface before a split, with its features.
struct OverlapsBefore {
    SurfaceFeatures features;
    Overlaps::Pairs touching, buried;
};

}  // namespace hepatica
