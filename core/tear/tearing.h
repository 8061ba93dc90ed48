// SPDX-License-Identifier: GPL-3.0-or-later
// How a body tears, step after step: joints whose load reaches their limit part, are bound by a
// softening traction until they have come apart, and no more of them part once the entropy that the
// tear has produced, or the number of its vertices, reaches its budget.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/tear/tear_law.h"
#include "core/tear/tear_state.h"
#include "core/tear/torn_topology.h"

namespace hepatica {

// A body after a step. All spans have one entry per tetrahedron but the last two, which have one
// per vertex.
struct TearLoads {
    std::span<const Mat3> stress_pa;  // first Piola-Kirchhoff
    std::span<const double> energy_nj;
    std::span<const Vec3> positions_mm;
    std::span<const double> mass_g;
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

    // Those that were weakened and hold all the same, ascending.
    std::vector<int> weakened() const;

    // The joints between tetrahedra on different sides of the parallelogram with a corner and two
    // edges, where the way between their centres crosses it.
    std::vector<int> crossing(const Vec3& corner_mm, const Vec3& first_edge_mm,
                              const Vec3& second_edge_mm, std::span<const Vec3> positions_mm) const;
    // Parts them at once; nothing binds what is cut.
    void cut(std::span<const int> joints);

    // Parts what is overloaded, at most `most_joints` a step, the most loaded first. True where
    // topology or ties changed.
    bool part_overloaded(const TearLoads& loads);
    static constexpr int most_joints = 256;

    // Entropy, and with it the stop, after a step of a body.
    void measure(const TearLoads& loads);

    // Load over limit of each joint, 0 where it has parted: 1 tears. Those that are below `least`
    // may be given as 0, which costs a fraction.
    void find_loads(const TearLoads& loads, double least, std::vector<double>& load);

    // Load over limit of each joint as after the last step, 0 where it has parted: exact from
    // `warning_load` on, below that it may be given as 0. Empty where none was found: before the
    // first step, and once a stop has ended the tear.
    std::span<const double> loads() const { return load_; }
    static constexpr double warning_load = 0.5;

    // What binds the parted joints. The caller keeps them while it makes steps, and gives back how
    // far they were opened, in their order, before anything else is asked.
    const std::vector<SofteningTie>& ties() const { return ties_; }
    void take_openings(std::span<const SofteningTie> ties);
    // Pairs of vertices that stood for one before a joint between them parted, whether it is still
    // bound or not, ascending.
    std::vector<std::array<int, 2>> parted_pairs() const;

    // The vertices that ties still hold together.
    std::vector<std::array<int, 2>> bound_pairs() const;

    const TearReport& report() const { return report_; }
    TearState state() const;
    // Throws InputError, and changes nothing, where the state is not of this mesh.
    void restore(const TearState& state);

  private:
    struct Tied {
        int joint;
        int corner;
    };

    double load_of(const Joint& joint, double limit_pa, const TearLoads& loads) const;
    bool apart(double most_mm) const { return most_mm >= softening_.opening_mm; }
    void part(std::span<const int> joints, double most_mm);
    void add_neighbours(std::vector<int>& overloaded) const;
    void make_ties();
    void count();
    void report_entropy();

    TearLaw law_;
    SofteningLaw softening_;
    TornTopology topology_;
    std::vector<std::array<int, 4>> whole_;  // tetrahedra before anything tore
    std::vector<double> volume_mm3_;         // of each, at rest
    std::vector<std::array<int, 2>> sides_;  // tetrahedra of each joint
    std::vector<double> factor_;             // of each joint: times the strength, weakness apart
    std::vector<double> weakness_;           // of each joint
    std::vector<std::array<double, 3>> most_mm_;  // of each joint
    std::vector<int> parted_;                     // joints, ascending
    std::vector<SofteningTie> ties_;
    std::vector<Tied> tied_;  // what each tie binds
    bool begun_ = false, stopped_ = false;
    double entropy_before_ = 0.0, entropy_ = 0.0;
    double elastic_ = 0.0;  // energy at the last measure [nJ]
    TearReport report_;
    std::vector<double> load_;       // of joints
    std::vector<double> weights_;    // of vertices; scratch
    std::vector<double> stress_pa_;  // sizes of the tetrahedra's stress; scratch
};

}  // namespace hepatica
