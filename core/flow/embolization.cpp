// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flow/embolization.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <sstream>

#include "core/base/error.h"

namespace hepatica {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// Distributions of std:: differ between libraries; these do not.
class Dice {
  public:
    explicit Dice(std::uint64_t seed) : engine_(seed) {}
    double uniform() { return (static_cast<double>(engine_() >> 11) + 0.5) * 0x1p-53; }
    double normal() {
        const double radius = std::sqrt(-2.0 * std::log(uniform()));
        return radius * std::cos(2.0 * std::numbers::pi * uniform());
    }

  private:
    std::mt19937_64 engine_;
};

void validate_options(const EmbolizationOptions& options) {
    const auto check = [](const char* what, double value, double low, double high) {
        if (value >= low && value <= high) return;
        std::ostringstream problem;
        std::ostringstream remedy;
        problem << "the " << what << " is " << value;
        remedy << "Give a value from " << low << " to " << high;
        throw InputError(problem.str(), "embolization", remedy.str());
    };
    check("mean diameter in micrometres", options.beads.mean_diameter_um, 1.0, 1e5);
    check("standard deviation of the diameter in micrometres", options.beads.diameter_sd_um, 0.0,
          options.beads.mean_diameter_um / 3.0);
    check("density of the beads in g/mm3", options.beads.density_g_mm3, 1e-6, 1.0);
    check("number of beads", options.bead_count, 0, 1e8);
    check("number of beads in a batch", options.batch, 1, 1e8);
    check("share of the flow that counts as stasis", options.stasis_fraction, 0.0, 1.0);
    check("capillary radius in micrometres", options.capillary_radius_um, 0.0, 1e3);
}

// The microvascular bed beyond one outlet, by the share of it that is still open. Beads that stop
// in a generation take an equal part of what the generations above have left open.
struct Bed {
    double radius_mm = 0.0;
    double resistance = 0.0;  // when all of it is open
    double open_share = 1.0;

    // Closes one of (r/b)^3 vessels.
    void shut(double bead_radius_mm) {
        const double vessels = std::pow(radius_mm / bead_radius_mm, 3);
        open_share = std::max(0.0, open_share - 1.0 / std::max(vessels, 1.0));
        if (open_share < 1e-9) open_share = 0.0;
    }
    double present_resistance() const {
        return open_share > 0.0 ? resistance / open_share : infinite;
    }
};

class BeadTransport {
  public:
    BeadTransport(const FlowNetwork& network, const FlowConditions& conditions, int inlet,
                  const EmbolizationOptions& options)
        : options_(options), conditions_(conditions), inlet_(inlet), dice_(options.seed) {
        result_.network = network;
        if (inlet < 0 || inlet >= static_cast<int>(conditions.inlets.size()) ||
            conditions.inlets[inlet].kind != InletKind::pressure)
            throw InputError("the beads' inlet is not driven by a pressure", "embolization",
                             "Give the inlet a pressure: under a fixed flow nothing can stop");
        if (conditions.terminal_resistances.size() != network.outlet_nodes.size())
            throw InputError("there is no bed beyond the outlets", "embolization",
                             "Give every outlet a terminal resistance");
        at_ = segments_at_nodes(network);
        outlet_at_.assign(network.node_count, -1);
        torn_at_.assign(network.node_count, -1);
        for (std::size_t t = 0; t < network.torn_nodes.size(); ++t)
            torn_at_[network.torn_nodes[t]] = static_cast<int>(t);
        std::vector<double> radius(network.node_count, 0.0);
        for (std::size_t i = 0; i < network.segments.size(); ++i) {
            const int id = static_cast<int>(i);
            const FlowSegment& s = network.segments[i];
            radius[s.proximal_node] =
                std::max(radius[s.proximal_node], hepatica::proximal_radius_mm(network, id));
            radius[s.distal_node] =
                std::max(radius[s.distal_node], hepatica::distal_radius_mm(network, id));
        }
        for (std::size_t o = 0; o < network.outlet_nodes.size(); ++o) {
            const int node = network.outlet_nodes[o];
            outlet_at_[node] = static_cast<int>(o);
            beds_.push_back({radius[node], conditions.terminal_resistances[o], 1.0});
        }
        const std::size_t segments = network.segments.size();
        result_.lodged_in_segment.assign(segments, 0);
        result_.segment_mass_g.assign(segments, 0.0);
        result_.lodged_at_mm.assign(segments, infinite);
        result_.lodged_beyond_outlet.assign(beds_.size(), 0);
        result_.outlet_mass_g.assign(beds_.size(), 0.0);
        solve();
        first_flow_ = result_.end.inlet_flow_mm3_s[inlet_];
        sample();
    }

