// SPDX-License-Identifier: GPL-3.0-or-later
// The touch campaign of the stability suite: tools and vessels are driven through random vessel
// trees at any speed, and vessels are squeezed, dragged and pulled into knots. Nothing may cross.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/base/frame_time.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/mesh/crossing_triangles.h"
#include "core/scene/crossings.h"
#include "core/scene/tools/tool_choice.h"
#include "core/study/extreme_cases.h"
#include "core/study/random_tool.h"
#include "core/study/touch_bodies.h"
#include "core/study/trial.h"
#include "core/study/vessel_body.h"

namespace hepatica {
namespace {

constexpr int looks = 20;
constexpr double slowest_mm_per_s = 10.0, fastest_mm_per_s = 1e5;
constexpr int points_on_axis = 9;
constexpr double grab_stiffness_un_per_mm = 5e4, grab_limit_un = 2e5;
constexpr int steps_to_a_goal = 20;

enum class Play { sphere, capsule, hook, squeeze, drag, knot };
constexpr std::array<const char*, 6> names{"sphere", "rod", "hook", "squeeze", "drag", "knot"};

bool holds(const TetMesh& mesh, std::span<const Vec3> x, const Vec3& point) {
    return std::ranges::any_of(mesh.tetrahedra, [&](const auto& t) {
        for (int a = 0; a < 4; ++a) {
            std::array<Vec3, 4> with{x[t[0]], x[t[1]], x[t[2]], x[t[3]]};
            with[a] = point;
            if (!(signed_volume_mm3(with[0], with[1], with[2], with[3]) > 0.0)) return false;
        }
        return true;
    });
}

// One play on one body.
class TouchTrial {
  public:
    TouchTrial(Play play, double speed_mm_per_s, std::mt19937_64& random, BodyDescription body)
        : play_(play), random_(random), speed_mm_per_s_(speed_mm_per_s), body_(std::move(body)) {
        body_.self.emplace();
        body_.touchable = true;
        surface_ = boundary_triangles(body_.mesh);
        extent_ = extent_of(body_);
    }

    ExtremeRow run(int steps, const ExtremeRun& how) {
        ExtremeRow row;
        stepper_ = make_cpu_stepper(body_, {});
        Trial trial(*stepper_, row, how);
        begin();
        for (int k = 0; k < steps; ++k) {
            if (k % steps_to_a_goal == 0) choose_goal();
            lead();
            if (!trial.run(1, frame_s)) return row;
            if (k % std::max(1, steps / looks) == 0 && !look(trial)) return row;
        }
        look(trial);
        return row;
    }

  private:
    // Places a tool beside the body, or grabs a vessel by its end.
    void begin() {
        if (play_ == Play::drag || play_ == Play::knot) {
            grab_.vertices[0] = furthest_vertex(body_);
            grab_.stiffness_un_per_mm = grab_stiffness_un_per_mm;
            grab_.force_limit_un = grab_limit_un;
            grab_.target_mm = body_.mesh.vertices_mm[grab_.vertices[0]];
            return;
        }
        const char* const kind = play_ == Play::sphere    ? "sphere"
                                 : play_ == Play::capsule ? "capsule"
                                 : play_ == Play::hook    ? "hook"
                                                          : "forceps";
        stepper_->set_tool(random_tool(kind, body_, extent_, random_));
    }

    // Chooses a vessel, or a place beyond it, as goal; forceps open and close in turn.
    void choose_goal() {
        const Vec3 direction = random_direction(random_);
        const double share = uniform(random_, 0.0, 0.3);
        const Vec3 vessel = random_point(stepper_->positions_mm(), random_);
        goal_mm_ = vessel + share * extent_.reach_mm * direction;
        ++goals_;
        if (play_ != Play::squeeze) return;
        const double widest = widest_opening_mm(*stepper_->tool());
        stepper_->open_tool(goals_ % 3 == 0 ? 0.0 : widest);
    }

    void lead() {
        const auto next = [&](const Vec3& at_mm) -> Vec3 {
            const Vec3 way = goal_mm_ - at_mm;
            return at_mm +
                   std::min(1.0, speed_mm_per_s_ * frame_s / std::max(way.norm(), 1e-9)) * way;
        };
        if (!stepper_->tool()) {
            grab_.target_mm = next(grab_.target_mm);
            stepper_->set_grabs(std::span(&grab_, 1));
            return;
        }
        stepper_->lead_tool(next(stepper_->tool()->centre_mm()));
        if (play_ == Play::sphere) return;
        const Vec3 axis = random_direction(random_);
        const double angle = uniform(random_, 0.0, 0.1);
        stepper_->turn_tool(angle * axis);
    }

