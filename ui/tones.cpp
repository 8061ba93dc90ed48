// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tones.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace hepatica {
namespace {

constexpr double loudest = 0.25;  // as a share of the range
constexpr double edge_s = 0.01;   // over which a note swells and fades

struct Note {
    double pitch_hz = 0.0, length_s = 0.0;
};

// Rising: something is reached. Falling: something is lost. One high note: take care.
std::vector<Note> notes_of(Tone tone) {
    switch (tone) {
        case Tone::warning:
            return {{1320.0, 0.08}};
        case Tone::harm:
            return {{440.0, 0.1}, {330.0, 0.16}};
        case Tone::reached:
            return {{660.0, 0.07}, {880.0, 0.1}};
        case Tone::passed:
            return {{660.0, 0.07}, {880.0, 0.07}, {1100.0, 0.14}};
        case Tone::not_passed:
            break;
    }
    return {{330.0, 0.1}, {262.0, 0.2}};
}

// From what passes by to what counts most.
int weight_of(Tone tone) {
    constexpr std::array by_weight{Tone::reached, Tone::warning, Tone::harm, Tone::not_passed,
                                   Tone::passed};
    return static_cast<int>(std::ranges::find(by_weight, tone) - by_weight.begin());
}

std::optional<Tone> tone_of(const PlayEvent& event, LessonOutcome outcome) {
    switch (event.kind) {
        case PlayEventKind::near_tear:
            return Tone::warning;
        case PlayEventKind::tear:
        case PlayEventKind::blood:
            return Tone::harm;
        case PlayEventKind::lesson:
            return outcome == LessonOutcome::passed ? Tone::passed : Tone::reached;
        case PlayEventKind::not_passed:
            return Tone::not_passed;
        case PlayEventKind::hand:
        case PlayEventKind::tool:
        case PlayEventKind::drug:
        case PlayEventKind::cut:
        case PlayEventKind::trouble:
            break;
    }
    return std::nullopt;
}

}  // namespace

std::vector<std::int16_t> samples_of(Tone tone) {
    std::vector<std::int16_t> samples;
    for (const Note& note : notes_of(tone)) {
        const auto count = static_cast<int>(std::lround(note.length_s * tone_rate_hz));
        for (int i = 0; i < count; ++i) {
            const double at_s = static_cast<double>(i) / tone_rate_hz;
            const double to_edge_s = std::min(at_s, note.length_s - at_s);
            const double swell = std::clamp(to_edge_s / edge_s, 0.0, 1.0);
            const double wave = std::sin(2.0 * std::numbers::pi * note.pitch_hz * at_s);
            samples.push_back(static_cast<std::int16_t>(
                std::lround(loudest * swell * wave * std::numeric_limits<std::int16_t>::max())));
        }
    }
    return samples;
}

std::optional<Tone> tone_of(std::span<const PlayEvent> events, LessonOutcome outcome) {
    std::optional<Tone> gravest;
    for (const PlayEvent& event : events)
        if (const auto tone = tone_of(event, outcome))
            if (!gravest || weight_of(*tone) > weight_of(*gravest)) gravest = tone;
    return gravest;
}

}  // namespace hepatica
