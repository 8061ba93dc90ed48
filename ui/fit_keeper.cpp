// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/fit_keeper.h"

#include <algorithm>
#include <iterator>

#include "ui/paths.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

std::vector<ShelvedLesson> unfit_lessons(const VesselTree& now, const VesselTree* opened,
                                         const fs::path& place, const fs::path& library, Job& job) {
    std::vector<ShelvedLesson> all = lessons_in(place.parent_path(), job);
    if (!same_place(place.parent_path(), library))
        std::ranges::move(lessons_in(library, job), std::back_inserter(all));
    compare_with(now, place, all, opened);
    std::erase_if(all, [](const ShelvedLesson& lesson) { return lesson.misfits.empty(); });
    return all;
}

}  // namespace

void FitKeeper::patient_opened(const VesselTree& vessels) {
    job_.reset();
    opened_ = std::make_shared<const VesselTree>(vessels);
}

void FitKeeper::look(std::shared_ptr<const PatientCase> patient, const fs::path& place,
                     const fs::path& library) {
    job_.reset();
    if (place.empty()) return ways_.found({});  // an unsaved patient has no lessons of his own
    BackgroundJob::Callbacks callbacks;
    callbacks.failed = ways_.failed;
    callbacks.ended = [this] { job_.reset(); };
    job_ = std::make_unique<BackgroundJob>(
        [this, patient = std::move(patient), opened = opened_, place,
         library](Job& job) -> std::function<void()> {
            return [this, unfit = unfit_lessons(patient->tree, opened.get(), place, library, job)] {
                ways_.found(unfit);
            };
        },
        std::move(callbacks));
}

}  // namespace hepatica
