// SPDX-License-Identifier: GPL-3.0-or-later
// Embolization, the second half of the treatment that the paper names: the blood carries particles,
// they lodge where the lumen is as narrow as they are, and the flow is diverted until it stops.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/flow/flow_solution.h"

namespace hepatica {

// A kind of particle. Diameters are normally distributed, truncated at three standard deviations.
struct Beads {
    std::string name;
    double mean_diameter_um = 200.0;
    double diameter_sd_um = 33.0;
    double density_g_mm3 = 1.2e-3;
    std::string source;
};

// "100-300", "300-500", "500-700" (calibrated microspheres) and "gelatin".
std::vector<Beads> bead_presets();
Beads bead_preset(const std::string& name);  // throws InputError that lists them

// The vessels beyond an outlet are too small to be seen. They are modelled as a tree under Murray's
// law from the outlet's radius down to `capillary_radius_um`. A bead of radius b that leaves
// through an outlet of radius r stops in the generation of its own size and closes one of its
// (r/b)^3 vessels, so the bed's resistance is divided by the open share. Unless measured, this bed
// is a guess; beads narrower than the capillaries pass to the veins.
struct EmbolizationOptions {
    Beads beads;
    int bead_count = 20'000;        // at most this many are injected
    int batch = 100;                // beads per flow field; then it is solved again
    double stasis_fraction = 0.05;  // stasis: flow at the tip below this share of the initial one
    double capillary_radius_um = 4.0;
    std::uint64_t seed = 1;
};

struct EmbolizationSample {
    int injected = 0;         // beads so far
    double flow_mm3_s = 0.0;  // through the tip
    double inlet_pressure_pa = 0.0;
    int lodged = 0;        // in resolved vessels and in beds
    int passed = 0;        // through the capillaries, or out of a tear
    int open_outlets = 0;  // outlets whose bed still carries flow
};

struct Embolization {
    std::vector<EmbolizationSample> series;  // one per batch; the first before any bead
    // Beads and their mass, by where they stopped.
    std::vector<int> lodged_in_segment;     // per segment of the network
    std::vector<int> lodged_beyond_outlet;  // per outlet
    std::vector<double> segment_mass_g;
    std::vector<double> outlet_mass_g;
    std::vector<double> lodged_at_mm;  // per segment: first bead, from the proximal node
    int injected = 0;
    int passed = 0;
    double injected_mass_g = 0.0;
    double passed_mass_g = 0.0;
    bool stasis = false;
    std::vector<double> bed_open_share;  // per outlet, at the end
    FlowNetwork network;                 // with the plugged segments closed
    FlowSolution end;
    double mass_error_relative() const;  // injected minus lodged and passed, relative
};

// Beads enter at conditions.inlets[bead_inlet], which must be driven by a pressure, because under a
// prescribed flow there is no stasis. At each branching a bead takes a branch with the probability
// of its share of the flow. Outlets need terminal resistances. The same options give the same
// result on any machine. Throws InputError, Cancelled.
Embolization embolize(const FlowNetwork& network, const FlowConditions& conditions, int bead_inlet,
                      const EmbolizationOptions& options, Job& job);

// The first place on the way of a bead of this radius where the lumen is no wider than the bead, in
// mm from the segment's proximal node; infinity if the bead gets through. `forwards`: from proximal
// to distal.
double lodging_place_mm(const FlowNetwork& network, int segment, double bead_radius_mm,
                        bool forwards);

}  // namespace hepatica
