// SPDX-License-Identifier: GPL-3.0-or-later
// One moment of the play, as shown: immutable once the simulation thread has published it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/vector.h"

namespace hepatica {

struct InjectionOptions;  // core/flow/injection.h
struct Obstacles;         // core/deform/body/obstacles.h

// The pull on the vessel, for drawing its line.
struct GrabView {
    Vec3 point_mm = Vec3::Zero();
    Vec3 target_mm = Vec3::Zero();
    double force_un = 0.0;
    bool at_limit = false;               // at least half of the springs are at their force limit
    std::optional<double> felt_un = {};  // mean of force_un, see FeltForce; none: outside a play
    double shown_un() const { return felt_un.value_or(force_un); }
};

// A tool beside the vessels, and the load on it.
struct ToolView {
    struct Part {  // a capsule
        Vec3 from_mm = Vec3::Zero();
        Vec3 to_mm = Vec3::Zero();
        double radius_mm = 0.0;
        Vec3 along_mm() const { return to_mm - from_mm; }
        bool operator==(const Part&) const = default;
    };
    std::vector<Part> parts;
    Vec3 centre_mm = Vec3::Zero();  // about which it turns
    Vec3 tip_mm = Vec3::Zero();     // the mean of its parts' far ends
    double opening_mm = 0.0;        // of the jaws
    bool closing = false;           // the jaws are commanded to be less than wide open
    Vec3 force_un = Vec3::Zero();   // of vessels and obstacles on the tool
    std::optional<double> felt_un;  // mean of |force_un|, see FeltForce; none: outside a play
    Vec3 at_mm = Vec3::Zero();      // force-weighted mean of its contacts
    double grip_un = 0.0;           // pressing the jaws apart; 0 where they do not close
    bool at_limit = false;          // near its force limit, where it neither moves on nor closes
    std::vector<int> touched;       // vertices of the touched triangles, ascending
    double shown_un() const { return felt_un.value_or(force_un.norm()); }
    // Two parts that point the same way; a hook's do not.
    bool has_jaws() const {
        constexpr double rounding_mm = 1e-6;
        return parts.size() == 2 &&
               (parts[0].along_mm() - parts[1].along_mm()).norm() <= rounding_mm;
    }
    // The point of a tool that is to come to a place: between the jaws a quarter of their length
    // from their tips, as AddTool brings them; at the bend of a hook; else the tip.
    Vec3 working_mm() const {
        if (parts.size() != 2) return tip_mm;
        return tip_mm - (has_jaws() ? 0.25 : 0.5) * parts[1].along_mm();
    }
    bool operator==(const ToolView&) const = default;
};

// The drug front. Arrival times belong to the vertices, so a frame costs only `time_s`.
struct DrugView {
    std::shared_ptr<const std::vector<float>> arrival_s;  // per vertex; infinity: never reached.
                                                          // Null: nothing was injected
    // The injection in the terms of core/flow: run until end_s on the tree at rest, it gives the
    // curves over time that belong to these arrival times. Null where arrival_s is.
    std::shared_ptr<const InjectionOptions> injection;
    std::uint64_t version = 0;  // changes whenever arrival_s does
    double time_s = 0.0;        // since the injection began
    double end_s = 0.0;      // when most vertices have been reached (some may be later); the clock
                             // stops there
    bool playing = false;    // the clock runs unless the world is paused; false without an
                             // injection, and from end_s on
    double speed = 1.0;      // drug seconds per second of the simulation
    bool computing = false;  // another injection is being computed and will replace this one
    // How many injections have been shown so far, with this one; less again where the play goes
    // back to before one.
    int injections = 0;
    // Per vertex: 1 where an injection before this one had come until it was replaced. Null where
    // there was none since the drug was last removed. A new one replaces it, none is changed.
    std::shared_ptr<const std::vector<std::uint8_t>> reached_before;

