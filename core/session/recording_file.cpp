// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/recording_file.h"

#include <charconv>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/base/json_depth.h"
#include "core/base/json_number.h"
#include "core/base/json_problem.h"
#include "core/base/quoted_name.h"
#include "core/base/regular_file.h"
#include "core/base/stop.h"

namespace hepatica {

using Json = nlohmann::ordered_json;

namespace {

constexpr int format_version = 2;
constexpr const char* how_to_record = "Give a file written by simulate --record";

// What fits into a message: a damaged file may hold megabytes where a hash should be.
std::string shortened(const std::string& text) {
    constexpr std::size_t most = 24;
    return text.size() <= most ? text : as_utf8(text.substr(0, most)) + "…";
}

std::uint64_t from_hex(const std::string& text) {
    std::uint64_t value = 0;
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value, 16);
    if (error != std::errc{} || rest != end || text.size() != 16)
        throw InputError("\"" + shortened(text) + "\" is not a hash", "",
                         "The recording is damaged");
    return value;
}

std::string header_of(const Recording& recording) {
    Json header{{"format", "hepatica-recording"},
                {"version", format_version},
                {"program", recording.program},
                {"back_end", recording.back_end},
                {"patient_hash", to_hex(recording.patient_hash)}};
    if (!recording.played_at.empty()) header["played_at"] = recording.played_at;
    header["scene"] = to_json(recording.scene);
    return header.dump() + "\n";
}

std::string line_of(const Keyframe& keyframe) {
    const Json state{{"keyframe", keyframe.step},
                     {"played_steps", keyframe.played_steps},
                     {"automatic", keyframe.automatic},
                     {"world", to_json(keyframe.world)}};
    return state.dump() + "\n";
}

std::string lines_of(const RecordedStep& step) {
    Json line{{"hash", to_hex(step.state_hash)}};
    for (const Command& command : step.commands) line["commands"].push_back(to_json(command));
    std::string text = line.dump() + "\n";
    if (step.keyframe) text += line_of(*step.keyframe);
    return text;
}

void read_header(const Json& json, Recording& recording) {
    if (json.value("format", "") != "hepatica-recording")
        throw InputError("is not a recording", "", how_to_record);
    const int version = whole_number<int>(json.value("version", Json(0)));
    if (version > format_version)
        throw InputError("was made by a newer version of the program, in format " +
                             std::to_string(version) + "; this one reads format " +
                             std::to_string(format_version),
                         "", "Open it with a newer version of the program");
    if (version != format_version)
        throw InputError("is of format " + std::to_string(version) +
                             ", and this program reads format " + std::to_string(format_version),
                         "", "Record the session again");
    recording.program = json.at("program").get<std::string>();
    recording.back_end = json.at("back_end").get<std::string>();
    if (recording.program != program_version())
        throw InputError("was recorded by version " + recording.program + ", and this is " +
                             program_version() + ", whose steps do not have the same bits",
                         "", "Replay it with version " + recording.program);
    recording.patient_hash = from_hex(json.at("patient_hash").get<std::string>());
    recording.played_at = json.value("played_at", "");
    recording.scene = scene_from_json(json.at("scene"));
}

void read_step(const Json& json, Recording& recording) {
    RecordedStep step;
    step.state_hash = from_hex(json.at("hash").get<std::string>());
    if (json.contains("commands"))
        for (const Json& command : json.at("commands"))
            step.commands.push_back(command_from_json(command));
    recording.steps.push_back(std::move(step));
}

// A keyframe is on the line after its step, or after the header.
void read_keyframe(const Json& json, Recording& recording) {
    auto keyframe = std::make_shared<Keyframe>();
    keyframe->step = whole_number<std::uint64_t>(json.at("keyframe"));
    keyframe->played_steps = whole_number<std::uint64_t>(json.at("played_steps"));
    keyframe->automatic = json.at("automatic").get<bool>();
    keyframe->world = world_checkpoint_from_json(json.at("world"));
    const bool begins = keyframe->step == 0 && recording.steps.empty() && !recording.begin;
    if (begins) {
        recording.begin = std::move(keyframe);
        return;
    }
    if (recording.steps.empty() || keyframe->step != recording.steps.size())
        throw InputError("a keyframe of step " + std::to_string(keyframe->step) +
                             " stands behind step " + std::to_string(recording.steps.size()),
                         "", "The recording is damaged");
    recording.steps.back().keyframe = std::move(keyframe);
}

void read_line(const Json& json, bool first, Recording& recording) {
    if (first)
        read_header(json, recording);
    else if (json.contains("keyframe"))
        read_keyframe(json, recording);
    else
        read_step(json, recording);
}

}  // namespace

