// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/study/gpu_study.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "core/deform/body/element_name.h"
#include "core/deform/stepper/cpu_back_end.h"
#include "gpu/cuda_back_end.h"
#include "gpu/machine/array.h"
#include "gpu/machine/device_machine.h"
#include "gpu/machine/emulator.h"
#include "gpu/study/study_bodies.h"

namespace hepatica::gpu {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double dt_s = 1.0 / 60.0;
constexpr int warm_up_steps = 20;
constexpr int least_steps = 3;    // least steps on the processor, which may take seconds each,
constexpr double most_s = 15.0;   // and about the most seconds for all
constexpr double pressed = 0.01;  // overlap of a slab resting on a block, as a share of the pad

StepperOptions options_of(const std::string& element, const std::string& solver) {
    StepperOptions options;
    std::tie(options.model, options.order) = element_of(element);
    options.solver = linear_solver_kind(solver);
    return options;
}

void rest_on_block(StepBackEnd& back_end) {
    const double pad_mm = back_end.body().obstacle_pad.thickness_mm;
    BodyState state = back_end.state();
    for (Vec3& x : state.positions_mm) x.z() -= (slab_clearance_pads - 1.0 + pressed) * pad_mm;
    back_end.set_state(state);
}

void begin(StepBackEnd& back_end, const BodyDescription& body) {
    back_end.set_gravity({0.0, 0.0, -9810.0});
    if (body.obstacles) return rest_on_block(back_end);
    Grab pull;
    pull.vertices[0] = static_cast<int>(body.mesh.vertices_mm.size()) - 1;
    pull.target_mm = body.mesh.vertices_mm.back() + Vec3(0.0, 5.0, 5.0);
    pull.stiffness_un_per_mm = 5e4;
    pull.force_limit_un = 2e5;
    back_end.set_grabs({&pull, 1});
}

struct Timed {
    double ms = 0.0;  // median over the steps
    double slowest_ms = 0.0;
    double iterations = 0.0;  // mean over the steps made
    int contacts = 0;         // at the end
};

// Makes as many steps as asked for, or at least `least_steps` until the time is over.
Timed time_steps(StepBackEnd& back_end, int steps, Clock::time_point over) {
    Timed timed;
    std::vector<double> ms;
    for (int k = 0; k < steps && (k < least_steps || Clock::now() < over); ++k) {
        const auto start = Clock::now();
        const StepReport report = back_end.advance(dt_s);
        ms.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
        timed.iterations += report.linear_iterations;
        timed.contacts = report.obstacles.touch.contacts;
    }
    timed.iterations /= static_cast<double>(ms.size());
    std::ranges::sort(ms);
    timed.ms = ms[ms.size() / 2];
    timed.slowest_ms = ms.back();
    return timed;
}

// Steps past the first shock of gravity and pull, because a bar that begins to fall takes shortened
// steps, which the processor makes on either back end. Stops when the time is over.
void warm_up(StepBackEnd& back_end, Clock::time_point over) {
    for (int k = 0; k < warm_up_steps && Clock::now() < over; ++k) back_end.advance(dt_s);
}

Clock::time_point processor_ends() {
    return Clock::now() +
           std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(most_s));
}

Traffic mean(const Traffic& before, const Traffic& after, int steps) {
    const auto bytes = static_cast<std::size_t>(steps);
    return {(after.launches - before.launches) / steps, (after.barriers - before.barriers) / steps,
            (after.kernel_bytes - before.kernel_bytes) / bytes,
            (after.copies - before.copies) / steps,
            (after.copied_bytes - before.copied_bytes) / bytes};
}

// Bytes per second of a plain kernel that reads two long arrays and writes one, on the device.
double measured_bandwidth(Machine& machine) {
    constexpr std::size_t entries = 1 << 23;
    constexpr int rounds = 20;
    const Array<Vector3<double>> from(machine, entries), to(machine, entries);
    const Subtract kernel{to.view(), from.read()};
    double last = 0.0;
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
              const std::shared_ptr<Machine>& machine, const std::optional<PlannedDevice>& plan,
              double bandwidth) {
    CudaOptions cuda;
    const auto back_end = make_cuda_back_end(body, options, machine, cuda);
    begin(*back_end, body);
    warm_up(*back_end, Clock::time_point::max());  // the first step allocates
    const Traffic before = machine->traffic();
    *cuda.share = {};
    const Timed timed = time_steps(*back_end, steps, Clock::time_point::max());
    GpuRow row;
    row.measured = !plan;
    row.traffic = mean(before, machine->traffic(), steps);
    row.iterations = timed.iterations;
    row.contacts = timed.contacts;
    const SolveCost& solves = cuda.share->solves;
    if (row.measured && cuda.share->device > 0) {
        row.solve_ms = 1e3 * solves.seconds / static_cast<double>(cuda.share->device);
        row.bandwidth_share = static_cast<double>(solves.kernel_bytes) / solves.seconds / bandwidth;
    }
    row.device_steps = static_cast<double>(cuda.share->device) / steps;
    row.slowest_ms = timed.slowest_ms;
    row.ms = plan ? 1e3 * planned_seconds(row.traffic, *plan) : timed.ms;
    return row;
}