    // Whether the drug of the present injection has come to a vertex; of one before it.
    bool has_reached(std::size_t vertex) const {
        return arrival_s && vertex < arrival_s->size() && (*arrival_s)[vertex] <= time_s;
    }
    bool had_reached(std::size_t vertex) const {
        return reached_before && vertex < reached_before->size() && (*reached_before)[vertex] != 0;
    }
};

// Where a torn vessel bleeds or bled.
struct LeakView {
    Vec3 at_mm = Vec3::Zero();
    double share = 0.0;   // of the blood lost so far
    double drug_g = 0.0;  // of the drug that has leaked, at most this much lies here
};

// How the vessels are torn.
struct TearView {
    int joints_broken = 0;
    double torn_area_mm2 = 0.0;  // see TearReport
    int pieces = 1;
    int pieces_off = 0;  // more than the whole body has
    double entropy_nats = 0.0;
    double entropy_produced_nats = 0.0;
    double leak_g_s = 0.0;  // out of stumps
    double leaked_g = 0.0;
    // Least open share of a lumen under a tool on the way to what is torn; of one that is not on
    // the way, and its segment of the tree. 1 and -1 where nothing presses or is torn.
    double open_share = 1.0;
    double other_open_share = 1.0;
    int other_segment = -1;
    double leaked_drug_g = 0.0;  // of leaked_g; an upper bound, see drug_leak()
    std::vector<LeakView> leaks;
    std::string stopped_by;  // "entropy" or "vertices"; empty: not stopped
    // For each vertex, the vertex of the whole body that it comes from.
    std::shared_ptr<const std::vector<int>> origins;
    std::shared_ptr<const std::vector<std::uint8_t>> rims;  // per vertex: 1 on a tear
    // Per triangle of the surface: 1 where it was inside the whole body. Null where none was.
    std::shared_ptr<const std::vector<std::uint8_t>> bare;
    // Per vertex: the largest load over limit of its joints (joints tear at 1), or 0 where that is
    // below a half. Null where all are 0.
    std::shared_ptr<const std::vector<float>> loads;
    // Surface edges of weakened joints that still hold: a cut line that has not torn yet. Null
    // where there are none.
    std::shared_ptr<const std::vector<std::array<int, 2>>> weak_edges;
};

struct FrameStatistics {
    double step_ms = 0.0;           // wall time of the whole step: commands, world and this frame
    double real_time_factor = 1.0;  // simulated over wall time, at most 1
    int linear_iterations = 0;
    double expected_error = 0.0;  // relative, of the present setting of the dial; 0: unknown
    std::string error_reference;  // the reference of that error
    // Of the present setting: 0 fastest, 1 most accurate; 0 where it is not on the dial.
    double quality = 0.0;
    bool automatic = false;  // the session picks the setting
    std::string setting;     // in words
    std::string device;      // makes the steps; empty: the processor
    bool degraded = false;
    bool paused = false;    // the world stands still, and the drug's clock too
    bool resting = false;   // nothing changes and no frame follows until the next command
    bool diverged = false;  // it stopped and was taken back to its last good state; RestoreSnapshot
                            // and SetPaused{false} go on from there
    bool message_of_solver = false;  // the message is what the solver says of a degraded step
    std::string message;             // for the user; usually empty
};

struct Frame {
    std::uint64_t step = 0;
    double time_s = 0.0;
    std::uint64_t topology_version = 0;  // changes whenever the triangles do
    std::shared_ptr<const std::vector<std::array<int, 3>>> surface;  // triangles over the vertices
    std::vector<float> positions_mm;                                 // x, y, z per vertex
    std::optional<GrabView> grab;
    std::optional<ToolView> tool;
    // The obstacles of vessels and tools, which never move; null where the scene has none.
    std::shared_ptr<const Obstacles> obstacles;
    // Coulomb's coefficient of vessels that touch each other; none: they do not touch.
    std::optional<double> self_friction;
    std::optional<TearView> tear;  // none where nothing can tear
    DrugView drug;
    FrameStatistics statistics;

    Vec3 place_mm(int vertex) const {
        const auto i = 3 * static_cast<std::size_t>(vertex);
        return {positions_mm[i], positions_mm[i + 1], positions_mm[i + 2]};
    }
    // Lower and upper corner of the box around all vertices. Infinite and turned inside out without
    // any.
    std::array<Vec3, 2> box_mm() const {
        constexpr double far = std::numeric_limits<double>::infinity();
        std::array<Vec3, 2> box{Vec3::Constant(far), Vec3::Constant(-far)};
        for (int v = 0; 3 * static_cast<std::size_t>(v) < positions_mm.size(); ++v) {
            const Vec3 place = place_mm(v);
            box = {box[0].cwiseMin(place), box[1].cwiseMax(place)};
        }
        return box;
    }
    // The vertex of the whole body that a vertex comes from; -1 stays -1.
    int origin_of(int vertex) const {
        return tear && tear->origins && vertex >= 0 ? (*tear->origins)[vertex] : vertex;
    }
};

}  // namespace hepatica
