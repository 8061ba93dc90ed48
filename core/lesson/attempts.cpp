// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/attempts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <system_error>

#include "core/base/atomic_write.h"
#include "core/base/csv_cell.h"
#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/base/text_file.h"
#include "core/lesson/lesson_fields.h"
#include "core/lesson/predicate_json.h"

namespace hepatica {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr const char* result_format = "hepatica-result";
constexpr const char* suffix = ".result.json";
constexpr const char* result_remedy = "Remove it: hepatica-cli lesson scores its recording again";

Quantity quantity(std::size_t i) {
    return static_cast<Quantity>(i);
}

bool truth_from(const LessonFields& field) {
    if (!field.json().is_boolean())
        field.refuse("is " + field.dump() + ", not true or false", result_remedy);
    return field.json().get<bool>();
}

// Returns true if the attempt passed, or failed by the last `marks` pass marks alone (those of a
// course).
bool passed_but_for(std::size_t marks, const LessonStanding& standing) {
    if (standing.outcome == LessonOutcome::passed) return true;
    const auto own_end =
        standing.pass.end() - static_cast<std::ptrdiff_t>(std::min(marks, standing.pass.size()));
    const auto missed = std::ranges::count(standing.pass, false, &BoundStanding::kept);
    const bool reached_the_end = standing.outcome == LessonOutcome::failed &&
                                 standing.step == standing.steps.size() &&
                                 static_cast<std::ptrdiff_t>(standing.reasons.size()) == missed;
    return reached_the_end && std::all_of(standing.pass.begin(), own_end,
                                          [](const BoundStanding& mark) { return mark.kept; });
}

}  // namespace

Attempt attempt_of(const fs::path& recording, const std::string& lesson,
                   const LessonStanding& standing, const std::string& ended_at,
                   std::vector<Predicate> course_pass) {
    Attempt attempt;
    attempt.recording = recording;
    attempt.lesson = lesson;
    attempt.ended_at = ended_at;
    attempt.passed = standing.outcome == LessonOutcome::passed;
    attempt.passed_lesson = passed_but_for(course_pass.size(), standing);
    attempt.course_pass = std::move(course_pass);
    attempt.reasons = standing.reasons;
    for (std::size_t i = 0; i < metric_count; ++i)
        attempt.metrics[i] = value_of({quantity(i), -1, true, 0.0}, standing.metrics, {}, 0.0);
    return attempt;
}

bool was_interrupted(const Attempt& attempt) {
    return std::ranges::find(attempt.reasons, interrupted_reason) != attempt.reasons.end();
}

fs::path result_file_of(const fs::path& recording) {
    fs::path file = recording;
    return file.replace_extension(suffix);
}

std::string text_of(const Attempt& attempt) {
    Json metrics;
    for (std::size_t i = 0; i < metric_count; ++i)
        metrics[words_of(quantity(i)).name] = attempt.metrics[i];  // NaN becomes null
    Json json{{"format", result_format},        {"version", 1},
              {"lesson", attempt.lesson},       {"ended_at", attempt.ended_at},
              {"passed", attempt.passed},       {"reasons", attempt.reasons},
              {"reference", attempt.reference}, {"metrics", metrics}};
    if (!attempt.lesson_id.empty()) json["lesson_id"] = attempt.lesson_id;
    if (!attempt.name.empty()) json["name"] = attempt.name;
    if (!attempt.course_pass.empty()) {
        json["course_pass"] = json_of(attempt.course_pass, {});
        json["passed_lesson"] = attempt.passed_lesson;
    }
    return json.dump(1) + "\n";
}

void write_attempt(const Attempt& attempt) {
    write_text_atomically(result_file_of(attempt.recording), text_of(attempt));
}

Attempt attempt_from(const std::string& text, const fs::path& recording, const std::string& place) {
    const Json json = Json::parse(text, nullptr, false);
    if (json.is_discarded()) throw InputError("is not JSON", place, result_remedy);
    const LessonFields fields(json, place, "");
    fields.know({"format", "version", "lesson", "ended_at", "passed", "reasons", "reference",
                 "metrics", "name", "lesson_id", "course_pass", "passed_lesson"});
    fields.require_format(result_format, result_remedy);
    Attempt attempt;
    attempt.recording = recording;
    attempt.lesson = fields.need("lesson").text();
    if (fields.has("lesson_id")) attempt.lesson_id = fields.need("lesson_id").text();
    if (fields.has("name")) attempt.name = fields.need("name").text();
    attempt.ended_at = fields.need("ended_at").text();
    attempt.passed = truth_from(fields.need("passed"));
    attempt.course_pass = predicates_from(fields, "course_pass", {});
    attempt.passed_lesson =
        fields.has("passed_lesson") ? truth_from(fields.need("passed_lesson")) : attempt.passed;
    for (const LessonFields& reason : fields.need("reasons").list())
        attempt.reasons.push_back(reason.text());
    attempt.reference = truth_from(fields.need("reference"));
    const LessonFields metrics = fields.need("metrics");
    for (std::size_t i = 0; i < metric_count; ++i) {
        const LessonFields metric = metrics.need(words_of(quantity(i)).name);
        attempt.metrics[i] =
            metric.json().is_null() ? std::numeric_limits<double>::quiet_NaN() : metric.number();
    }
    return attempt;
}

