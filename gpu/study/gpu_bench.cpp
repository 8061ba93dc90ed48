// SPDX-License-Identifier: GPL-3.0-or-later
// gpu_bench TABLE.json [DEVICE]: the rows of `hepatica-cli bench gpu` where only the solver is
// built: a table on standard output, the same rows as JSON in the file. With the name of a device
// the rows are planned for it, otherwise measured on the device of this computer.
#include <cstdio>
#include <fstream>

#include "core/base/error.h"
#include "gpu/machine/device_machine.h"
#include "gpu/study/gpu_study.h"

namespace {

using hepatica::gpu::GpuRow;

std::string number_or_null(const std::optional<double>& value) {
    return value ? std::to_string(*value) : "null";
}

std::string json_of(const GpuRow& row) {
    const std::optional<double> ratio =
        row.cpu_ms ? std::optional(*row.cpu_ms / row.ms) : std::nullopt;
    return "{\"tetrahedra\": " + std::to_string(row.tetrahedra) +
           ", \"contacts\": " + std::to_string(row.contacts) +
           ", \"contact_rows\": " + std::to_string(hepatica::gpu::rows_per_contact * row.contacts) +
           ", \"element\": \"" + row.element + "\", \"solver\": \"" + row.solver +
           "\", \"ms\": " + std::to_string(row.ms) +
           ", \"iterations\": " + std::to_string(row.iterations) +
           ", \"bytes\": " + std::to_string(row.traffic.kernel_bytes) +
           ", \"bandwidth_share\": " + number_or_null(row.bandwidth_share) +
           ", \"launches\": " + std::to_string(row.traffic.launches) +
           ", \"cpu_ms\": " + number_or_null(row.cpu_ms) +
           ", \"cpu_ratio\": " + number_or_null(ratio) +
           ", \"measured\": " + (row.measured ? "true" : "false") + "}";
}

int run(int argc, const char* const* argv) {
    hepatica::gpu::GpuStudyOptions options;
    options.tetrahedra = {10000, 50000, 200000};
    options.contacts = 16384;
    options.solvers = {"skeleton"};
    std::string device = hepatica::gpu::device_info().device;
    if (argc == 3) {
        options.plan = hepatica::gpu::planned_device(argv[2]);
        options.tetrahedra = {10000};
        device = options.plan->name + " (planned)";
    }
    std::printf("%s\n%10s %8s %-10s %-12s %9s %6s %9s %9s\n", device.c_str(), "tetrahedra",
                "contacts", "element", "solver", "ms", "iter.", "launches", "cpu ms");
    std::string rows;
    study_gpu(options, [&](const GpuRow& row) {
        std::printf("%10d %8d %-10s %-12s %9.3f %6.0f %9ld %9s\n", row.tetrahedra, row.contacts,
                    row.element.c_str(), row.solver.c_str(), row.ms, row.iterations,
                    row.traffic.launches, number_or_null(row.cpu_ms).c_str());
        std::fflush(stdout);
        rows += (rows.empty() ? "  " : ",\n  ") + json_of(row);
    });
    std::ofstream file(argv[1]);
    file << "{\"device\": \"" << device << "\", \"rows\": [\n" << rows << "\n]}\n";
    return file ? 0 : 1;
}

}  // namespace

int main(int argc, const char* const* argv) {
    if (argc < 2 || argc > 3) {
        std::fprintf(stderr, "usage: gpu_bench TABLE.json [DEVICE TO PLAN FOR]\n");
        return 2;
    }
    try {
        return run(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
