// SPDX-License-Identifier: GPL-3.0-or-later
// bench gpu: the cost of a step on a CUDA device, measured or planned (gpu/study/gpu_study.h).
#include <memory>

#include "app/verbs/verbs.h"
#include "gpu/machine/device_machine.h"
#include "gpu/study/gpu_study.h"

namespace hepatica {

namespace {

struct BenchGpuChoices {
    gpu::GpuStudyOptions study;
    std::string plan;
};

Json run_bench_gpu(BenchGpuChoices options, Job& job) {
    Json answer = {{"device", gpu::device_info().device}};
    if (!options.plan.empty()) {
        options.study.plan = gpu::planned_device(options.plan);
        answer = {{"device", options.plan}, {"source", options.study.plan->source}};
    }
    Json rows = Json::array();
    study_gpu(options.study, [&](const gpu::GpuRow& row) {
        job.throw_if_cancelled();
        rows.push_back(Json::parse(json_of(row)));
    });
    answer["rows"] = rows;
    return answer;
}

}  // namespace

void add_bench_gpu(CommandLine& line) {
    const auto options = std::make_shared<BenchGpuChoices>();
    CLI::App& verb = line.add_verb(
        "bench", "Benchmarks", "gpu",
        "A step on the CUDA device of this computer, or planned for another from counted bytes",
        [options](Job& job) { return run_bench_gpu(*options, job); });
    std::vector<std::string> names;
    for (const gpu::PlannedDevice& device : gpu::planned_devices()) names.push_back(device.name);
    verb.add_option("--plan", options->plan, "Device to plan for; nothing is measured")
        ->check(CLI::IsMember(names));
    verb.add_option("--tetrahedra", options->study.tetrahedra, "Sizes of the bar")
        ->check(CLI::Range(96, 2'000'000))
        ->capture_default_str();
    verb.add_option(
            "--contacts", options->study.contacts,
            "Vertices of one body more, a slab that rests on a block with friction; 0: none")
        ->check(CLI::Range(0, 200'000))
        ->capture_default_str();
    verb.add_option("--element", options->study.elements, "Elements")
        ->check(CLI::IsMember({"spring", "corotated", "corotated-10", "neohookean"}))
        ->capture_default_str();
    verb.add_option("--solver", options->study.solvers, "Linear solvers")
        ->check(CLI::IsMember({"block-jacobi", "skeleton"}))
        ->capture_default_str();
    verb.add_option("--steps", options->study.steps, "Steps of 1/60 s")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
}

}  // namespace hepatica
