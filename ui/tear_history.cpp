// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tear_history.h"

namespace hepatica {
namespace {

void keep_every_second(std::vector<double>& values) {
    for (std::size_t i = 0; 2 * i < values.size(); ++i) values[i] = values[2 * i];
    values.resize((values.size() + 1) / 2);
}

}  // namespace

void TearHistory::clear() {
    *this = TearHistory();
}

void TearHistory::forget_after(double time_s) {
    while (!time_s_.empty() && time_s_.back() >= time_s) {
        time_s_.pop_back();
        entropy_.pop_back();
        produced_.pop_back();
    }
    std::erase_if(events_, [&](const Event& event) { return event.time_s > time_s; });
}

void TearHistory::note_events(double time_s, const TearView& now) {
    // A system may consist of several pieces from the start.
    if (time_s_.size() == 1) last_.pieces = now.pieces;
    const auto note = [&](const char* text) { events_.push_back({time_s, text}); };
    if (now.joints_broken < last_.joints_broken) note("whole");
    if (now.joints_broken > 0 && last_.joints_broken == 0) note("cut or torn");
    if (now.pieces > last_.pieces) note("piece off");
    if (now.leak_g_s > 0.0 && last_.leak_g_s == 0.0) note("bleeding");
    if (now.leak_g_s == 0.0 && last_.leak_g_s > 0.0) note("no more bleeding");
    if (!now.stopped_by.empty() && last_.stopped_by.empty()) note("tear stopped");
    last_ = now;
}

bool TearHistory::follow(const Frame& frame) {
    if (!frame.tear) {
        const bool had = !empty();
        clear();
        return had;
    }
    if (empty()) begin_s_ = frame.time_s;
    const double time_s = frame.time_s - begin_s_;
    if (!empty() && time_s == time_s_.back()) return false;
    if (!empty() && time_s < time_s_.back()) last_ = *frame.tear;  // the play went back in time
    forget_after(time_s);
    if (empty()) begin_s_ = frame.time_s;
    const double now_s = frame.time_s - begin_s_;
    time_s_.push_back(now_s);
    entropy_.push_back(frame.tear->entropy_nats);
    produced_.push_back(frame.tear->entropy_produced_nats);
    note_events(now_s, *frame.tear);
    if (time_s_.size() > most_points)
        for (auto* values : {&time_s_, &entropy_, &produced_}) keep_every_second(*values);
    return true;
}

Chart TearHistory::chart() const {
    return {
        "Tearing",
        "Time since the vessels may tear (s)",
        "Damage by tearing, as entropy (nats)",
        {Curve{"in all", time_s_, entropy_}, Curve{"since the first tear", time_s_, produced_}}};
}

}  // namespace hepatica
