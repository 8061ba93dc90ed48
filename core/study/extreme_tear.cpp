// SPDX-License-Identifier: GPL-3.0-or-later
// The tear campaign of the stability suite: random vessel trees are pulled, pressed, twisted and
// cut until they come apart, under random laws. After every transaction that splits something,
// SplitCheck checks the body (split_check.h).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <utility>

#include "core/base/frame_time.h"
#include "core/deform/stepper/stepper_checkpoint.h"
#include "core/mesh/tet_mesh.h"
#include "core/study/extreme_cases.h"
#include "core/study/random_tool.h"
#include "core/study/split_check.h"
#include "core/study/torn_crossings.h"
#include "core/study/touch_bodies.h"
#include "core/study/trial.h"
#include "core/study/vessel_body.h"
#include "core/tear/tearing.h"

namespace hepatica {
namespace {
constexpr double fist_radius_mm = 4.0;
constexpr double fist_un_per_mm = 3e5,
                 fist_limit_un = 1e7;  // of all springs of a hand together
constexpr int steps_a_goal = 30;
constexpr int steps_a_look = 10;  // for triangles that cross

enum class TearPlay { pull, press, twist, cut };
constexpr std::array<const char*, 4> tear_plays{"pull", "press", "twist", "cut"};

double log_uniform(std::mt19937_64& random, double low, double high) {
    return low * std::pow(high / low, uniform(random, 0.0, 1.0));
}

TearLaw random_law(std::mt19937_64& random) {
    TearLaw law{.strength_pa = log_uniform(random, 3e3, 3e5),
                .fracture_energy_j_m2 = log_uniform(random, 1.0, 164.0),
                .tear_factor = log_uniform(random, 0.3, 3.0),
                .bare_limit = uniform(random, 0.0, 1.0) < 0.25};
    const double stop = uniform(random, 0.0, 1.0);
    law.stop = stop < 0.8 ? TearStop::none : stop < 0.9 ? TearStop::entropy : TearStop::vertices;
    return law;
}

// One play on one body.
class TearTrial {
  public:
    // `touches`: the body's surfaces touch each other.
    TearTrial(TearPlay play, double speed_mm_per_s, bool touches, std::mt19937_64& random,
              BodyDescription body)
        : play_(play), speed_mm_per_s_(speed_mm_per_s), random_(random), body_(std::move(body)) {
        body_.tear = random_law(random);
        body_.tether_pa_per_mm2 = uniform(random, 0.0, 1.0) < 0.5 ? 20.0 : 0.0;
        body_.touchable = play == TearPlay::press;
        if (touches) body_.self.emplace();
        options_.model = uniform(random, 0.0, 1.0) < 0.6   ? ElementModel::corotated
                         : uniform(random, 0.0, 1.0) < 0.5 ? ElementModel::neohookean
                                                           : ElementModel::spring;
        extent_ = extent_of(body_);
    }

    // Rounding error of the forces' work along a step, whose terms are as large as modulus times
    // volume and nearly cancel. A body in many pieces handles only a few nanojoules, so this
    // matters.
    double rounding_nj() const {
        return std::numeric_limits<double>::epsilon() * body_.material.young_modulus_pa *
               volume_mm3(body_.mesh);
    }

    ExtremeRow run(int steps, const ExtremeRun& how) {
        ExtremeRow row;
        SplitCheck check(body_, options_);
        stepper_ = check.make_stepper();
        Trial trial(*stepper_, row, how, 0.0, rounding_nj() / Trial::ledger_tolerance);
        weaken_some();
        if (play_ == TearPlay::press) bring_tool();
        for (int k = 0; k < steps; ++k) {
            if (k % steps_a_goal == 0 && !begin_goal(trial, check)) break;
            lead();
            const StepReport report = stepper_->step(frame_s, how.stop);
            if (!trial.judge(report) || !holds(trial, check.after_step(*stepper_))) break;
            if (body_.self && k % steps_a_look == 0 && !look(trial)) break;
        }
        row.splits = check.splits();
        row.inverted_splits = check.with_inverted();
        row.touching_splits = check.with_touching_edges();
        return row;
    }

  private:
    // What contact keeps apart has not passed.
    bool look(Trial& trial) const {
        const int crossing =
            torn_crossings(stepper_->tearing()->topology(), body_, stepper_->positions_mm(),
                           stepper_->checkpoint().self->overlaps);
        return trial.require(crossing == 0, "triangles cross");
    }

    static bool holds(Trial& trial, const std::string& wrong) {
        return trial.require(wrong.empty(), wrong);
    }

    // A way of random direction, 1 to 20 mm long.
    Vec3 random_way() {
        const Vec3 direction = random_direction(random_);
        const double length_mm = uniform(random_, 1.0, 20.0);
        return length_mm * direction;
    }

    // Weakens some joints, as a cut line would.
    void weaken_some() {
        const auto joints = static_cast<int>(stepper_->tearing()->topology().joints().size());
        std::vector<int> some;
        for (int j = 0; j < joints; ++j)
            if (uniform(random_, 0.0, 1.0) < 0.03) some.push_back(j);
        stepper_->weaken(some, uniform(random_, 0.0, 0.5));
    }

