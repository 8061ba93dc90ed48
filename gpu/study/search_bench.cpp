// SPDX-License-Identifier: GPL-3.0-or-later
// search_bench [CONTACTS [THREADS [STEPS]]]: the host's work in a step with contacts on a device,
// for a slab that lies on a block and trembles. Prints the least milliseconds of each part, wall
// time and processor time.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <random>
#include <vector>

#include "core/base/parallel.h"
#include "core/deform/potentials/obstacle_contact.h"
#include "core/deform/potentials/potential_list.h"
#include "gpu/study/study_bodies.h"

namespace {

using namespace hepatica;

constexpr double dt_s = 1.0 / 60.0;
constexpr double trembles = 0.01;  // share of the pad per step

double wall_ms() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double, std::milli>(now).count();
}

// Processor time of all threads.
double processor_ms() {
    return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Part {
    const char* name;
    double wall_ms = 1e9, processor_ms = 1e9;

    void time(const std::function<void()>& work) {
        const double wall = ::wall_ms(), processor = ::processor_ms();
        work();
        wall_ms = std::min(wall_ms, ::wall_ms() - wall);
        processor_ms = std::min(processor_ms, ::processor_ms() - processor);
    }
};

class Tremor {
  public:
    explicit Tremor(double size_mm) : in_(-size_mm, size_mm) {}
    Vec3 operator()() { return {in_(random_), in_(random_), in_(random_)}; }

  private:
    std::mt19937 random_{1};
    std::uniform_real_distribution<double> in_;
};

void run(int contacts, int steps) {
    const Body body = build_body(gpu::slab_above_a_block(contacts), ElementModel::corotated,
                                 ElementOrder::linear);
    const PotentialList potentials(body);
    const double pad_mm = body.obstacle_pad.thickness_mm;
    BodyState state{body.rest_positions_mm,
                    std::vector<Vec3>(body.rest_positions_mm.size(), Vec3::Zero())};
    for (Vec3& x : state.positions_mm) x.z() -= (gpu::slab_clearance_pads - 0.99) * pad_mm;
    const std::vector<Vec3> lies = state.positions_mm;
    Tremor tremor(trembles * pad_mm);
    Part cut{"cut at a touch"}, grips{"grips of friction"}, lists{"both lists for the device"};
    Part shares{"free shares of both motions"}, report{"report"};
    std::size_t pairs = 0;
    int in_pad = 0;
    for (int k = 0; k <= steps; ++k) {
        std::vector<Vec3> ahead = state.positions_mm, end = lies;
        for (std::size_t i = 0; i < end.size(); ++i) {
            state.velocities_mm_per_s[i] = tremor() / dt_s;
            ahead[i] += dt_s * state.velocities_mm_per_s[i];
            end[i] += tremor();
        }
        const std::vector<Vec3>& x = state.positions_mm;
        cut.time([&] { potentials.share_until_touch(x, ahead); });
        grips.time([&] { potentials.begin_step(state, dt_s, body.fixed); });
        // In the order of a step: list, motion without a change of velocity, direction, list again.
        TouchList list, other;
        lists.time([&] {
            list = potentials.touches_along(x, ahead);
            other = potentials.touches_along(ahead, end);
        });
        shares.time([&] {
            potentials.free_share(x, ahead);
            potentials.free_share(ahead, end);
        });
        report.time([&] { in_pad = potentials.obstacle_load(end).touch.contacts; });
        potentials.end_step();
        pairs = list.pairs.size();
        state.positions_mm = end;
    }
    std::printf("%zu pairs listed, %d in the pad\n%-28s %9s %9s\n", pairs, in_pad, "", "wall ms",
                "processor");
    Part sum{"sum", 0.0, 0.0};
    for (const Part* part : {&cut, &grips, &lists, &shares, &report}) {
        std::printf("%-28s %9.2f %9.2f\n", part->name, part->wall_ms, part->processor_ms);
        sum.wall_ms += part->wall_ms;
        sum.processor_ms += part->processor_ms;
    }
    std::printf("%-28s %9.2f %9.2f\n", sum.name, sum.wall_ms, sum.processor_ms);
}

int argument(int argc, const char* const* argv, int which, int otherwise) {
    return which < argc ? std::max(1, std::atoi(argv[which])) : otherwise;
}

}  // namespace

int main(int argc, const char* const* argv) {
    const ThreadLimit limit(argument(argc, argv, 2, 2));
    run(argument(argc, argv, 1, 16384), argument(argc, argv, 3, 20));
}
