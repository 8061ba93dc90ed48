// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/recorded_figures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <system_error>

namespace hepatica::test {

namespace {

constexpr double relative_tolerance = 1e-6;

std::filesystem::path file_of(const std::string& room) {
    return std::filesystem::path(HEPATICA_SOURCE_DIR) / "tests" / room / "recorded_figures.txt";
}

// Values by "result.figure".
std::map<std::string, double> read(const std::string& room) {
    std::map<std::string, double> recorded;
    std::ifstream file(file_of(room));
    std::string name;
    for (double value = 0.0; file >> name >> value;) recorded[name] = value;
    return recorded;
}

void write(const std::string& room, const std::map<std::string, double>& recorded) {
    const std::filesystem::path path = file_of(room);
    const std::filesystem::path temporary = path.string() + ".new";
    {
        std::ofstream file(temporary);
        for (const auto& [name, value] : recorded) {
            char line[200];
            std::snprintf(line, sizeof(line), "%s %.10g\n", name.c_str(), value);
            file << line;
        }
    }
    std::filesystem::rename(temporary, path);
}

bool is_of(const std::string& name, const std::string& result) {
    return name.starts_with(result + ".");
}

// The command that records the figures of the running test.
std::string how_to_record_figures() {
    std::error_code ignored;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", ignored);
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    return "HEPATICA_UPDATE_BASELINES=1 " + program.string() +
           " --gtest_filter=" + test->test_suite_name() + "." + test->name();
}

}  // namespace

Figures& Figures::add(const std::string& name, double value) {
    figures_.push_back({name, value, 1e-300});
    return *this;
}

Figures& Figures::add(const std::string& name, std::span<const double> values) {
    std::mt19937 chance;  // the same weights everywhere: the standard fixes what it draws
    double squares = 0.0;
    double weighted = 0.0;
    for (const double value : values) {
        squares += value * value;
        weighted += value * (2.0 * static_cast<double>(chance()) / std::mt19937::max() - 1.0);
    }
    const double norm = std::sqrt(squares);
    add(name + ".count", static_cast<double>(values.size()));
    add(name + ".norm", norm);
    figures_.push_back({name + ".weighted", weighted, norm});
    return *this;
}

Figures& Figures::add(const std::string& name, std::span<const std::uint8_t> values) {
    const std::vector<double> numbers(values.begin(), values.end());
    return add(name, std::span<const double>(numbers));
}

void expect_recorded(const std::string& room, const std::string& result, const Figures& figures) {
    std::map<std::string, double> recorded = read(room);
    if (std::getenv("HEPATICA_UPDATE_BASELINES")) {
        std::erase_if(recorded, [&](const auto& entry) { return is_of(entry.first, result); });
        for (const Figures::Figure& figure : figures.all())
            recorded[result + "." + figure.name] = figure.value;
        return write(room, recorded);
    }
    for (const Figures::Figure& figure : figures.all()) {
        EXPECT_EQ(figure.name.find(' '), std::string::npos) << figure.name << " has a blank";
        const auto found = recorded.find(result + "." + figure.name);
        if (found == recorded.end()) {
            ADD_FAILURE() << file_of(room) << " does not hold " << result << "." << figure.name
                          << "; record it by " << how_to_record_figures();
            continue;
        }
        const double tolerance =
            relative_tolerance * std::max({std::abs(found->second), figure.scale, 1e-300});
        // Written so that what is no number fails, too.
        const bool same =
            std::abs(figure.value - found->second) <= tolerance || figure.value == found->second;
        EXPECT_TRUE(same) << found->first << " was " << found->second << " and is " << figure.value
                          << (result == "initial"
                                  ? ". Its defaults or the places of its members changed"
                                  : "")
                          << ". If that is meant, say why and record it by "
                          << how_to_record_figures();
        recorded.erase(found);
    }
    for (const auto& [name, value] : recorded)
        if (is_of(name, result)) ADD_FAILURE() << name << " is recorded, but no longer computed";
}

}  // namespace hepatica::test
