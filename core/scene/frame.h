// SPDX-License-Identifier: GPL-3.0-or-later
// One moment of the play, as everything that shows it sees it: a value that is never changed after
// the simulation thread has published it.
#pragma once

#include <array>
#include <cstdint>
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
    bool at_limit = false;  // half of it or more pulls no harder, however far it is led
};

// A tool beside the vessels, and what it feels.
struct ToolView {
    struct Part {  // a capsule
        Vec3 from_mm = Vec3::Zero();
        Vec3 to_mm = Vec3::Zero();
        double radius_mm = 0.0;
        bool operator==(const Part&) const = default;
    };
    std::vector<Part> parts;
    Vec3 centre_mm = Vec3::Zero();  // about which it turns
    Vec3 tip_mm = Vec3::Zero();     // the middle of its parts' far ends
    double opening_mm = 0.0;        // of jaws
    Vec3 force_un = Vec3::Zero();   // of vessels and obstacles on the tool
    Vec3 at_mm = Vec3::Zero();      // the middle of where they touch it
    double grip_un = 0.0;           // with which jaws hold
    bool at_limit = false;          // it is not led further against such a force, nor closes
    std::vector<int> touched;       // vertices of the triangles that it touches, ascending
    bool operator==(const ToolView&) const = default;
};

// The drug front. Arrival times live on the vertices, so a frame costs only `time_s`.
struct DrugView {
    std::shared_ptr<const std::vector<float>> arrival_s;  // per vertex; infinity: never reached.
                                                          // Null: nothing was injected
    // What was injected and where, as core/flow takes it: run until end_s on the tree at rest, it
    // gives the curves over time that belong to these arrival times. Null with arrival_s.
    std::shared_ptr<const InjectionOptions> injection;
    std::uint64_t version = 0;  // changes whenever arrival_s does
    double time_s = 0.0;        // since the injection began
    double end_s = 0.0;  // when most vertices have been reached, some may be later: there the clock
                         // stops by itself
    bool playing = false;    // the drug's clock runs whenever the world is not paused; false where
                             // nothing was injected, and from end_s on
    double speed = 1.0;      // of its clock: seconds of the drug per second of the simulation
    bool computing = false;  // another injection is being computed and will take this one's place
};

// Where a torn vessel bleeds, and its share of all that is lost.
struct LeakView {
    Vec3 at_mm = Vec3::Zero();
    double share = 0.0;
};

// How the vessels are torn.
struct TearView {
    int joints_broken = 0;
    int pieces = 1;
    double entropy_nats = 0.0;
    double entropy_produced_nats = 0.0;
    double leak_g_s = 0.0;  // out of stumps
    double leaked_g = 0.0;
    double open_share = 1.0;  // of the lumen that a tool presses on most, while something bleeds
    std::vector<LeakView> leaks;
    std::string stopped_by;  // "entropy" or "vertices"; empty: it goes on
    // Of each vertex the one of the whole body that it comes from.
    std::shared_ptr<const std::vector<int>> origins;
    std::shared_ptr<const std::vector<std::uint8_t>> rims;  // of each: 1 where it lies on a tear
    // Of each: the most that a joint at it is loaded with, over its limit (1 tears), or 0 where
    // that is less than half. Null where nothing is near its limit.
    std::shared_ptr<const std::vector<float>> loads;
    // Edges of the surface at which a weakened joint still holds: a cut line that has not torn yet.
    // Null where there is none.
    std::shared_ptr<const std::vector<std::array<int, 2>>> weak_edges;
};

struct FrameStatistics {
    double step_ms = 0.0;           // wall time of the whole step: commands, world and this frame
    double real_time_factor = 1.0;  // simulated over wall time, at most 1
    int linear_iterations = 0;
    double expected_error = 0.0;  // relative, of the present setting of the dial; 0: not known
    std::string error_reference;  // what that error was measured against
    double quality = 0.0;         // of the present setting: 0 fastest, 1 most accurate
    bool automatic = false;       // the session picks the setting
    std::string setting;          // in words
    std::string device;           // that makes the steps; empty: the processor does
    bool degraded = false;
    bool paused = false;    // the world stands still, the drug's clock included
    bool resting = false;   // nothing changes, and no other frame comes, until the next command
    bool diverged = false;  // it was stopped by itself and taken back to its last good state;
                            // RestoreSnapshot and SetPaused{false} go on from there
    std::string message;    // for the user; usually empty
};

struct Frame {
    std::uint64_t step = 0;
    double time_s = 0.0;
    std::uint64_t topology_version = 0;  // changes whenever the triangles do
    std::shared_ptr<const std::vector<std::array<int, 3>>> surface;  // triangles over the vertices
    std::vector<float> positions_mm;                                 // x, y, z per vertex
    std::optional<GrabView> grab;
    std::optional<ToolView> tool;
    // What stands in the way of vessels and tools; null where the scene has none. It never moves.
    std::shared_ptr<const Obstacles> obstacles;
    // Coulomb's coefficient of vessels that touch each other; none: they pass through each other.
    std::optional<double> self_friction;
    std::optional<TearView> tear;  // none where nothing can tear
    DrugView drug;
    FrameStatistics statistics;

    // The vertex of the whole body that a vertex comes from; -1 stays -1.
    int origin_of(int vertex) const {
        return tear && tear->origins && vertex >= 0 ? (*tear->origins)[vertex] : vertex;
    }
};

}  // namespace hepatica
