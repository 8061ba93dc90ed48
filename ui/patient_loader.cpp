// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/patient_loader.h"

#include <utility>

#include "core/base/error.h"
#include "core/flow/flow_shares.h"
#include "core/links/link_model.h"
#include "core/scene/measured_dial.h"
#include "core/session/session.h"
#include "ui/packed_lessons.h"
#include "ui/simulation_thread.h"
#include "ui/window_words.h"
#include "ui/words.h"

namespace hepatica {
namespace {

// Without those that lie beside the file, too: they were taken out before.
std::vector<std::string> names_of_lessons_in(const std::filesystem::path& place, Job& job) {
    std::vector<std::string> names;
    if (!holds_lessons(place)) return names;
    for (const Lesson& lesson : lessons_not_beside(place, job)) names.push_back(lesson.name);
    return names;
}

// A dial in the cache that is damaged is measured again: nobody saved it.
void drop_damaged_dial(OpenedPatient& opened) {
    try {
        measured_points(*opened.patient);
    } catch (const InputError&) {
        auto patient = std::make_shared<PatientCase>(*opened.patient);
        patient->dial_json.clear();
        opened.patient = std::move(patient);
    }
}

OpenRequest as_the_window_opens(OpenRequest request) {
    request.cache.with_dial = true;
    if (!request.built_in) request.reconstruct.offers = shipped_link_model();
    return request;
}

}  // namespace

LoadedPatient play(std::shared_ptr<const PatientCase> patient, Job& job) {
    return play_with(cpu_back_end(), std::move(patient), job);
}

LoadedPatient play_with(const DeformBackEnd& back_end, std::shared_ptr<const PatientCase> patient,
                        Job& job) {
    LoadedPatient loaded;
    job.begin_stage(Words::id("Preparing the play"));
    loaded.anatomy = SurfaceAnatomy(patient->tree, patient->mesh.vertices_mm, job);
    loaded.flow_shares = flow_shares(patient->tree);
    auto session = std::make_unique<Session>(patient, default_scene(), job, back_end);
    session->post(SetAutomaticQuality{true});
    loaded.simulation = std::make_unique<SimulationThread>(std::move(session));
    loaded.patient = std::move(patient);
    return loaded;
}

LoadedPatient load_patient(const OpenRequest& request, Job& job, const DeformBackEnd& back_end) {
    constexpr int preparing = 1, building_the_scene = 1;
    job.expect_stages(opening_stage_count(request) + preparing + building_the_scene);
    OpenedPatient opened = open_patient(as_the_window_opens(request), job);
    for (auto* list : {&opened.warnings, &opened.warnings_of_image})
        for (std::string& warning : *list) warning = in_window_words(std::move(warning));
    if (!opened.cached_case.empty()) drop_damaged_dial(opened);
    LoadedPatient loaded = play_with(back_end, opened.patient, job);
    if (std::string words = words_on_left_out(back_end, measured_points(*opened.patient));
        !words.empty())
        opened.warnings.push_back(std::move(words));
    // First, because the window shows only the first two at once.
    const auto of_ends = warnings_of_ends(opened.patient->tree, loaded.flow_shares);
    opened.warnings.insert(opened.warnings.begin(), of_ends.begin(), of_ends.end());
    static_cast<OpenedPatient&>(loaded) = std::move(opened);
    if (!request.built_in && !request.unsaved_copy)
        loaded.packed_lessons = names_of_lessons_in(request.reconstruct.ct, job);
    return loaded;
}

}  // namespace hepatica
