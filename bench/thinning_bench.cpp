// SPDX-License-Identifier: GPL-3.0-or-later
// Times of thinning, of the unit-width skeleton and of Betti numbers, on a volume of 512 x 512 x
// 300 voxels with 330,000 object voxels.
#include <benchmark/benchmark.h>

#include <random>

#include "core/skeleton/thinning.h"
#include "core/skeleton/topology.h"
#include "core/skeleton/unit_width_skeleton.h"

namespace {

using namespace hepatica;

double uniform(std::mt19937_64& random) {
    return static_cast<double>(random() >> 11) * 0x1.0p-53;
}

class Painter {
  public:
    explicit Painter(Mask& mask) : mask_(mask) {}

    void tube(const Vec3& from, const Vec3& to, double radius) {
        const double length = (to - from).norm();
        for (double t = 0.0; t <= length; t += 0.5) ball(from + (to - from) * (t / length), radius);
    }
    std::size_t painted() const { return painted_; }

  private:
    void ball(const Vec3& centre, double radius) {
        const int reach = static_cast<int>(radius) + 1;
        for (int dz = -reach; dz <= reach; ++dz)
            for (int dy = -reach; dy <= reach; ++dy)
                for (int dx = -reach; dx <= reach; ++dx) {
                    const int x = static_cast<int>(centre.x()) + dx;
                    const int y = static_cast<int>(centre.y()) + dy;
                    const int z = static_cast<int>(centre.z()) + dz;
                    if (!mask_.grid.contains(x, y, z)) continue;
                    if ((Vec3(x, y, z) - centre).norm() > radius || mask_.at(x, y, z) != 0)
                        continue;
                    mask_.at(x, y, z) = 1;
                    ++painted_;
                }
    }

    Mask& mask_;
    std::size_t painted_ = 0;
};

// Tubes that fork repeatedly, each child narrower, until the object voxels are used up.
Mask forking_tubes(std::size_t object_voxels) {
    Grid grid;
    grid.dims = {512, 512, 300};
    Mask mask(grid);
    Painter painter(mask);
    std::mt19937_64 random(1);
    std::vector<std::pair<Vec3, double>> tips{{Vec3(256, 256, 20), 9.0}};
    for (std::size_t i = 0; i < tips.size() && painter.painted() < object_voxels; ++i)
        for (int child = 0; child < 2; ++child) {
            const auto [from, radius] = tips[i];
            const Vec3 direction =
                Vec3(uniform(random) - 0.5, uniform(random) - 0.5, uniform(random) - 0.5)
                    .normalized();
            Vec3 to = from + direction * radius * 9.0;
            for (int a = 0; a < 3; ++a) to[a] = std::clamp(to[a], 20.0, grid.dims[a] - 20.0);
            painter.tube(from, to, radius);
            tips.emplace_back(to, 0.8 * radius);
        }
    return mask;
}

const Mask& volume() {
    static const Mask mask = forking_tubes(330'000);
    return mask;
}

void thinning(benchmark::State& state) {
    const auto method = state.range(0) == 0 ? ThinningMethod::queue : ThinningMethod::parallel;
    for (auto _ : state) {
        Job job;
        benchmark::DoNotOptimize(thin(volume(), method, job).voxels.data());
    }
    state.SetLabel(method == ThinningMethod::queue ? "queue" : "parallel templates");
}
BENCHMARK(thinning)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

void making_unit_width(benchmark::State& state) {
    Job job;
    const Mask skeleton = thin(volume(), ThinningMethod::queue, job);
    for (auto _ : state) benchmark::DoNotOptimize(unit_width(skeleton, job).voxels.data());
}
BENCHMARK(making_unit_width)->Unit(benchmark::kMillisecond);

void counting_betti_numbers(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(betti_numbers(volume()));
}
BENCHMARK(counting_betti_numbers)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
