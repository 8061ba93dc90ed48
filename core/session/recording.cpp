// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/recording.h"

#include <charconv>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/session/session.h"

namespace hepatica {

using Json = nlohmann::ordered_json;

namespace {

constexpr int recording_version = 1;

std::uint64_t from_hex(const std::string& text) {
    std::uint64_t value = 0;
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value, 16);
    if (error != std::errc{} || rest != end || text.size() != 16)
        throw InputError("\"" + text + "\" is not a hash", "", "The recording is damaged");
    return value;
}

RecordedStep step_from(const Json& json) {
    RecordedStep step;
    step.state_hash = from_hex(json.at("hash").get<std::string>());
    if (json.contains("commands"))
        for (const Json& command : json.at("commands"))
            step.commands.push_back(command_from_json(command));
    return step;
}

void read_header(const Json& json, Recording& recording) {
    if (json.value("format", "") != "hepatica-recording")
        throw InputError("is not a recording", "", "Give a file written by simulate --record");
    if (json.value("version", 0) != recording_version)
        throw InputError("has another version than " + std::to_string(recording_version), "",
                         "Record the session again");
    recording.patient_path = json.at("patient").get<std::string>();
    recording.patient_hash = from_hex(json.at("patient_hash").get<std::string>());
    recording.scene = scene_from_json(json.at("scene"));
}

}  // namespace

void write_recording(const std::filesystem::path& file, const Recording& recording) {
    Json header{{"format", "hepatica-recording"},
                {"version", recording_version},
                {"patient", recording.patient_path},
                {"patient_hash", to_hex(recording.patient_hash)},
                {"scene", to_json(recording.scene)}};
    std::string text = header.dump() + "\n";
    for (const RecordedStep& step : recording.steps) {
        Json line{{"hash", to_hex(step.state_hash)}};
        for (const Command& command : step.commands) line["commands"].push_back(to_json(command));
        text += line.dump() + "\n";
    }
    write_text_atomically(file, text);
}

Recording read_recording(const std::filesystem::path& file) {
    std::ifstream in(file);
    if (!in) throw InputError("cannot be read", file.string(), "Give a recording");
    Recording recording;
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        const std::string place = file.string() + ", line " + std::to_string(++number);
        const Json json = Json::parse(line, nullptr, false);
        if (json.is_discarded() || !json.is_object())
            throw InputError("is not a recording", place,
                             "Give a file written by simulate --record");
        try {
            if (number == 1)
                read_header(json, recording);
            else
                recording.steps.push_back(step_from(json));
        } catch (const InputError& error) {
            throw InputError(error.place() + " " + error.problem(), place, error.remedy());
        } catch (const Json::exception& error) {
            throw InputError(error.what(), place, "The recording is damaged");
        }
    }
    if (number == 0)
        throw InputError("is empty", file.string(), "Give a file written by simulate --record");
    return recording;
}

ReplayResult replay(const Recording& recording, std::shared_ptr<const PatientCase> patient,
                    Job& job) {
    if (hash_of(*patient) != recording.patient_hash)
        throw InputError("is not the patient that was recorded", recording.patient_path,
                         "Give the case that the recording was made with");
    Session session(std::move(patient), recording.scene, job);
    session.keep_recording(true);
    job.begin_stage("Replaying");
    ReplayResult result;
    for (const RecordedStep& step : recording.steps) {
        for (const Command& command : step.commands) session.post(command);
        result.state_hash = session.step().state_hash;
        ++result.steps;
        if (!result.diverged_at && result.state_hash != step.state_hash)
            result.diverged_at = result.steps;
        job.advance(static_cast<double>(result.steps) /
                    static_cast<double>(recording.steps.size()));
    }
    return result;
}

}  // namespace hepatica
