// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces of a body that were meshed apart may overlap at rest. What does is left out of contact
// until it has come apart, gently, since nothing pushes it, and counts from then on:
//   a pair of patches of two pieces whose triangles cross or nearly touch, until all of them are
//   farther from each other than a reach;
//   a patch that has a vertex within another piece, with all patches of that piece, until none is.
// Within is where rays meet the surface more often from behind than from before. One piece does not
// overlap itself: its surface bounds tetrahedra that share faces. Beside obstacles only what moves
// may lie in what stands still. In a shell, which is to hold it, it lies where a vertex is outside,
// and what lies so is left out for good: it goes through the shell's wall, or has no business in
// it.
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

    // All that overlaps at these positions, where triangles nearer than touch_mm do, too; and what
    // `at_rest` has left out for good.
    void find(std::span<const Vec3> positions_mm, double touch_mm,
              const Overlaps* at_rest = nullptr);

    // Lets go what has come apart; true where something has. Nothing begins to overlap by it.
    bool let_go(std::span<const Vec3> positions_mm, double reach_mm);

    // After a tear, from what overlapped before it on. `node_before` is that of each vertex. What
    // counted goes on to count, however near it is; left out are, where they are nearer than
    // reach_mm or one lies in the other,
    //   what was left out before;
    //   faces that the tear has laid bare, and pieces that overlapped before;
    //   patches of pieces torn from each other that touch at rest, as `at_rest` has it; without
    //   it, those that have vertices split from one another.
    void follow_split(const OverlapsBefore& before, std::span<const int> node_before,
                      std::span<const Vec3> positions_mm, double reach_mm,
                      const Overlaps* at_rest = nullptr);

    // Whether a pair of patches does not count.
    bool left_out(int patch, int other) const;
    bool any() const { return !touching_.empty() || !buried_.empty(); }

    // What a checkpoint keeps: pairs of patches, and of a patch and the piece that it lies in.
    // set() takes what they gave; false where it cannot be of this surface.
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
    // The witness that last showed a pair of patches to overlap (two near triangles, or a vertex
    // inside); it is tried first the next time.
    mutable std::map<std::array<int, 2>, std::array<int, 2>> near_;
    mutable std::map<std::array<int, 2>, int> within_;
};

// The overlaps of the surface before a split, with its features.
struct OverlapsBefore {
    SurfaceFeatures features;
    Overlaps::Pairs touching, buried;
};

}  // namespace hepatica