std::string number_or_null(const std::optional<double>& value) {
    return value ? std::to_string(*value) : "null";
}

// A slab has no tree for a skeleton to follow.
std::vector<std::string> solvers_for(const BodyDescription& body, const GpuStudyOptions& options) {
    return body.obstacles ? std::vector<std::string>{"block-jacobi"} : options.solvers;
}

}  // namespace

std::vector<GpuRow> study_gpu(const GpuStudyOptions& options,
                              const std::function<void(const GpuRow&)>& row_done) {
    const std::shared_ptr<Machine> machine = options.plan ? make_emulator() : make_device_machine();
    const double bandwidth = options.plan ? 0.0 : measured_bandwidth(*machine);
    std::vector<BodyDescription> bodies;
    for (const int tetrahedra : options.tetrahedra) bodies.push_back(slender_bar(tetrahedra));
    if (options.contacts > 0) bodies.push_back(slab_above_a_block(options.contacts));
    std::vector<GpuRow> rows;
    for (const BodyDescription& body : bodies)
        for (const std::string& element : options.elements)
            for (const std::string& solver : solvers_for(body, options)) {
                const StepperOptions stepper = options_of(element, solver);
                GpuRow row = row_of(body, stepper, options.steps, machine, options.plan, bandwidth);
                row.tetrahedra = static_cast<int>(body.mesh.tetrahedra.size());
                row.element = element;
                row.solver = solver;
                if (row.measured) {
                    const auto cpu = make_cpu_back_end(body, options_of(element, "automatic"));
                    begin(*cpu, body);
                    const auto over = processor_ends();
                    warm_up(*cpu, over);
                    row.cpu_ms = time_steps(*cpu, options.steps, over).ms;
                }
                rows.push_back(row);
                if (row_done) row_done(row);
            }
    return rows;
}

std::string json_text(const std::string& text) {
    std::string quoted = "\"";
    for (const char letter : text) {
        char code[16] = "";
        if (letter == '"' || letter == '\\') quoted += '\\';
        const bool control = static_cast<unsigned char>(letter) < 0x20;
        if (control) std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned>(letter));
        quoted += control ? std::string(code) : std::string(1, letter);
    }
    return quoted + "\"";
}

std::string json_of(const GpuRow& row) {
    const std::optional<double> ratio =
        row.cpu_ms ? std::optional(*row.cpu_ms / row.ms) : std::nullopt;
    const std::optional<double> slowest =
        row.measured ? std::optional(row.slowest_ms) : std::nullopt;
    return "{\"tetrahedra\": " + std::to_string(row.tetrahedra) +
           ", \"contacts\": " + std::to_string(row.contacts) +
           ", \"contact_rows\": " + std::to_string(rows_per_contact * row.contacts) +
           ", \"element\": \"" + row.element + "\", \"solver\": \"" + row.solver +
           "\", \"ms\": " + std::to_string(row.ms) +
           ", \"slowest_ms\": " + number_or_null(slowest) +
           ", \"iterations\": " + std::to_string(row.iterations) +
           ", \"bytes\": " + std::to_string(row.traffic.kernel_bytes) +
           ", \"solve_ms\": " + number_or_null(row.solve_ms) +
           ", \"bandwidth_share\": " + number_or_null(row.bandwidth_share) +
           ", \"launches\": " + std::to_string(row.traffic.launches) +
           ", \"barriers\": " + std::to_string(row.traffic.barriers) +
           ", \"copies\": " + std::to_string(row.traffic.copies) +
           ", \"copied_bytes\": " + std::to_string(row.traffic.copied_bytes) +
           ", \"device_steps\": " + std::to_string(row.device_steps) +
           ", \"cpu_ms\": " + number_or_null(row.cpu_ms) +
           ", \"cpu_ratio\": " + number_or_null(ratio) +
           ", \"measured\": " + (row.measured ? "true" : "false") + "}";
}

}  // namespace hepatica::gpu