std::string program_version() {
    return HEPATICA_VERSION;
}

RecordingWriter::RecordingWriter(std::filesystem::path file, const Recording& start)
    : file_(std::move(file)) {
    std::error_code ignored;  // a failure shows when the file is opened
    std::filesystem::create_directories(std::filesystem::absolute(file_).parent_path(), ignored);
    out_.open(file_, std::ios::binary | std::ios::trunc);
    out_ << header_of(start);
    if (start.begin) out_ << line_of(*start.begin);
    out_ << std::flush;
    if (!out_)
        throw InputError("cannot be written", file_.string(),
                         "Choose a folder that exists and can be written to");
    waiting_ = start.steps;
    thread_ = std::jthread([this] { write_until_closed(); });
}

RecordingWriter::~RecordingWriter() {
    finish();
}

void RecordingWriter::append(RecordedStep step) {
    {
        const std::scoped_lock lock(mutex_);
        waiting_.push_back(std::move(step));
    }
    changed_.notify_one();
}

void RecordingWriter::write_until_closed() {
    for (;;) {
        std::vector<RecordedStep> steps;
        {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, [this] { return closing_ || !waiting_.empty(); });
            steps.swap(waiting_);
            if (steps.empty()) return;
        }
        try {
            for (const RecordedStep& step : steps) out_ << lines_of(step);
            out_.flush();
        } catch (...) {  // no memory: a recording must have no gap, so it ends here
            out_.setstate(std::ios::badbit);
        }
        failed_ = failed_ || !out_;
    }
}

void RecordingWriter::finish() noexcept {
    if (!thread_.joinable()) return;
    {
        const std::scoped_lock lock(mutex_);
        closing_ = true;
    }
    changed_.notify_one();
    thread_.join();
    out_.close();
}

void RecordingWriter::close() {
    finish();
    if (failed_ || !out_)
        throw InputError("could not be written to its end", file_.string(),
                         "Is the disk full? What was written before can be replayed");
}

void write_recording(const std::filesystem::path& file, const Recording& recording) {
    RecordingWriter(file, recording).close();
}

Recording read_recording(const std::filesystem::path& file, RecordingPart part,
                         const std::stop_token& stop) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored))
        throw InputError("does not exist", file.string(), "Give a recording");
    require_regular_file(file, "Give a recording");
    std::ifstream in(file, std::ios::binary);
    if (!in) throw InputError("cannot be read", file.string(), "Give a recording");
    Recording recording;
    int number = 0;
    const auto more = [&](std::string& line) {
        throw_if_stopped(stop);
        return !(part == RecordingPart::header && number == 1) && std::getline(in, line);
    };
    for (std::string line; more(line);) {
        ++number;
        if (part == RecordingPart::commands && line.starts_with(R"({"keyframe")")) continue;
        const std::string place = file.string() + ", line " + std::to_string(number);
        const Json json = nests_too_deep(line) ? Json() : Json::parse(line, nullptr, false);
        const bool damaged = json.is_discarded() || !json.is_object();
        const bool last = in.peek() == std::ifstream::traits_type::eof();
        if (damaged && last && number > 1) {
            recording.warnings.push_back(place + " was not written to its end and is left out");
            break;
        }
        if (damaged)
            throw InputError(number == 1 ? "is not a recording" : "is damaged", place,
                             number == 1 ? how_to_record : "Record the session again");
        try {
            read_line(json, number == 1, recording);
        } catch (const InputError& error) {
            const std::string what = error.place().empty() ? "" : error.place() + " ";
            throw InputError(what + error.problem(), place, error.remedy());
        } catch (const Json::exception& error) {
            throw InputError(json_problem(error), place, "The recording is damaged");
        }
    }
    if (in.bad()) throw InputError("cannot be read to its end", file.string(), "Check the disk");
    if (number == 0) throw InputError("is empty", file.string(), how_to_record);
    return recording;
}

std::string played_at_in(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::string line;
    std::getline(in, line);
    const Json json = Json::parse(line, nullptr, false);
    const auto at = json.is_object() ? json.find("played_at") : json.end();
    return at != json.end() && at->is_string() ? at->get<std::string>() : std::string();
}

}  // namespace hepatica
