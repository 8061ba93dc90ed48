// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/score.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/lesson/lesson_file.h"
#include "core/session/replay.h"

namespace hepatica {

namespace {

nlohmann::ordered_json what_must_agree(SceneSpec scene) {
    if (scene.deform) {
        scene.deform->quality = 0.0;
        scene.deform->setting.reset();
    }
    return to_json(scene);
}

// Lists each value that differs by its path in the scene: deform.material is "a", not "b".
std::string differences(const nlohmann::ordered_json& recorded,
                        const nlohmann::ordered_json& wanted) {
    const auto a = recorded.flatten(), b = wanted.flatten();
    std::string words;
    const auto tell = [&](std::string place, const std::string& is) {
        place.erase(0, 1);
        std::ranges::replace(place, '/', '.');
        words += (words.empty() ? "" : "; ") + place + " " + is;
    };
    for (const auto& [place, value] : a.items())
        if (!b.contains(place))
            tell(place, "is " + value.dump() + ", not left out");
        else if (b[place] != value)
            tell(place, "is " + value.dump() + ", not " + b[place].dump());
    for (const auto& [place, value] : b.items())
        if (!a.contains(place)) tell(place, "is left out, not " + value.dump());
    return words;
}

}  // namespace

bool is_same_scene(const SceneSpec& recorded, const SceneSpec& wanted) {
    return what_must_agree(recorded) == what_must_agree(wanted);
}

void require_same_scene(const SceneSpec& recorded, const SceneSpec& wanted) {
    if (is_same_scene(recorded, wanted)) return;
    throw InputError("was played in another scene than the lesson's: " +
                         differences(what_must_agree(recorded), what_must_agree(wanted)),
                     "recording", "Give a recording of this lesson");
}

std::optional<Lesson> built_in_lesson_of(const Recording& recording) {
    for (const BuiltInLesson& entry : built_in_lessons()) {
        Lesson lesson = find_lesson(entry.id);
        if (is_same_scene(recording.scene, lesson.scene)) return lesson;
    }
    return std::nullopt;
}

Score score(const Recording& recording, const Lesson& lesson,
            std::shared_ptr<const PatientCase> patient, Job& job, const DeformBackEnd& back_end,
            const SeeScored& see) {
    require_same_scene(recording.scene, lesson.scene);
    LessonRun run(lesson, patient);
    const ReplayResult result = replay(
        recording, patient, job, 0, back_end,
        [&](const std::vector<Command>& commands, const Frame& frame, const std::stop_token& stop) {
            run.see(commands, frame, stop);
            if (see) see(frame, run.standing());
            return true;
        },
        AfterDivergence::stop);
    if (result.diverged_at)
        throw InputError("diverged from the recording at step " +
                             std::to_string(*result.diverged_at) + ", so that it cannot be scored",
                         "recording", "Another build of the program or another processor made it");
    run.end();
    Score scored{run.standing(), run.samples()};
    // A recording that begins amid a play does not show what was done before.
    if (recording.begin && scored.standing.outcome == LessonOutcome::passed) {
        scored.standing.outcome = LessonOutcome::failed;
        scored.standing.reasons = {"something was done before the lesson began"};
    }
    return scored;
}

}  // namespace hepatica