    // Injects one batch into the present flow; false once no more beads enter.
    bool inject_batch(const Job& job) {
        const int count = std::min(options_.batch, options_.bead_count - result_.injected);
        if (count <= 0 || result_.stasis) return false;
        constexpr int beads_between_checks = 4096;
        for (int i = 0; i < count; ++i) {
            if (i % beads_between_checks == 0) job.throw_if_cancelled();
            inject_bead();
        }
        for (std::size_t o = 0; o < beds_.size(); ++o)
            conditions_.terminal_resistances[o] = beds_[o].present_resistance();
        solve();
        sample();
        return !result_.stasis;
    }

    Embolization take() {
        for (const Bed& bed : beds_) result_.bed_open_share.push_back(bed.open_share);
        return std::move(result_);
    }

  private:
    double bead_radius_mm() {
        double deviation = dice_.normal();
        while (std::abs(deviation) > 3.0) deviation = dice_.normal();
        const double diameter =
            options_.beads.mean_diameter_um + deviation * options_.beads.diameter_sd_um;
        return 0.5e-3 * std::max(diameter, 1e-3 * options_.beads.mean_diameter_um);
    }

    void inject_bead() {
        const double radius = bead_radius_mm();
        const double mass =
            4.0 / 3.0 * std::numbers::pi * radius * radius * radius * options_.beads.density_g_mm3;
        ++result_.injected;
        result_.injected_mass_g += mass;
        int node = conditions_.inlets[inlet_].node;
        // Steady flow has no cycles, so a bead meets each node at most once.
        for (int steps = 0; steps <= result_.network.node_count; ++steps) {
            if (bleeds_from(node)) break;
            const int choice = choose(node);
            if (choice == leaves) {
                stop_in_bed(outlet_at_[node], radius, mass);
                return;
            }
            if (choice < 0) break;
            const FlowSegment& s = result_.network.segments[choice];
            const bool forwards = s.proximal_node == node;
            // Nothing passes a plug, however narrow it is.
            const double place = s.open
                                     ? lodging_place_mm(result_.network, choice, radius, forwards)
                                     : result_.lodged_at_mm[choice];
            if (place < infinite) {
                lodge(choice, place, mass);
                return;
            }
            node = forwards ? s.distal_node : s.proximal_node;
        }
        ++result_.passed;
        result_.passed_mass_g += mass;
    }

    double outflow(int node, int segment) const {
        const FlowSegment& s = result_.network.segments[segment];
        const double q = result_.end.volume_flow_mm3_s[segment];
        return s.open ? std::max(s.proximal_node == node ? q : -q, 0.0) : 0.0;
    }

    double onwards(int node) const {
        double total = 0.0;
        for (int i = at_.first[node]; i < at_.first[node + 1]; ++i)
            total += outflow(node, at_.segments[i]);
        return total;
    }

    // A fork that a branch was torn off goes on into its other branches.
    bool bleeds_from(int node) {
        if (torn_at_[node] < 0) return false;
        const double further = onwards(node);
        if (!(further > 0.0)) return true;
        const double out = std::max(result_.end.torn_flow_mm3_s[torn_at_[node]], 0.0);
        return dice_.uniform() * (out + further) < out;
    }

    static constexpr int leaves = -2;

    // The way out of a node: a segment, `leaves` for the outlet, or -1 where nothing flows out. A
    // segment that this batch has plugged takes no more beads.
    int choose(int node) {
        double total = onwards(node);
        const int outlet = outlet_at_[node];
        const double through_bed =
            outlet >= 0 ? std::max(result_.end.outlet_flow_mm3_s[outlet], 0.0) : 0.0;
        total += through_bed;
        if (!(total > 0.0)) return last_resort(node);
        double pick = dice_.uniform() * total;
        int chosen = -1;
        for (int i = at_.first[node]; i < at_.first[node + 1]; ++i) {
            const double q = outflow(node, at_.segments[i]);
            if (q <= 0.0) continue;
            chosen = at_.segments[i];
            pick -= q;
            if (pick < 0.0) return chosen;
        }
        return through_bed > 0.0 ? leaves : chosen;
    }

    // This batch has plugged every segment out of this node: the bead stays behind a plug.
    int last_resort(int node) const {
        for (int i = at_.first[node]; i < at_.first[node + 1]; ++i) {
            const int segment = at_.segments[i];
            const FlowSegment& s = result_.network.segments[segment];
            const double q = result_.end.volume_flow_mm3_s[segment];
            if ((s.proximal_node == node ? q : -q) > 0.0) return segment;
        }
        return -1;
    }

