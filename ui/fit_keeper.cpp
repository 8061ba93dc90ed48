// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/fit_keeper.h"

#include <algorithm>
#include <iterator>

#include "ui/paths.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

std::vector<ShelvedLesson> unfit_lessons(const VesselTree& tree, const fs::path& place,
                                         const fs::path& library, Job& job) {
    std::vector<ShelvedLesson> all = lessons_in(place.parent_path(), job);
    if (!same_place(place.parent_path(), library))
        std::ranges::move(lessons_in(library, job), std::back_inserter(all));
    compare_with(tree, place, all);
    std::erase_if(all, [](const ShelvedLesson& lesson) { return lesson.misfits.empty(); });
    return all;
}

}  // namespace

void FitKeeper::look(std::shared_ptr<const PatientCase> patient, const fs::path& place,
                     const fs::path& library) {
    job_.reset();
    if (place.empty()) return found_({});  // no lesson names who lies nowhere
    BackgroundJob::Callbacks callbacks;
    callbacks.failed = [](const Failure&) {};  // a folder that cannot be read holds no lessons
    callbacks.ended = [this] { job_.reset(); };
    job_ = std::make_unique<BackgroundJob>(
        [this, patient = std::move(patient), place, library](Job& job) -> std::function<void()> {
            return [this, unfit = unfit_lessons(patient->tree, place, library, job)] {
                found_(unfit);
            };
        },
        std::move(callbacks));
}

}  // namespace hepatica
