// SPDX-License-Identifier: GPL-3.0-or-later
// Marks of a lesson as the view draws them, in a play or a review.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "core/lesson/lesson.h"
#include "core/lesson/play_meter.h"
#include "render/mark_actors.h"

namespace hepatica {

// Marks are numbered if there are several, count as reached if no step from `step` on names them or
// all steps are reached, and are wanted if that step names them. `places_mm`: one place for each
// mark of the lesson.
std::vector<MarkView> views_of_marks(const Lesson& lesson, const std::vector<Vec3>& places_mm,
                                     std::size_t step);

// A lesson with the places of its marks on a patient's vessels.
class MarkedLesson {
  public:
    // Throws as PlayMeter does.
    MarkedLesson(const Lesson& lesson, std::shared_ptr<const PatientCase> patient)
        : lesson_(lesson), meter_(lesson, std::move(patient)) {}

    // The frame must be of the lesson's scene and patient.
    std::vector<MarkView> marks_in(const Frame& frame, std::size_t step) const {
        return views_of_marks(lesson_, meter_.marks_in(frame), step);
    }

  private:
    Lesson lesson_;
    PlayMeter meter_;
};

}  // namespace hepatica
