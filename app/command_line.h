// SPDX-License-Identifier: GPL-3.0-or-later
// Common frame of all verbs of hepatica-cli: options, JSON or readable output, progress, Ctrl-C,
// and the exit codes (0 done, 1 bad input, 2 bad usage, 3 internal error, 130 interrupted).
//
// A verb is one file with one function add_NAME(CommandLine&), listed in verbs/verbs.h:
//     void add_pressure_drop(CommandLine& line) {
//         auto options = std::make_shared<Options>();
//         CLI::App& verb = line.add_verb("pressure-drop", "Loss of pressure along one segment",
//                                        [options](Job&) { return Json{{"total_pa", ...}}; });
//         verb.add_option("--r1-mm", options->r1_mm, "Radius at the inlet [mm]")->required();
//     }
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "app/interruption.h"
#include "core/base/job.h"

namespace hepatica {

using Json = nlohmann::ordered_json;

class CommandLine {
  public:
    // The work of a verb, under a job that Ctrl-C cancels and whose progress is shown on standard
    // error; returns the answer. Throws Error for whatever the user can correct.
    using Run = std::function<Json(Job&)>;
    // Shortens an answer for readable output, where it is too long to read.
    using Summary = std::function<Json(const Json&)>;

    CommandLine();
    CommandLine(const CommandLine&) = delete;
    CommandLine& operator=(const CommandLine&) = delete;

    // Adds `hepatica-cli NAME` with --json and --quiet; the caller adds the verb's own options.
    CLI::App& add_verb(const std::string& name, const std::string& description, Run run,
                       Summary summary = nullptr);

    // Adds a verb to a group, as `hepatica-cli bench iterations`; `group` is the group's name.
    CLI::App& add_verb(const std::string& group, const std::string& group_description,
                       const std::string& name, const std::string& description, Run run);

    // Parses the arguments, runs the verb and prints its answer on standard output: as JSON with
    // --json, otherwise as readable lines. Returns the exit code.
    int run(int argc, const char* const* argv);

  private:
    CLI::App& add_to(CLI::App& parent, const std::string& name, const std::string& description,
                     Run run, Summary summary);
    int run_verb();

    CLI::App program_;
    std::map<std::string, CLI::App*> groups_;
    Run chosen_;
    Summary summary_;
    bool json_ = false;
    bool quiet_ = false;
};

// Lets whole numbers from `least` to 2^63 - 1 pass; CLI11 wraps those that an unsigned option
// cannot hold.
CLI::Validator whole_number_from(std::int64_t least);

// Throws UsageError that names the option where the text is no UTF-8, which neither JSON nor HTML
// could hold.
void require_utf8(const std::string& option, const std::string& text);

// Parses "1,2,3", given to `option`, into three values. Throws UsageError that names the option.
std::array<double, 3> parse_triple(const std::string& option, const std::string& text);

}  // namespace hepatica
