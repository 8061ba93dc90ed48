// SPDX-License-Identifier: GPL-3.0-or-later
// Timers and quantiles of repeated work, for the benchmarks.
#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>
#include <sstream>
#include <string>
#include <vector>

namespace hepatica {

// Time of a frame. Only processor time, of all threads of this program, does not grow while other
// programs use the cores.
struct FrameTime {
    double wall_ms = 0.0;
    double processor_ms = 0.0;

    // Processor time is less than wall time only where other programs made the frame wait.
    double cost_ms() const { return std::min(wall_ms, processor_ms); }
};

// Starts when it is constructed.
class FrameTimer {
  public:
    FrameTime passed() const {
        const std::chrono::duration<double, std::milli> wall =
            std::chrono::steady_clock::now() - start_;
        const auto processor = static_cast<double>(std::clock() - processor_start_);
        return {wall.count(), 1e3 * processor / CLOCKS_PER_SEC};
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::clock_t processor_start_ = std::clock();
};

// Wall time of one call.
template <class Work>
double timed_ms(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

// Wall time since it was constructed, of a budget.
class BudgetClock {
  public:
    explicit BudgetClock(double budget_s) : budget_s_(budget_s) {}
    double passed_s() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }
    double left_s() const { return budget_s_ - passed_s(); }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    double budget_s_;
};

// With two significant digits, as "1.2 s".
inline std::string seconds_text(double seconds) {
    std::ostringstream text;
    text.precision(2);
    text << seconds << " s";
    return text.str();
}

// Why work of that long is left out; empty where there is time for it. Nothing that is left to do
// needs no time, whatever the clock says.
inline std::string why_no_time(double needed_s, double left_s) {
    if (!(needed_s > 0.0) || needed_s <= left_s) return {};
    return "needs " + seconds_text(needed_s) + " more, " + seconds_text(std::max(0.0, left_s)) +
           " were left";
}

// The quantile at `share` in [0, 1], rounded down to a value; 0.5 is the median, which a cold first
// call or a disturbed one hardly affects. Requires at least one value.
inline double quantile(std::vector<double> values, double share) {
    const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + place, values.end());
    return values[static_cast<std::size_t>(place)];
}

}  // namespace hepatica
