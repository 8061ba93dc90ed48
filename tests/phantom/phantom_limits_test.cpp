// SPDX-License-Identifier: GPL-3.0-or-later
// Options of phantoms at the ends of their ranges: the end is taken, what lies beyond is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <functional>

#include "core/base/error.h"
#include "core/phantom/phantom.h"

namespace hepatica {
namespace {

// The second stage begins only where the options were taken; the cancel then ends the work.
bool taken(const std::function<void(PhantomOptions&)>& change) {
    PhantomOptions options;
    options.generations = 1;
    options.dims = {16, 16, 16};
    options.spacing_mm = {9.0, 9.0, 9.0};
    change(options);
    Job job;
    job.cancel();
    try {
        make_phantom(options, job);
    } catch (const Cancelled&) {
        return true;
    } catch (const InputError& error) {
        EXPECT_THAT(std::string(error.remedy()),
                    testing::AnyOf(testing::HasSubstr("from"), testing::HasSubstr("--systems 2")));
        return false;
    }
    ADD_FAILURE() << "a cancelled job went on";
    return true;
}

void expect_whole_range(const char* what, int low, int high,
                        const std::function<void(PhantomOptions&, int)>& set) {
    const auto with = [&](int value) {
        return taken([&](PhantomOptions& options) { set(options, value); });
    };
    EXPECT_TRUE(with(low) && with(high)) << what;
    EXPECT_FALSE(with(low - 1)) << what;
    EXPECT_FALSE(with(high + 1)) << what;
}

void expect_real_range(const char* what, double low, double high,
                       const std::function<void(PhantomOptions&, double)>& set) {
    const auto with = [&](double value) {
        return taken([&](PhantomOptions& options) { set(options, value); });
    };
    EXPECT_TRUE(with(low) && with(high)) << what;
    EXPECT_FALSE(with(std::nextafter(low, -HUGE_VAL))) << what;
    EXPECT_FALSE(with(std::nextafter(high, HUGE_VAL))) << what;
    EXPECT_FALSE(with(std::nan(""))) << what;
}

TEST(PhantomLimits, OfWholeNumbers) {
    expect_whole_range("generations", 1, 10, [](PhantomOptions& o, int v) { o.generations = v; });
    expect_whole_range("systems", 1, 2, [](PhantomOptions& o, int v) { o.systems = v; });
    expect_whole_range("touching", 0, 20, [](PhantomOptions& o, int v) {
        o.systems = 2;
        o.touching = v;
    });
    for (int axis = 0; axis < 3; ++axis)
        expect_whole_range("dims", 16, 2048,
                           [axis](PhantomOptions& o, int v) { o.dims[axis] = v; });
    EXPECT_FALSE(taken([](PhantomOptions& o) { o.touching = 1; }));
}

TEST(PhantomLimits, OfMeasures) {
    for (int axis = 0; axis < 3; ++axis)
        expect_real_range("spacing", 0.1, 10.0,
                          [axis](PhantomOptions& o, double v) { o.spacing_mm[axis] = v; });
    expect_real_range("root", 1.0, 12.0, [](PhantomOptions& o, double v) { o.root_radius_mm = v; });
    expect_real_range("Murray", 2.0, 4.0,
                      [](PhantomOptions& o, double v) { o.murray_exponent = v; });
    expect_real_range("parenchyma", -100.0, 300.0,
                      [](PhantomOptions& o, double v) { o.parenchyma_hu = v; });
    expect_real_range("contrast", 0.0, 1000.0,
                      [](PhantomOptions& o, double v) { o.contrast_hu = v; });
    expect_real_range("hepatic contrast", 0.0, 1000.0,
                      [](PhantomOptions& o, double v) { o.hepatic_contrast_hu = v; });
    expect_real_range("noise", 0.0, 500.0, [](PhantomOptions& o, double v) { o.noise_hu = v; });
    expect_real_range("point spread", 0.0, 5.0,
                      [](PhantomOptions& o, double v) { o.point_spread_sigma_mm = v; });
}

TEST(PhantomLimits, AreSaidInWords) {
    PhantomOptions options;
    options.noise_hu = -1.5;
    Job job;
    try {
        make_phantom(options, job);
        FAIL() << "taken";
    } catch (const InputError& error) {
        EXPECT_EQ(error.problem(), "-1.5 cannot be used");
        EXPECT_EQ(error.place(), "--noise-hu");
        EXPECT_EQ(error.remedy(), "Choose a value from 0 to 500");
    }
}

TEST(PhantomLimits, ThreeStagesAreBegun) {
    PhantomOptions options;
    options.generations = 2;
    options.dims = {24, 24, 24};
    options.spacing_mm = {8.0, 8.0, 8.0};
    Job job;
    make_phantom(options, job);
    EXPECT_EQ(job.stage_times().size(), 3u);
    EXPECT_EQ(job.stage_times().front().name, "Growing the vessels");
}

// 8.6 thousand million voxels, within the range of each axis: refused before any is allocated.
TEST(PhantomLimits, AGridBeyondTheMemoryIsRefused) {
    PhantomOptions options;
    options.generations = 1;
    options.dims = {2048, 2048, 2048};
    const double memory =
        static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
    if (memory > 8e10) GTEST_SKIP() << "it would fit";
    Job job;
    job.cancel();
    try {
        make_phantom(options, job);
        FAIL() << "it was made";
    } catch (const InputError& error) {
        EXPECT_EQ(error.place(), "--dims");
        EXPECT_THAT(error.problem(), testing::HasSubstr("of memory"));
    }
}

}  // namespace
}  // namespace hepatica
