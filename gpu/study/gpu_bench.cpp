// SPDX-License-Identifier: GPL-3.0-or-later
// gpu_bench TABLE.json [DEVICE] [TETRAHEDRA ...]: the rows of `hepatica-cli bench gpu` where only
// the solver is built. Prints a table and writes the same rows as JSON to the file, which is
// complete after every row. With a device's name the rows are planned for it, otherwise measured on
// the device of this computer. With sizes the bars have these, and there is no slab.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "gpu/machine/device_machine.h"
#include "gpu/study/gpu_study.h"

namespace {

using hepatica::gpu::GpuRow;

// Writes another file and renames it. False where that fails.
bool write_table(const std::string& path, const std::string& device, const std::string& rows) {
    const std::string unfinished = path + ".part";
    std::ofstream file(unfinished);
    file << "{\"device\": " << hepatica::gpu::json_text(device) << ", \"rows\": [\n"
         << rows << "\n]}\n";
    file.close();
    std::error_code error;
    if (file) std::filesystem::rename(unfinished, path, error);
    return file && !error;
}

int run(int argc, const char* const* argv) {
    hepatica::gpu::GpuStudyOptions options;
    options.tetrahedra = {10000, 50000, 200000, 1000000};
    options.contacts = 16384;
    options.solvers = {"skeleton"};
    std::string device = hepatica::gpu::device_info().device;
    std::vector<int> sizes;
    for (int k = 2; k < argc; ++k)
        if (const int size = std::atoi(argv[k]); size > 0) {
            sizes.push_back(size);
        } else {
            options.plan = hepatica::gpu::planned_device(argv[k]);
            options.tetrahedra = {10000};
            device = options.plan->name + " (planned)";
        }
    if (!sizes.empty()) {
        options.tetrahedra = sizes;
        options.contacts = 0;
    }
    std::printf("%s\n%10s %8s %-10s %-12s %9s %6s %9s %9s\n", device.c_str(), "tetrahedra",
                "contacts", "element", "solver", "ms", "iter.", "launches", "cpu ms");
    std::string rows;
    bool written = true;
    study_gpu(options, [&](const GpuRow& row) {
        std::printf("%10d %8d %-10s %-12s %9.3f %6.0f %9ld %9s\n", row.tetrahedra, row.contacts,
                    row.element.c_str(), row.solver.c_str(), row.ms, row.iterations,
                    row.traffic.launches, (row.cpu_ms ? std::to_string(*row.cpu_ms) : "-").c_str());
        std::fflush(stdout);
        rows += (rows.empty() ? "  " : ",\n  ") + json_of(row);
        written = write_table(argv[1], device, rows);
    });
    if (!written)
        std::fprintf(stderr, "%s: cannot be written; name a file in a folder that can\n", argv[1]);
    return written ? 0 : 1;
}

}  // namespace

int main(int argc, const char* const* argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: gpu_bench TABLE.json [DEVICE TO PLAN FOR] [TETRAHEDRA ...]\n");
        return 2;
    }
    try {
        return run(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
