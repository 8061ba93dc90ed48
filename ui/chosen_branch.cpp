// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/chosen_branch.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "ui/body_anchors.h"

namespace hepatica {

void ChosenBranch::choose(int branch, std::shared_ptr<const PatientCase> patient) {
    branch_ = -1;
    patient_ = std::move(patient);
    at_rest_mm_.clear();
    anchored_to_ = nullptr;
    if (!patient_ || branch < 0 ||
        static_cast<std::size_t>(branch) >= patient_->tree.segments.size())
        return;
    branch_ = branch;
    const auto& points = patient_->tree.segments[static_cast<std::size_t>(branch)].points_mm;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3 from = i > 0 ? points[i - 1] : points[i];
        const int pieces =
            std::max(1, static_cast<int>(std::ceil((points[i] - from).norm() / spacing_mm)));
        for (int piece = 1; piece <= pieces; ++piece)
            at_rest_mm_.push_back(from + (points[i] - from) * piece / pieces);
    }
}

std::vector<Vec3> ChosenBranch::line_in(const Frame& frame) {
    if (branch_ < 0) return {};
    const std::vector<Vec3>& rest = rest_vertices(*patient_, frame);
    if (std::exchange(anchored_to_, &rest) != &rest) {
        anchors_.clear();
        for (const Vec3& point : at_rest_mm_) anchors_.push_back(nearest_vertex(rest, point));
    }
    std::vector<Vec3> line = at_rest_mm_;
    for (std::size_t i = 0; i < line.size(); ++i)
        line[i] += displacement_mm(anchors_[i], rest, frame);
    return line;
}

}  // namespace hepatica
