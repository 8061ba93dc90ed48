// SPDX-License-Identifier: GPL-3.0-or-later
// The energy to peel a double cantilever, by methods of fracture mechanics that know force, opening
// and length of the crack alone, and nothing of what the program says of its energies.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "core/base/frame_time.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/tear/tearing.h"
#include "tests/tear/bars.h"

namespace hepatica {
namespace {

using test::bar;
using test::spring;

constexpr double arm_mm = 2.0, width_mm = 1.0, length_mm = 24.0;

// As measured at the loaded end and along the crack.
struct PeelState {
    double force_un = 0.0;    // on each arm
    double opening_mm = 0.0;  // between the loaded ends
    double crack_mm = 0.0;    // from them to where the sides are apart by the critical opening
};

class Peel {
  public:
    explicit Peel(const TearLaw& law, const Index3& cells, double crack_mm)
        : body_(bar(Vec3(length_mm, 2.0 * arm_mm, width_mm), cells, law, 1e8)) {
        StepperOptions options;
        options.newton_iterations = 4;
        stepper_ = make_cpu_stepper(body_, options);
        std::vector<int> others;
        const auto joints = stepper_->tearing()->topology().joints();
        for (std::size_t j = 0; j < joints.size(); ++j)
            if (std::abs(joints[j].centre_mm.y() - arm_mm) > 1e-9)
                others.push_back(static_cast<int>(j));
        stepper_->weaken(others, 1e6);
        stepper_->cut(Vec3(-1, arm_mm, -1), Vec3(1.01 + crack_mm, 0, 0), Vec3(0, 0, 4));
        for (std::size_t v = 0; v < body_.mesh.vertices_mm.size(); ++v) {
            const Vec3& x = body_.mesh.vertices_mm[v];
            if (x.x() > 1e-9 || std::abs(x.y() - arm_mm) < arm_mm - 1e-9) continue;
            held_.push_back(static_cast<int>(v));
        }
    }

    // Leads the end of each arm this far from its place, and lets a step pass.
    PeelState open(double way_mm) {
        std::vector<Grab> grabs;
        for (const int v : held_) {
            const Vec3& x = body_.mesh.vertices_mm[v];
            const double y = x.y() > arm_mm ? way_mm : -way_mm;
            grabs.push_back(spring(v, x + Vec3(0, y, 0), 1.5e5));
        }
        stepper_->set_grabs(grabs);
        stepper_->step(frame_s);
        PeelState now;
        const auto x = stepper_->positions_mm();
        for (const Grab& grab : grabs) {
            const int v = grab.vertices[0];
            const double side = body_.mesh.vertices_mm[v].y() > arm_mm ? 1.0 : -1.0;
            now.force_un += 0.5 * side * grab.stiffness_un_per_mm * (grab.target_mm.y() - x[v].y());
            now.opening_mm += 2.0 * side * (x[v].y() - body_.mesh.vertices_mm[v].y()) /
                              static_cast<double>(held_.size());
        }
        now.crack_mm = crack_mm();
        return now;
    }

  private:
    // From the mean opening of the vertices that were one, between its stations along the bar.
    double crack_mm() const {
        const auto parents = stepper_->tearing()->topology().parents();
        const auto x = stepper_->positions_mm();
        std::map<double, std::pair<double, int>> open;  // sum and count at each station
        for (std::size_t v = body_.mesh.vertices_mm.size(); v < parents.size(); ++v) {
            int origin = static_cast<int>(v);
            while (parents[origin] != origin) origin = parents[origin];
            auto& [sum, count] = open[body_.mesh.vertices_mm[origin].x()];
            sum += std::abs(x[v].y() - x[parents[v]].y());
            ++count;
        }
        const double critical_mm = stepper_->tearing()->law().softening().opening_mm;
        double station = 0.0, gap = 0.0;
        for (const auto& [at, sum] : open) {
            const double here = sum.first / sum.second;
            if (here < critical_mm)
                return station + (at - station) * (gap - critical_mm) / (gap - here);
            station = at;
            gap = here;
        }
        return station;
    }

    BodyDescription body_;
    std::unique_ptr<Stepper> stepper_;
    std::vector<int> held_;
};

struct Line {
    double slope, offset;
};

Line line_through(const std::vector<std::pair<double, double>>& points) {
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    const auto n = static_cast<double>(points.size());
    for (const auto& [at, value] : points) {
        x += at / n;
        y += value / n;
    }
    for (const auto& [at, value] : points) {
        xx += (at - x) * (at - x);
        xy += (at - x) * (value - y);
    }
    return {xy / xx, y - xy / xx * x};
}

// Mean of F^2/(2 b) dC/da, with the compliance C = opening/force as the cube of a line in a, as
// that of beams with an elastic root is.
double energy_by_compliance_j_m2(const std::vector<PeelState>& states) {
    std::vector<std::pair<double, double>> roots;
    for (const PeelState& s : states)
        roots.emplace_back(s.crack_mm, std::cbrt(s.opening_mm / s.force_un));
    const auto [slope, offset] = line_through(roots);
    double sum = 0.0;
    for (const PeelState& s : states) {
        const double root = slope * s.crack_mm + offset;
        const double change_of_c = 3.0 * slope * root * root;
        sum += s.force_un * s.force_un / (2.0 * width_mm) * change_of_c;
    }
    return 1e-3 * sum / static_cast<double>(states.size());
}

// Work of the forces along the way less the growth of F opening/2, over the new area (Gurney and
// Hunt 1967).
double energy_by_area_j_m2(const std::vector<PeelState>& states) {
    double work = 0.0;
    for (std::size_t i = 1; i < states.size(); ++i)
        work += 0.5 * (states[i].force_un + states[i - 1].force_un) *
                (states[i].opening_mm - states[i - 1].opening_mm);
    const PeelState &first = states.front(), &last = states.back();
    const double stored =
        0.5 * (last.force_un * last.opening_mm - first.force_un * first.opening_mm);
    return 1e-3 * (work - stored) / (width_mm * (last.crack_mm - first.crack_mm));
}

// Twice as tough with the same critical opening, and slender enough: G below 7e-5 E h.
TEST(Peel, CostsTheFractureEnergyThatWasSet) {
    for (const double toughness : {5.0, 10.0}) {
        Peel peel({.strength_pa = 3e4 * toughness, .fracture_energy_j_m2 = toughness}, {48, 8, 2},
                  6.0);
        std::vector<PeelState> states;
        const double scale = std::sqrt(toughness / 10.0);
        for (int k = 1; k <= 290; ++k) {
            const PeelState now =
                peel.open(scale * (0.004 * std::min(k, 120) + 0.002 * std::max(k - 120, 0)));
            // The crack runs, and is far from the end of the bar.
            if (now.crack_mm > 6.5 && now.crack_mm < 0.5 * length_mm - 1.0) states.push_back(now);
        }
        ASSERT_GT(states.size(), 50u);
        EXPECT_GT(states.back().crack_mm - states.front().crack_mm, 3.5);
        EXPECT_NEAR(energy_by_compliance_j_m2(states), toughness, 0.05 * toughness);
        EXPECT_NEAR(energy_by_area_j_m2(states), toughness, 0.05 * toughness);
    }
}

}  // namespace
}  // namespace hepatica