    void lodge(int segment, double place_mm, double mass) {
        if (result_.lodged_in_segment[segment] == 0) result_.lodged_at_mm[segment] = place_mm;
        ++result_.lodged_in_segment[segment];
        result_.segment_mass_g[segment] += mass;
        result_.network.segments[segment].open = false;
    }

    void stop_in_bed(int outlet, double radius, double mass) {
        if (radius <= 1e-3 * options_.capillary_radius_um) {
            ++result_.passed;
            result_.passed_mass_g += mass;
            return;
        }
        ++result_.lodged_beyond_outlet[outlet];
        result_.outlet_mass_g[outlet] += mass;
        beds_[outlet].shut(radius);
    }

    void solve() { result_.end = solve_flow(result_.network, conditions_); }

    void sample() {
        EmbolizationSample s;
        s.injected = result_.injected;
        s.flow_mm3_s = result_.end.inlet_flow_mm3_s[inlet_];
        s.inlet_pressure_pa = result_.end.inlet_pressure_pa[inlet_];
        s.passed = result_.passed;
        s.lodged = result_.injected - result_.passed;
        for (const double q : result_.end.outlet_flow_mm3_s) s.open_outlets += q > 0.0 ? 1 : 0;
        result_.series.push_back(s);
        result_.stasis = s.flow_mm3_s <= options_.stasis_fraction * first_flow_;
    }

    EmbolizationOptions options_;
    FlowConditions conditions_;
    int inlet_;
    Dice dice_;
    NodeSegments at_;
    std::vector<int> outlet_at_;
    std::vector<int> torn_at_;
    std::vector<Bed> beds_;
    double first_flow_ = 0.0;
    Embolization result_;
};

}  // namespace

std::vector<Beads> bead_presets() {
    const char* spheres =
        "calibrated microspheres; the nominal range is taken as mean and three deviations";
    return {{"100-300", 200.0, 100.0 / 3.0, 1.2e-3, spheres},
            {"300-500", 400.0, 100.0 / 3.0, 1.2e-3, spheres},
            {"500-700", 600.0, 100.0 / 3.0, 1.2e-3, spheres},
            {"gelatin", 1000.0, 300.0, 1.1e-3,
             "gelatin sponge cut by hand, 0.5 to 2 mm; spread and density are guesses"}};
}

Beads bead_preset(const std::string& name) {
    std::string known;
    for (const Beads& beads : bead_presets()) {
        if (beads.name == name) return beads;
        known += known.empty() ? beads.name : ", " + beads.name;
    }
    throw InputError("there are no beads called '" + name + "'", "beads",
                     "Choose one of: " + known);
}

double Embolization::mass_error_relative() const {
    double found = passed_mass_g;
    for (const double mass : segment_mass_g) found += mass;
    for (const double mass : outlet_mass_g) found += mass;
    return injected_mass_g > 0.0 ? std::abs(found - injected_mass_g) / injected_mass_g : 0.0;
}

double lodging_place_mm(const FlowNetwork& network, int segment, double bead_radius_mm,
                        bool forwards) {
    const FlowSegment& s = network.segments[segment];
    double begin = forwards ? 0.0 : length_mm(network, segment);
    for (int k = 0; k < s.cone_count; ++k) {
        const Cone& cone = network.cones[s.first_cone + (forwards ? k : s.cone_count - 1 - k)];
        const double enter = forwards ? cone.proximal_radius_mm : cone.distal_radius_mm;
        const double leave = forwards ? cone.distal_radius_mm : cone.proximal_radius_mm;
        if (enter <= bead_radius_mm) return begin;
        const double direction = forwards ? 1.0 : -1.0;
        if (leave <= bead_radius_mm)
            return begin + direction * cone.length_mm * (enter - bead_radius_mm) / (enter - leave);
        begin += direction * cone.length_mm;
    }
    return infinite;
}

Embolization embolize(const FlowNetwork& network, const FlowConditions& conditions, int bead_inlet,
                      const EmbolizationOptions& options, Job& job) {
    job.begin_stage("embolization");
    validate_options(options);
    BeadTransport transport(network, conditions, bead_inlet, options);
    int sent = 0;
    while (transport.inject_batch(job)) {
        sent += options.batch;
        job.advance(std::min(1.0, sent / std::max(1.0, static_cast<double>(options.bead_count))));
    }
    return transport.take();
}

}  // namespace hepatica
