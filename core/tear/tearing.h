// SPDX-License-Identifier: GPL-3.0-or-later
// How a body tears, step by step: joints whose load reaches their limit part and are bound by a
// softening traction until they have come apart; no more joints part once the entropy that the tear
// has produced, or the number of its vertices, reaches its budget.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/tear/tear_law.h"
#include "core/tear/tear_state.h"
#include "core/tear/torn_topology.h"

namespace hepatica {

// A body after a step. The first two spans have one entry per tetrahedron, the last two one per
// vertex.
struct TearLoads {
    std::span<const Mat3> stress_pa;  // first Piola-Kirchhoff
    std::span<const double> energy_nj;
    std::span<const Vec3> positions_mm;
    std::span<const double> mass_g;
};

// A parted joint, and which of its corners have come apart.
struct OpenJoint {
    int joint = -1;
    std::array<bool, 3> corners{};
};

// Not thread-safe; loops inside give the same bits for any number of threads.
class Tearing {
  public:
    // `strength_factor` multiplies each tetrahedron's strength; empty: 1. Throws InputError for a
    // law out of range.
    Tearing(const TetMesh& mesh, const TearLaw& law, std::span<const double> strength_factor);

    const TornTopology& topology() const { return topology_; }
    const TearLaw& law() const { return law_; }

    // Multiplies the limit of these joints by factor >= 0, unless they have parted. Throws
    // InputError for another factor or a joint that does not exist.
    void weaken(std::span<const int> joints, double factor);

    // The joints that were weakened but have not parted, ascending.
    std::vector<int> weakened() const;

    // The joints that hold, be it by ties alone, and whose two tetrahedra lie on different sides of
    // a parallelogram, given by a corner and two edges, that the line between their centres
    // crosses.
    std::vector<int> crossing(const Vec3& corner_mm, const Vec3& first_edge_mm,
                              const Vec3& second_edge_mm, std::span<const Vec3> positions_mm) const;
    // Parts these joints at once, without ties; those that parted before lose theirs, and with them
    // the energy that these hold.
    void cut(std::span<const int> joints);

    // Parts overloaded joints, the most loaded first, at most `most_joints` per step not counting
    // their neighbours. True where topology or ties changed.
    bool part_overloaded(const TearLoads& loads);
    static constexpr int most_joints = 256;

    // Measures the entropy after a step and applies the stop criterion.
    void measure(const TearLoads& loads);

    // Load over limit of each joint, 0 where it has parted; joints tear at 1. Loads below `least`
    // may be given as 0, which costs a fraction.
    void find_loads(const TearLoads& loads, double least, std::vector<double>& load);

    // Load over limit of each joint after the last step, 0 where it has parted; exact from
    // `warning_load` on, smaller loads may be given as 0. Empty where no joint reaches that, and
    // where none was computed: before the first step, and once the tear has stopped.
    std::span<const double> loads() const {
        return warns_ ? std::span<const double>(load_) : std::span<const double>();
    }
    static constexpr double warning_load = 0.5;

    // The ties of the parted joints. The caller keeps them while it makes steps, and returns their
    // largest openings in the same order before any other call.
    const std::vector<SofteningTie>& ties() const { return ties_; }
    void take_openings(std::span<const SofteningTie> ties);
    // Pairs of vertices that were one before a joint between them parted, whether still bound or
    // not, ascending.
    std::vector<std::array<int, 2>> parted_pairs() const;

    // The pairs of vertices that ties still hold together.
    std::vector<std::array<int, 2>> bound_pairs() const;

    // The joints of which a corner has come apart, so that no tie binds its two vertices any more,
    // ascending.
    std::vector<OpenJoint> open_joints() const;

    const TearReport& report() const { return report_; }
    TearState state() const;
    // Throws InputError and changes nothing where the state is not of this mesh.
    void restore(const TearState& state);

  private:
    struct Tied {
        int joint;
        int corner;
    };

    double load_of(const Joint& joint, double limit_pa, const TearLoads& loads) const;
    bool holds(int joint) const;  // whole, or bound by ties
    bool apart(double most_mm) const { return most_mm >= softening_.opening_mm; }
    void part(std::span<const int> joints, double most_mm);
    void add_neighbours(std::vector<int>& overloaded) const;
    std::size_t within_budget(std::span<const int> joints) const;
    void make_ties();
    void count();
    void report_entropy();

    TearLaw law_;
    SofteningLaw softening_;
    TornTopology topology_;
    std::vector<std::array<int, 4>> whole_;  // tetrahedra before anything tore
    std::vector<double> volume_mm3_;         // of each, at rest
    double whole_volume_mm3_ = 0.0;
    int whole_pieces_ = 0;
    std::vector<std::array<int, 2>> sides_;  // tetrahedra of each joint
    std::vector<double> factor_;             // of each joint: times the strength, without weakness
    std::vector<double> weakness_;           // of each joint
    std::vector<std::array<double, 3>> most_mm_;  // of each joint
    std::vector<int> parted_;                     // joints, ascending
    std::vector<SofteningTie> ties_;
    std::vector<Tied> tied_;  // joint and corner of each tie
    bool begun_ = false, stopped_ = false;
    double entropy_before_ = 0.0, entropy_ = 0.0;
    double elastic_ = 0.0;  // energy at the last measure [nJ]
    TearReport report_;
    std::vector<double> load_;       // of joints
    bool warns_ = false;             // one of them reaches `warning_load`
    bool any_weakened_ = false;      // since the last restore()
    std::vector<double> weights_;    // of vertices; scratch
    std::vector<double> stress_pa_;  // norms of the tetrahedra's stresses; scratch
};

}  // namespace hepatica