    void bring_tool() {
        const char* const kind = uniform(random_, 0.0, 1.0) < 0.5 ? "sphere" : "capsule";
        stepper_->set_tool(random_tool(kind, body_, extent_, random_));
    }

    // Chooses a new goal and what is held on the way there; sometimes cuts, which is a transaction.
    bool begin_goal(Trial& trial, SplitCheck& check) {
        const Vec3 at = random_point(stepper_->positions_mm(), random_);
        const Vec3 direction = random_direction(random_);
        const double share = uniform(random_, 0.2, 1.0);
        goal_mm_ = at + share * extent_.reach_mm * direction;
        gone_mm_ = 0.0;
        axis_ = random_direction(random_);
        if (play_ == TearPlay::cut || uniform(random_, 0.0, 1.0) < 0.1) {
            const Vec3 way = random_way();
            const Vec3 edge = random_way();
            stepper_->cut(at - 0.5 * (way + edge), way, edge);
            if (!holds(trial, check.after_step(*stepper_))) return false;
        }
        close_hand(at);
        return true;
    }

    void close_hand(const Vec3& at) {
        held_.clear();
        from_mm_.clear();
        at_mm_ = at;
        const auto x = stepper_->positions_mm();
        for (std::size_t v = 0; v < x.size(); ++v)
            if ((x[v] - at).norm() < fist_radius_mm) {
                held_.push_back(static_cast<int>(v));
                from_mm_.push_back(x[v]);
            }
    }

    void lead() {
        gone_mm_ += speed_mm_per_s_ * frame_s;
        if (play_ == TearPlay::press) {
            const Vec3 way = goal_mm_ - stepper_->tool()->centre_mm();
            const double share =
                std::min(1.0, speed_mm_per_s_ * frame_s / std::max(way.norm(), 1e-9));
            stepper_->lead_tool(stepper_->tool()->centre_mm() + share * way);
            return;
        }
        const Vec3 way = goal_mm_ - at_mm_;
        const Vec3 moved = std::min(1.0, gone_mm_ / std::max(way.norm(), 1e-9)) * way;
        const double angle = play_ == TearPlay::twist ? gone_mm_ / fist_radius_mm : 0.0;
        const Eigen::AngleAxisd turn(angle, axis_);
        std::vector<Grab> grabs(held_.size());
        for (std::size_t i = 0; i < held_.size(); ++i) {
            grabs[i].vertices[0] = held_[i];
            const Vec3 arm = turn * Vec3(from_mm_[i] - at_mm_);
            grabs[i].target_mm = at_mm_ + arm + (play_ == TearPlay::twist ? 0.2 : 1.0) * moved;
            grabs[i].stiffness_un_per_mm = fist_un_per_mm / static_cast<double>(held_.size());
            grabs[i].force_limit_un = fist_limit_un / static_cast<double>(held_.size());
        }
        stepper_->set_grabs(grabs);
    }

    TearPlay play_;
    double speed_mm_per_s_;
    std::mt19937_64& random_;
    BodyDescription body_;
    StepperOptions options_;
    BodyExtent extent_;
    Vec3 goal_mm_ = Vec3::Zero(), at_mm_ = Vec3::Zero();
    Vec3 axis_ = Vec3::UnitZ();
    double gone_mm_ = 0.0;
    std::vector<int> held_;
    std::vector<Vec3> from_mm_;
    std::unique_ptr<Stepper> stepper_;
};

BodyDescription random_tree_body(std::mt19937_64& random, std::size_t tetrahedra) {
    Job job;
    return body_of(random_study_tree(random), static_cast<int>(tetrahedra), job);
}

}  // namespace

// Each trial has its own random numbers, so that a row can be run alone.
std::vector<ExtremeCase> tear_cases(const Campaign& campaign) {
    std::vector<ExtremeCase> cases;
    for (int t = 0; t < campaign.trials; ++t) {
        std::mt19937_64 random(campaign.seed * 2'000'003 + static_cast<std::uint64_t>(t));
        const std::size_t patients = std::max<std::size_t>(1, campaign.patients.size());
        const std::size_t turn = static_cast<std::size_t>(t) / patients;
        const auto play = static_cast<TearPlay>(turn % tear_plays.size());
        const bool touches = campaign.touching;
        const double speed = log_uniform(random, 10.0, 1e3);
        std::shared_ptr<const BodyDescription> patient;
        std::size_t tetrahedra = 0;
        if (campaign.patients.empty()) {
            tetrahedra =
                static_cast<std::size_t>(uniform(random, 0.15, 1.0) * campaign.most_tetrahedra);
        } else {
            patient = campaign.patients[static_cast<std::size_t>(t) % patients];
            tetrahedra = patient->mesh.tetrahedra.size();
        }
        char name[96];
        std::snprintf(name, sizeof name, "tear %d %s%s at %.3g mm/s, %zu tetrahedra", t,
                      tear_plays[static_cast<std::size_t>(play)], touches ? " touching" : "", speed,
                      tetrahedra);
        cases.push_back(
            {name, [=, steps = campaign.steps](const ExtremeRun& how) {
                 std::mt19937_64 own = random;  // a row may be run more than once
                 BodyDescription body = patient ? *patient : random_tree_body(own, tetrahedra);
                 return TearTrial(play, speed, touches, own, std::move(body)).run(steps, how);
             }});
    }
    return cases;
}

}  // namespace hepatica
