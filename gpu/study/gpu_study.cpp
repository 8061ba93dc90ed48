// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/study/gpu_study.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/deform/body/element_name.h"
#include "core/deform/stepper/cpu_back_end.h"
#include "gpu/cuda_back_end.h"
#include "gpu/machine/array.h"
#include "gpu/machine/device_machine.h"
#include "gpu/machine/emulator.h"

namespace hepatica::gpu {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double dt_s = 1.0 / 60.0, cell_mm = 1.5;
constexpr int across = 4, per_cell = 6;

StepperOptions options_of(const std::string& element, const std::string& solver) {
    StepperOptions options;
    std::tie(options.model, options.order) = element_of(element);
    options.solver = linear_solver_kind(solver);
    return options;
}

void begin(StepBackEnd& back_end, const BodyDescription& body) {
    back_end.set_gravity({0.0, 0.0, -9810.0});
    Grab pull;
    pull.vertices[0] = static_cast<int>(body.mesh.vertices_mm.size()) - 1;
    pull.target_mm = body.mesh.vertices_mm.back() + Vec3(0.0, 5.0, 5.0);
    pull.stiffness_un_per_mm = 5e4;
    pull.force_limit_un = 2e5;
    back_end.set_grabs({&pull, 1});
}

// Mean wall time of a step [ms], and the mean of its iterations.
std::pair<double, double> time_steps(StepBackEnd& back_end, int steps) {
    double iterations = 0.0;
    const auto start = Clock::now();
    for (int k = 0; k < steps; ++k) iterations += back_end.advance(dt_s).linear_iterations;
    const std::chrono::duration<double, std::milli> wall = Clock::now() - start;
    return {wall.count() / steps, iterations / steps};
}

Traffic mean(const Traffic& before, const Traffic& after, int steps) {
    const auto bytes = static_cast<std::size_t>(steps);
    return {(after.launches - before.launches) / steps, (after.barriers - before.barriers) / steps,
            (after.kernel_bytes - before.kernel_bytes) / bytes,
            (after.copies - before.copies) / steps,
            (after.copied_bytes - before.copied_bytes) / bytes};
}

// Bytes a second of a plain kernel that reads and writes two long arrays, on the device.
double measured_bandwidth(Machine& machine) {
    constexpr std::size_t entries = 1 << 24;
    constexpr int rounds = 20;
    const Array<Vector3<float>> from(machine, entries), to(machine, entries);
    const Subtract<float> kernel{to.view(), from.read()};
    float last = 0.0f;
    const auto wait = [&] { machine.download(&last, to.read().data, sizeof last); };
    machine.for_each(kernel);
    wait();
    const auto start = Clock::now();
    for (int k = 0; k < rounds; ++k) machine.for_each(kernel);
    wait();
    const std::chrono::duration<double> wall = Clock::now() - start;
    return rounds * static_cast<double>(kernel.bytes()) / wall.count();
}

GpuRow row_of(const BodyDescription& body, const StepperOptions& options, int steps,
              const std::shared_ptr<Machine>& machine, const std::optional<PlannedDevice>& plan) {
    CudaOptions cuda;
    const auto back_end = make_cuda_back_end(body, options, machine, cuda);
    begin(*back_end, body);
    back_end->advance(dt_s);  // the first allocates
    const Traffic before = machine->traffic();
    *cuda.share = {};
    const auto [wall_ms, iterations] = time_steps(*back_end, steps);
    GpuRow row;
    row.traffic = mean(before, machine->traffic(), steps);
    row.iterations = iterations;
    row.device_steps = static_cast<double>(cuda.share->device) / steps;
    row.measured = !plan;
    row.ms = plan ? 1e3 * planned_seconds(row.traffic, *plan) : wall_ms;
    return row;
}

}  // namespace

BodyDescription slender_bar(int tetrahedra) {
    const int slice = per_cell * across * across;
    const int along = std::max(1, (tetrahedra + slice - 1) / slice);
    constexpr int side = across + 1;
    BodyDescription body;
    for (int i = 0; i <= along; ++i)
        for (int j = 0; j < side; ++j)
            for (int k = 0; k < side; ++k) {
                body.mesh.vertices_mm.push_back(cell_mm * Vec3(i, j, k));
                body.fixed.push_back(i == 0 ? 1 : 0);
            }
    // Kuhn's six tetrahedra follow the paths along three edges from one corner to the opposite.
    constexpr int step[3] = {side * side, side, 1};
    constexpr int paths[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    for (int i = 0; i < along; ++i)
        for (int j = 0; j < across; ++j)
            for (int k = 0; k < across; ++k)
                for (int p = 0; p < per_cell; ++p) {
                    const int a = i * step[0] + j * step[1] + k;
                    const int b = a + step[paths[p][0]], c = b + step[paths[p][1]];
                    const int d = c + step[paths[p][2]];
                    // The second three are mirror images.
                    body.mesh.tetrahedra.push_back(p < 3 ? std::array{a, b, c, d}
                                                         : std::array{a, c, b, d});
                }
    return body;
}

std::vector<GpuRow> study_gpu(const GpuStudyOptions& options,
                              const std::function<void(const GpuRow&)>& row_done) {
    const std::shared_ptr<Machine> machine = options.plan ? make_emulator() : make_device_machine();
    const double bandwidth = options.plan ? 0.0 : measured_bandwidth(*machine);
    std::vector<GpuRow> rows;
    for (const int tetrahedra : options.tetrahedra)
        for (const std::string& element : options.elements)
            for (const std::string& solver : options.solvers) {
                const BodyDescription body = slender_bar(tetrahedra);
                const StepperOptions stepper = options_of(element, solver);
                GpuRow row = row_of(body, stepper, options.steps, machine, options.plan);
                row.tetrahedra = static_cast<int>(body.mesh.tetrahedra.size());
                row.element = element;
                row.solver = solver;
                if (row.measured) {
                    row.bandwidth_share =
                        static_cast<double>(row.traffic.kernel_bytes) / (1e-3 * row.ms) / bandwidth;
                    const auto cpu = make_cpu_back_end(body, options_of(element, "automatic"));
                    begin(*cpu, body);
                    cpu->advance(dt_s);
                    row.cpu_ms = time_steps(*cpu, options.steps).first;
                }
                rows.push_back(row);
                if (row_done) row_done(row);
            }
    return rows;
}

}  // namespace hepatica::gpu
