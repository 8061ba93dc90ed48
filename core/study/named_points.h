// SPDX-License-Identifier: GPL-3.0-or-later
// Studies whose points are named settings, each with the TradeoffPoint that was measured: what they
// share with a patient's tradeoff, its front and its files.
#pragma once

#include "core/study/tradeoff.h"

namespace hepatica {

// As a Tradeoff whose elements are named by the settings, for write_tradeoff().
template <class Study>
Tradeoff as_tradeoff(const Study& study) {
    Tradeoff plain;
    plain.reference = study.reference;
    for (const auto& measured : study.points) {
        plain.points.push_back(measured.point);
        plain.points.back().element = measured.name;
    }
    return plain;
}

// See mark_front(Tradeoff&).
template <class Study>
void mark_front_of(Study& study) {
    Tradeoff marked = as_tradeoff(study);
    mark_front(marked);
    for (std::size_t i = 0; i < marked.points.size(); ++i) {
        study.points[i].point.on_front = marked.points[i].on_front;
        study.points[i].point.quality = marked.points[i].quality;
    }
}

}  // namespace hepatica
