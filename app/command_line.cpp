// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line.h"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <limits>
#include <new>
#include <utility>

#include "app/progress_display.h"
#include "app/readable.h"
#include "app/writing_signals.h"
#include "core/base/error.h"
#include "core/base/quoted_name.h"

namespace hepatica {

namespace {

constexpr int exit_done = 0;
constexpr int exit_bad_input = 1;
constexpr int exit_bad_usage = 2;
constexpr int exit_internal = 3;

int report(const Error& error, int code) {
    const std::string where = error.place().empty() ? "" : error.place() + ": ";
    spdlog::error("{}{}", where, error.problem());
    if (!error.remedy().empty()) spdlog::error("{}", error.remedy());
    return code;
}

// NaN and infinity parse as numbers, but comparisons with NaN are false, so range checks would miss
// it.
void refuse_non_number(const CLI::Option& option, const std::string& value) {
    if (option.get_type_name().find("FLOAT") == std::string::npos) return;
    char* end = nullptr;
    const double number = std::strtod(value.c_str(), &end);
    if (*end == '\0' && !std::isfinite(number))
        throw UsageError("\"" + value + "\" is no number that can be used", option.get_name(),
                         "Give a finite number");
}

// An empty value, such as that of a variable of the shell that is not set, reads like an option
// that was left out: with --out "" a verb would change the case that it was given.
void refuse_nothing(const CLI::Option& option, const std::string& value) {
    if (value.empty())
        throw UsageError("is given an empty value", option.get_name(),
                         "Give one, or leave the option out");
}

// Refuses values that no option of a verb can mean.
void refuse_senseless_values(const CLI::App& app) {
    for (const CLI::App* verb : app.get_subcommands()) refuse_senseless_values(*verb);
    for (const CLI::Option* option : app.get_options())
        for (const std::string& value : option->results()) {
            refuse_nothing(*option, value);
            refuse_non_number(*option, value);
        }
}

// The verb or group of this name; null where there is none.
const CLI::App* verb_of(const CLI::App& group, const std::string& name) {
    const auto verbs = group.get_subcommands([](const CLI::App*) { return true; });
    const auto found =
        std::ranges::find_if(verbs, [&](const CLI::App* verb) { return verb->get_name() == name; });
    return found == verbs.end() ? nullptr : *found;
}

// Names the verb that is not there, or the help of the one that is: `bench step` is in a group.
int report_usage(const CLI::App& program, int argc, const char* const* argv,
                 const CLI::ParseError& error) {
    const CLI::App* at = &program;
    std::string known;
    int next = 1;
    for (; next < argc; ++next) {
        const CLI::App* const verb = verb_of(*at, argv[next]);
        if (verb == nullptr) break;
        at = verb;
        known += verb->get_name() + " ";
    }
    const bool is_group = at->get_require_subcommand_min() > 0;
    if (is_group && next < argc && argv[next][0] != '-')
        spdlog::error("there is no verb \"{}{}\"", known, argv[next]);
    else
        spdlog::error("{}", error.what());
    spdlog::error("See `hepatica-cli {}--help`", known);
    return exit_bad_usage;
}

// The log goes to standard error, so that standard output holds only the answer.
void set_up_log(bool quiet) {
    auto sink = std::make_shared<spdlog::sinks::stderr_sink_mt>();
    auto logger = std::make_shared<spdlog::logger>("hepatica", sink);
    logger->set_pattern("hepatica-cli: %l: %v");
    logger->set_level(quiet ? spdlog::level::warn : spdlog::level::info);
    spdlog::set_default_logger(std::move(logger));
}

}  // namespace

CommandLine::CommandLine()
    : program_(
          "Hepatica without a window: reconstructs hepatic vessels from CT, simulates them "
          "and measures. Every verb takes --help and --json.",
          "hepatica-cli") {
    program_.require_subcommand(1);
    program_.set_version_flag("--version", HEPATICA_VERSION);
}

CLI::App& CommandLine::add_verb(const std::string& name, const std::string& description, Run run,
                                Summary summary) {
    return add_to(program_, name, description, std::move(run), std::move(summary));
}

CLI::App& CommandLine::add_verb(const std::string& group, const std::string& group_description,
                                const std::string& name, const std::string& description, Run run) {
    CLI::App*& parent = groups_[group];
    if (parent == nullptr) {
        parent = program_.add_subcommand(group, group_description);
        parent->require_subcommand(1);
    }
    return add_to(*parent, name, description, std::move(run), nullptr);
}

CLI::App& CommandLine::add_to(CLI::App& parent, const std::string& name,
                              const std::string& description, Run run, Summary summary) {
    CLI::App& verb = *parent.add_subcommand(name, description);
    verb.add_flag("--json", json_, "Print one JSON object on standard output and nothing else");
    verb.add_flag("--quiet", quiet_, "Show no progress");
    verb.callback([this, run = std::move(run), summary = std::move(summary)] {
        chosen_ = run;
        summary_ = summary;
    });
    return verb;
}

int CommandLine::run(int argc, const char* const* argv) {
    set_up_log(false);
    ignore_signals_of_writing();
    try {
        program_.parse(argc, argv);
    } catch (const CLI::Success& success) {
        return program_.exit(success);
    } catch (const CLI::ParseError& error) {
        return report_usage(program_, argc, argv, error);
    }
    set_up_log(quiet_);
    try {
        refuse_senseless_values(program_);
    } catch (const UsageError& error) {
        return report(error, exit_bad_usage);
    }
    return run_verb();
}

int CommandLine::run_verb() {
    try {
        Json answer;
        {
            Job job;
            const ProgressDisplay display(job, quiet_);
            answer = chosen_(job);
        }
        if (json_)
            std::cout << answer.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
        else
            std::cout << readable(summary_ ? summary_(answer) : answer);
        std::cout.flush();
        if (!std::cout)
            throw InputError("the answer could not be written", "standard output",
                             "Check that the disk is not full and the pipe not closed");
        return exit_done;
    } catch (const Cancelled&) {
        spdlog::warn("interrupted");
        return exit_interrupted;
    } catch (const UsageError& error) {
        return report(error, exit_bad_usage);
    } catch (const Error& error) {
        return report(error, exit_bad_input);
    } catch (const std::filesystem::filesystem_error& error) {
        const std::string other =
            error.path2().empty() ? "" : " (with " + error.path2().string() + ")";
        spdlog::error("{}: {}{}", error.path1().string(), error.code().message(), other);
        spdlog::error("Check that it is there, may be used, and leads round in no circle of links");
        return exit_bad_input;
    } catch (const std::bad_alloc&) {
        spdlog::error("not enough memory");
        spdlog::error(
            "Close other programs, or give less: a smaller image or one cropped with --liver-mask, "
            "or a case of fewer --tetrahedra");
        return exit_internal;
    } catch (const std::exception& error) {
        spdlog::error("internal error: {}", error.what());
        return exit_internal;
    }
}

CLI::Validator whole_number_from(std::int64_t least) {
    const std::string range = "from " + std::to_string(least) + " to " +
                              std::to_string(std::numeric_limits<std::int64_t>::max());
    const auto check = [=](const std::string& text) -> std::string {
        std::int64_t value = 0;
        const char* const end = text.data() + text.size();
        const auto [rest, error] = std::from_chars(text.data(), end, value);
        if (error == std::errc{} && rest == end && value >= least) return {};
        return "\"" + text + "\" is no whole number " + range;
    };
    return {check, range};
}

void require_utf8(const std::string& option, const std::string& text) {
    if (!is_utf8(text))
        throw UsageError("is no text in UTF-8", option, "Write it in letters of UTF-8");
}

std::array<double, 3> parse_triple(const std::string& option, const std::string& text) {
    std::array<double, 3> values{};
    const char* at = text.data();
    const char* const end = at + text.size();
    for (int i = 0; i < 3; ++i) {
        if (i > 0 && (at == end || *at++ != ','))
            throw UsageError("\"" + text + "\" is not three numbers", option,
                             "Write them as X,Y,Z with a decimal point");
        const auto [rest, error] = std::from_chars(at, end, values[i]);
        if (error != std::errc{} || !std::isfinite(values[i]))
            throw UsageError("\"" + text + "\" is not three numbers", option,
                             "Write them as X,Y,Z with a decimal point");
        at = rest;
    }
    if (at != end)
        throw UsageError("\"" + text + "\" has more than three numbers", option,
                         "Write them as X,Y,Z with a decimal point");
    return values;
}

}  // namespace hepatica
