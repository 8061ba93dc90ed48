// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson: a patient, a scene, a setup, the tools allowed, and steps with goals and limits. Plain
// data: lesson_file.h reads it and LessonRun scores a play by it.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/lesson/predicate.h"
#include "core/scene/scene_spec.h"
#include "core/session/script.h"

namespace hepatica {

// Where a place lay on the patient's vessels when the lesson was saved, see lesson_ties.h.
struct PlaceTie {
    Vec3 at_mm = Vec3::Zero();  // on the centreline
    double radius_mm = 0.0;
    double beyond_mm = 0.0;  // of a target: total length of the vessels beyond it
    bool operator==(const PlaceTie&) const = default;
};

// One place of a setup with its tie. The place identifies the tie, so that actions inserted before
// it do not shift it.
using SetupPlace = std::variant<ScriptPlace, Blade>;
struct SetupTie {
    SetupPlace of;
    std::optional<PlaceTie> tie;
};

// A named place on the vessels that goals refer to; it moves with the vessels.
struct LessonMark {
    std::string name;
    ScriptPlace place;
    std::optional<PlaceTie> tie{};
};

// What a trainee may use, see objection_to() for what is always allowed.
enum class LessonTool {
    pull,
    sphere,
    capsule,
    forceps,
    hook,
    blade,
    cut_line,
    inject,
    settings,  // gravity, tether, wall, tearing, contact, the drug's time and speed
};
const char* name_of(LessonTool tool);

struct LessonStep {
    std::string text;
    std::string hint;             // may be empty
    std::vector<Predicate> goal;  // must hold simultaneously; not empty
    double hold_s = 0.0;          // for so long without interruption
    std::vector<Predicate> limits;
    // The goal counts only while this tool is in hand, see is_in_hand(); none: whatever is.
    std::optional<LessonTool> tool{};
};

struct Lesson {
    std::string name;
    std::string about;            // shown before the lesson begins; may be empty
    std::string patient = "any";  // or "built-in", or a case, relative to the lesson's file
    SceneSpec scene;              // of the play
    Script setup;                 // applied in the first step
    std::string setup_json;       // its actions as written, a JSON array; may be empty
    std::vector<SetupTie> setup_ties{};
    std::vector<LessonTool> tools;  // empty: none
    std::vector<LessonMark> marks;
    std::string drug;                   // name of the injected second phase; empty: any
    std::optional<ScriptPlace> target;  // of the drug: this place and all vessels beyond it
    std::optional<PlaceTie> target_tie;
    std::vector<LessonStep> steps;  // in order; not empty
    std::vector<Predicate> limits;  // during the whole lesson
    std::vector<Predicate> pass;    // at the end
    // Tells it from other lessons, whatever it is called; empty: its name does.
    std::string id{};

    std::vector<std::string> mark_names() const;
};

}  // namespace hepatica