Attempts all_attempts(const fs::path& folder) {
    Attempts found;
    std::error_code failed;
    for (fs::directory_iterator at(folder, failed), end; !failed && at != end;
         at.increment(failed)) {
        const fs::directory_entry& entry = *at;
        const std::string name = entry.path().filename().string();
        if (!name.ends_with(suffix)) continue;
        const fs::path recording =
            folder / (name.substr(0, name.size() - std::string(suffix).size()) + ".hrec");
        try {
            found.list.push_back(attempt_from(read_text_file(entry.path(), result_remedy),
                                              recording, entry.path().string()));
        } catch (const InputError& error) {
            found.passed_over.push_back(error.place() + " " + error.problem());
        }
    }
    std::ranges::sort(found.list, {}, [](const Attempt& attempt) {
        return std::pair(attempt.ended_at, attempt.recording);
    });
    std::ranges::sort(found.passed_over);
    return found;
}

std::string id_of_former_name(const std::string& name) {
    return "name:" + name;
}

bool is_at(const Attempt& attempt, const LessonKey& lesson) {
    if (attempt.lesson_id.empty())
        return attempt.lesson == lesson.name || id_of_former_name(attempt.lesson) == lesson.id;
    return attempt.lesson_id == (lesson.id.empty() ? lesson.name : lesson.id);
}

Attempts attempts_at(const LessonKey& lesson, const fs::path& folder) {
    Attempts found = all_attempts(folder);
    std::erase_if(found.list, [&](const Attempt& attempt) { return !is_at(attempt, lesson); });
    return found;
}

std::vector<std::string> names_in(const std::vector<Attempt>& attempts) {
    std::vector<std::string> names;
    for (const Attempt& attempt : attempts)
        if (!attempt.name.empty()) names.push_back(attempt.name);
    std::ranges::sort(names);
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

namespace {

// The result beside the recording.
Attempt read_attempt(const fs::path& recording) {
    const fs::path file = result_file_of(recording);
    return attempt_from(read_text_file(file, result_remedy), recording, file.string());
}

// An empty attempt if there is none or it cannot be read.
Attempt attempt_beside(const fs::path& recording) {
    try {
        return read_attempt(recording);
    } catch (const InputError&) {
        return {};
    }
}

}  // namespace

std::string name_beside(const fs::path& recording) {
    return attempt_beside(recording).name;
}

std::string ended_at_beside(const fs::path& recording) {
    return attempt_beside(recording).ended_at;
}

bool interrupted_beside(const fs::path& recording) {
    return was_interrupted(attempt_beside(recording));
}

std::vector<Predicate> course_pass_beside(const fs::path& recording) {
    return attempt_beside(recording).course_pass;
}

std::optional<Lesson> with_course_pass(std::optional<Lesson> lesson, const fs::path& recording) {
    if (lesson) add_new(course_pass_beside(recording), lesson->pass);
    return lesson;
}

void name_attempt(const fs::path& recording, const std::string& name) {
    Attempt attempt = read_attempt(recording);
    attempt.name = name;
    write_attempt(attempt);
}

void mark_reference(const fs::path& recording, bool reference) {
    Attempt attempt = read_attempt(recording);
    attempt.reference = reference;
    write_attempt(attempt);
}

std::optional<Band> band_of(const std::vector<Attempt>& attempts, Quantity quantity) {
    std::optional<Band> band;
    for (const Attempt& attempt : attempts) {
        const double value = attempt.value(quantity);
        if (!attempt.reference || !std::isfinite(value)) continue;
        if (!band) band = Band{value, value};
        band->least = std::min(band->least, value);
        band->most = std::max(band->most, value);
    }
    return band;
}

std::string to_csv(const std::vector<Attempt>& attempts) {
    std::string text = "lesson,attempt,ended_at,passed,reference";
    for (std::size_t i = 0; i < metric_count; ++i)
        text += std::string(",") + words_of(quantity(i)).name;
    const bool named = !names_in(attempts).empty();
    text += named ? ",name\n" : "\n";
    for (std::size_t row = 0; row < attempts.size(); ++row) {
        const Attempt& attempt = attempts[row];
        text += csv_cell(attempt.lesson) + "," + std::to_string(row + 1) + "," +
                csv_cell(attempt.ended_at) + "," + (attempt.passed ? "yes" : "no") + "," +
                (attempt.reference ? "yes" : "no");
        for (const double value : attempt.metrics)
            text += std::isfinite(value) ? "," + number_text(value) : ",";
        if (named) text += "," + csv_cell(attempt.name);
        text += "\n";
    }
    return text;
}

}  // namespace hepatica
