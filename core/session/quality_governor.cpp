// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/quality_governor.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "core/base/median.h"

namespace hepatica {
namespace {

constexpr std::size_t window = 9;         // number of frames in the median
constexpr double share_after_down = 0.8;  // of the budget, for the forecast when going down
constexpr double share_before_up = 0.7;
constexpr int frames_before_up = 60;
constexpr int first_penalty = 120, longest_penalty = 7200;
constexpr int settling_frames = 2;
// An error smaller than that of the cheaper setting by at most this share is no improvement: a
// measurement on another pull could reverse the order.
constexpr double same_error = 0.05;

std::vector<std::size_t> noticeably_better(const std::vector<double>& errors) {
    std::vector<std::size_t> choices{0};
    for (std::size_t i = 1; i < errors.size(); ++i)
        if (errors[i] < (1.0 - same_error) * errors[choices.back()]) choices.push_back(i);
    return choices;
}

}  // namespace

QualityGovernor::QualityGovernor(std::vector<double> front_ms, const std::vector<double>& errors)
    : front_ms_(std::move(front_ms)),
      choices_(noticeably_better(errors)),
      barred_(front_ms_.size(), 0),
      penalty_(front_ms_.size(), first_penalty) {
    assert(errors.size() == front_ms_.size());
}

std::size_t QualityGovernor::start(double budget_ms) const {
    std::size_t best = choices_.front();
    for (const std::size_t choice : choices_)
        if (front_ms_[choice] <= share_after_down * budget_ms) best = choice;
    return best;
}

double QualityGovernor::forecast(std::size_t setting, std::size_t at, double seen_ms) const {
    return seen_ms * front_ms_[setting] / front_ms_[at];
}

std::size_t QualityGovernor::moved_to(std::size_t setting) {
    recent_ms_.clear();
    roomy_frames_ = 0;
    frames_to_ignore_ = settling_frames;
    return setting;
}

std::size_t QualityGovernor::next(std::size_t at, double frame_ms, double budget_ms) {
    for (int& frames : barred_) frames = std::max(0, frames - 1);
    if (frames_to_ignore_ > 0) {
        --frames_to_ignore_;
        return at;
    }
    recent_ms_.push_back(frame_ms);
    if (recent_ms_.size() > window) recent_ms_.pop_front();
    if (recent_ms_.size() < window) return at;
    const double seen_ms = median(std::vector<double>(recent_ms_.begin(), recent_ms_.end()));
    if (seen_ms > budget_ms) {
        auto lower = std::ranges::lower_bound(choices_, at);
        if (lower == choices_.begin()) return at;
        barred_[at] = penalty_[at];
        penalty_[at] = std::min(2 * penalty_[at], longest_penalty);
        --lower;
        while (lower != choices_.begin() &&
               forecast(*lower, at, seen_ms) > share_after_down * budget_ms)
            --lower;
        return moved_to(*lower);
    }
    const auto better = std::ranges::upper_bound(choices_, at);
    const bool room = better != choices_.end() && barred_[*better] == 0 &&
                      forecast(*better, at, seen_ms) <= share_before_up * budget_ms;
    roomy_frames_ = room ? roomy_frames_ + 1 : 0;
    return roomy_frames_ >= frames_before_up ? moved_to(*better) : at;
}

}  // namespace hepatica