    bool look(Trial& trial) const {
        const auto x = stepper_->positions_mm();
        const OverlapsKept overlaps = stepper_->checkpoint().self->overlaps;
        if (!trial.require(crossing_pairs(surface_, body_.mesh.vertices_mm, x, overlaps) == 0,
                           "triangles cross"))
            return false;
        if (!stepper_->tool()) return true;
        for (const Capsule& part : stepper_->tool()->shapes())
            for (int k = 0; k < points_on_axis; ++k) {
                const double along = 2.0 * k / (points_on_axis - 1) - 1.0;
                const Vec3 point = part.centre_mm + along * part.half_axis_mm;
                if (!trial.require(!holds(body_.mesh, x, point), "the tool stands in a vessel"))
                    return false;
            }
        return true;
    }

    Play play_;
    std::mt19937_64& random_;
    double speed_mm_per_s_;
    BodyDescription body_;
    std::vector<std::array<int, 3>> surface_;
    BodyExtent extent_;
    Vec3 goal_mm_ = Vec3::Zero();
    int goals_ = 0;
    std::unique_ptr<Stepper> stepper_;
    Grab grab_;
};

BodyDescription random_body(Play play, std::mt19937_64& random, int tetrahedra) {
    Job job;
    BodyDescription body = play == Play::knot
                               ? body_of(open_knot(uniform(random, 0.8, 1.6)), tetrahedra, job)
                               : body_of(random_study_tree(random), tetrahedra, job);
    // Meshes of branches that pass close to each other may intersect themselves at rest.
    if (!crossing_triangles(boundary_triangles(body.mesh), body.mesh.vertices_mm).empty())
        throw InputError("crosses itself at rest", "the mesh of the tree", "Take another seed");
    return body;
}

std::string name_of_trial(int number, Play play, double speed_mm_per_s, std::size_t tetrahedra) {
    char name[80];
    std::snprintf(name, sizeof name, "touch %d %s at %.3g mm/s, %zu tetrahedra", number,
                  names[static_cast<std::size_t>(play)], speed_mm_per_s, tetrahedra);
    return name;
}

double random_speed_mm_per_s(std::mt19937_64& random) {
    return slowest_mm_per_s *
           std::pow(fastest_mm_per_s / slowest_mm_per_s, uniform(random, 0.0, 1.0));
}

ExtremeCase on_patient(const TouchCampaign& campaign, int t, std::mt19937_64 random) {
    const std::size_t turn = static_cast<std::size_t>(t) / campaign.patients.size();
    const auto body = campaign.patients[static_cast<std::size_t>(t) % campaign.patients.size()];
    const auto play = static_cast<Play>(turn % static_cast<std::size_t>(Play::knot));
    const double speed = random_speed_mm_per_s(random);
    return {name_of_trial(t, play, speed, body->mesh.tetrahedra.size()),
            [=, steps = campaign.steps](const ExtremeRun& how) {
                std::mt19937_64 own = random;  // a row may be run more than once
                return TouchTrial(play, speed, own, *body).run(steps, how);
            }};
}

}  // namespace

// Each trial has its own random numbers, so that a row can be run alone.
std::vector<ExtremeCase> touch_cases(const TouchCampaign& campaign) {
    std::vector<ExtremeCase> cases;
    for (int t = 0; t < campaign.trials; ++t) {
        std::mt19937_64 random(campaign.seed * 1'000'003 + static_cast<std::uint64_t>(t));
        if (!campaign.patients.empty()) {
            cases.push_back(on_patient(campaign, t, random));
            continue;
        }
        const auto play = static_cast<Play>(static_cast<std::size_t>(t) % names.size());
        const double speed = random_speed_mm_per_s(random);
        const int tetrahedra =
            static_cast<int>(uniform(random, 0.15, 1.0) * campaign.most_tetrahedra);
        cases.push_back({name_of_trial(t, play, speed, static_cast<std::size_t>(tetrahedra)),
                         [=, steps = campaign.steps](const ExtremeRun& how) {
                             std::mt19937_64 own = random;  // a row may be run more than once
                             BodyDescription body = random_body(play, own, tetrahedra);
                             return TouchTrial(play, speed, own, std::move(body)).run(steps, how);
                         }});
    }
    return cases;
}

}  // namespace hepatica
