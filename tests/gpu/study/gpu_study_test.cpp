// SPDX-License-Identifier: GPL-3.0-or-later
// Counted traffic, and plans made of it.
#include "gpu/study/gpu_study.h"

#include <gtest/gtest.h>

#include <memory>

#include "core/base/error.h"
#include "gpu/machine/device_machine.h"
#include "gpu/machine/emulator.h"

namespace hepatica::gpu {
namespace {

TEST(PlannedSeconds, AreTheSumOfAllThatIsCounted) {
    const PlannedDevice device{"a device", 1e12, 1e10, ""};
    EXPECT_DOUBLE_EQ(planned_seconds({}, device), 0.0);
    const Traffic traffic{.launches = 10,
                          .barriers = 100,
                          .kernel_bytes = 2'000'000'000,
                          .copies = 3,
                          .copied_bytes = 50'000'000};
    EXPECT_DOUBLE_EQ(planned_seconds(traffic, device),
                     10 * launch_s + 100 * barrier_s + 2e-3 + 3 * copy_s + 5e-3);
}

TEST(PlannedDevice, HasASourceAndAName) {
    for (const PlannedDevice& device : planned_devices()) {
        EXPECT_FALSE(device.source.empty());
        EXPECT_EQ(planned_device(device.name).bytes_per_s, device.bytes_per_s);
    }
    EXPECT_THROW(planned_device("a potato"), InputError);
}

// A driver may name its device as it likes.
TEST(GpuStudy, TextIsWrittenAsJsonHasIt) {
    EXPECT_EQ(json_text("NVIDIA H100"), "\"NVIDIA H100\"");
    EXPECT_EQ(json_text("a \"b\" \\ \n\x01"), R"("a \"b\" \\ \u000a\u0001")");
}

// What was not allocated is not held.
TEST(Machine, HoldsNothingWhereAnAllocationFails) {
    const std::unique_ptr<Machine> machine = make_emulator();
// The sanitizers end the program at such an allocation.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    EXPECT_ANY_THROW(machine->allocate(std::size_t{1} << 60));
#endif
    EXPECT_EQ(machine->held_bytes(), 0u);
    void* const memory = machine->allocate(64);
    EXPECT_EQ(machine->held_bytes(), 64u);
    machine->release(memory, 64);
    EXPECT_EQ(machine->held_bytes(), 0u);
}

// The matrix alone is read once an iteration: nine floats and a column for each block.
TEST(GpuStudy, PlansWhatTheDeviceWouldDo) {
    GpuStudyOptions options;
    options.tetrahedra = {960};
    options.steps = 2;
    options.plan = planned_device("H200");
    const std::vector<GpuRow> rows = study_gpu(options);
    ASSERT_EQ(rows.size(), 2u);
    for (const GpuRow& row : rows) {
        EXPECT_EQ(row.tetrahedra, 960);
        EXPECT_EQ(row.device_steps, 1.0);
        EXPECT_FALSE(row.measured);
        EXPECT_FALSE(row.cpu_ms.has_value());
        EXPECT_DOUBLE_EQ(row.ms, 1e3 * planned_seconds(row.traffic, *options.plan));
        EXPECT_GT(static_cast<double>(row.traffic.kernel_bytes), row.iterations * 40.0 * 2500.0);
    }
    EXPECT_LT(rows[1].iterations, rows[0].iterations);
}

// With contacts there is one row more for each solver, of a body whose lower vertices touch: they
// and their friction are computed by kernels of their own, and cost bytes and launches.
TEST(GpuStudy, PlansContactBesideTheOthers) {
    GpuStudyOptions options;
    options.tetrahedra = {96};
    options.contacts = 100;
    options.solvers = {"skeleton"};
    options.steps = 2;
    options.plan = planned_device("H200");
    const std::vector<GpuRow> rows = study_gpu(options);
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].contacts, 0);
    EXPECT_EQ(rows[1].solver, "block-jacobi");
    EXPECT_EQ(rows[1].tetrahedra, 9 * 9 * 6);
    EXPECT_EQ(rows[1].contacts, 100);
    EXPECT_EQ(rows[1].device_steps, 1.0);
    EXPECT_FALSE(rows[1].measured);
    EXPECT_DOUBLE_EQ(rows[1].ms, 1e3 * planned_seconds(rows[1].traffic, *options.plan));
}

TEST(GpuStudy, MeasuresOnADeviceAlone) {
    GpuStudyOptions options;
    options.tetrahedra = {960};
    options.steps = 2;
    if (!device_info().reason.empty()) {
        EXPECT_THROW(study_gpu(options), InputError);
        return;
    }
    for (const GpuRow& row : study_gpu(options)) {
        EXPECT_TRUE(row.measured);
        EXPECT_GT(row.cpu_ms.value(), 0.0);
    }
}

}  // namespace
}  // namespace hepatica::gpu
