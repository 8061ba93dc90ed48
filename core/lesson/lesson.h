// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson: a patient, a scene, what has happened before it begins, tools, and steps with goals and
// limits. Plain data; lesson_file.h reads it, LessonRun measures a play by it.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/lesson/predicate.h"
#include "core/scene/scene_spec.h"
#include "core/session/script.h"

namespace hepatica {

// Where a place lay on its patient's vessels when the lesson was saved; see lesson_ties.h.
struct PlaceTie {
    Vec3 at_mm = Vec3::Zero();  // on the centreline
    double radius_mm = 0.0;
    double beyond_mm = 0.0;  // of a target: length of all vessels beyond it
    bool operator==(const PlaceTie&) const = default;
};

// One place of a setup, as it is given there, and its tie: so it keeps it whatever is put before
// it.
using SetupPlace = std::variant<ScriptPlace, Blade>;
struct SetupTie {
    SetupPlace of;
    std::optional<PlaceTie> tie;
};

// A place on the vessels that goals speak of; it moves with them.
struct LessonMark {
    std::string name;
    ScriptPlace place;
    std::optional<PlaceTie> tie{};
};

struct LessonStep {
    std::string text;
    std::string hint;             // may be empty
    std::vector<Predicate> goal;  // all at once; not empty
    double hold_s = 0.0;          // without a break for so long
    std::vector<Predicate> limits;
};

// What a trainee may use. Beside it only what moves, turns, opens and puts away what is in hand.
enum class LessonTool {
    pull,
    sphere,
    capsule,
    forceps,
    hook,
    blade,
    cut_line,
    inject,
    settings,  // gravity, tissue, wall, tearing, the drug's clock and speed
};
const char* name_of(LessonTool tool);

struct Lesson {
    std::string name;
    std::string about;            // for the trainee, before it begins; may be empty
    std::string patient = "any";  // "built-in", "any", or a case (relative: to the lesson's file)
    SceneSpec scene;              // of the play
    Script setup;                 // done in the first step
    std::string setup_json;       // its actions as they were given, a JSON array; may be empty
    std::vector<SetupTie> setup_ties{};
    std::vector<LessonTool> tools;  // empty: none
    std::vector<LessonMark> marks;
    std::string drug;                   // second phase of what is injected; empty: any
    std::optional<ScriptPlace> target;  // of the drug: the vessels from there on
    std::optional<PlaceTie> target_tie;
    std::vector<LessonStep> steps;  // in this order; not empty
    std::vector<Predicate> limits;  // all the time
    std::vector<Predicate> pass;    // at the end

    std::vector<std::string> mark_names() const;
};

}  // namespace hepatica
