// SPDX-License-Identifier: GPL-3.0-or-later
// The blood loss of torn vessels: the tree at its resting inflow, with an opening into the
// surroundings at each stump and at each side that is open, narrowed where a tool presses on it
// harder than its blood does (tube_law.h). Solved again when tears or pressures change.
#pragma once

#include <vector>

#include "core/flow/flow_network.h"
#include "core/flow/flow_solution.h"
#include "core/flow/tube_law.h"
#include "core/scene/pressed_stretches.h"
#include "core/scene/through_tears.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// An adult of 70 kg at rest: hepatic artery 3.5, portal vein 13.5 ml/min/kg (Carlisle 1992). The
// beds behind the vessels' ends take these flows at these pressures; a torn hepatic vein bleeds
// back from the vena cava.
struct RestingFlow {
    double portal_g_s = 16.7;
    double artery_g_s = 4.3;
    double portal_pa = 1070.0;  // 8 mmHg above tissue pressure, at the liver's bed
    double artery_pa = 10700.0;
    double cava_pa = 670.0;
    double ambient_pa = 0.0;
    // Pressure of the aorta, which drives both; inflow falls as inlet pressure approaches it.
    double aorta_pa = 12700.0;
};

// The pressure of the blood in a system's vessels at rest.
double resting_pressure_pa(VascularSystem system, const RestingFlow& rest = {});

// Blood where it was lost, at what is open or was.
struct BloodPool {
    ThroughTear of;  // with its last opening
    double lost_g = 0.0;
    double drug_g = 0.0;  // of that
};

// The defaults: nothing presses.
struct PressedLumen {
    int segment = -1;  // of the tree
    double open_share = 1.0;
};

// Not thread-safe.
class Bleeding {
  public:
    explicit Bleeding(const VesselTree& tree, const RestingFlow& rest = {});

    // Costs a solution of the network where the tears are not those of the last call. What bled at
    // one that is no longer among them, as a side that has closed, stays there.
    void set_tears(const std::vector<ThroughTear>& tears);
    // Costs a solution of the network where an open share changes by more than two fifths, or a
    // place by more than a millimetre. Costs nothing while nothing is torn.
    void set_pressed(const std::vector<PressedStretch>& stretches, const TubeWall& wall);
    // The lumen with the least open share of those on the way from a root to a tear, or of all
    // others, which press on no bleeding.
    PressedLumen most_pressed(bool before_a_tear) const;
    void step(double dt_s);

    double leak_g_s() const { return leak_g_s_; }
    // Blood loss at each of the tears that were set; the sum is leak_g_s().
    const std::vector<ThroughTear>& tears() const { return tears_; }
    const std::vector<double>& leaks_g_s() const { return leaks_g_s_; }
    double leaked_g() const { return leaked_g_; }
    // One for each of the tears, in their order, then those where nothing is open any more. The sum
    // is leaked_g(), unless that was set without its pools or they were emptied.
    const std::vector<BloodPool>& pools() const { return pools_; }
    // The share of leaked_g() that lies in each of the pools; the sum is 1 where there are any and
    // blood was lost. As the present losses, until the next step, where no pool was set.
    std::vector<double> shares_of_loss() const;
    // Sets the sum and empties the pools.
    void set_leaked_g(double leaked_g);
    // What lies where, as after a restore.
    void set_pools(const std::vector<BloodPool>& pools);
    // Of leaked_g(), what is drug. Of it, this share is lost at each of the tears; none: nowhere.
    void leak_drug(double drug_g, const std::vector<double>& shares);
    double leaked_drug_g() const { return leaked_drug_g_; }
    void set_leaked_drug_g(double leaked_g) { leaked_drug_g_ = leaked_g; }

  private:
    struct Squeeze {
        int segment = -1;
        double from_mm = 0.0, to_mm = 0.0;
        double share = 1.0;
        bool operator==(const Squeeze&) const = default;
    };
    bool lies_before_a_tear(const Squeeze& squeeze) const;
    void solve();
    void limit_inflow(NetworkFlow& flow, const FlowConditions& conditions,
                      VascularSystem system) const;
    double pressure_in(int segment) const;

    VesselTree tree_;
    RestingFlow rest_;
    std::vector<ThroughTear> tears_;
    std::vector<Squeeze> squeezes_;
    std::vector<double> leaks_g_s_;
    std::vector<BloodPool> pools_;
    double leak_g_s_ = 0.0;
    double leaked_g_ = 0.0;
    double leaked_drug_g_ = 0.0;
};

}  // namespace hepatica
