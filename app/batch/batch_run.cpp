// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/batch_run.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <memory>
#include <new>

#include "app/batch/batch_inputs.h"
#include "app/batch/batch_record.h"
#include "app/batch/batch_report.h"
#include "app/batch/names_file.h"
#include "app/case_picture.h"
#include "app/output_place.h"
#include "core/base/error.h"
#include "core/base/quoted_name.h"
#include "core/reconstruction/reconstruct_parameters.h"

namespace hepatica {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

// The place of an error is usually a path, which may contain the scan's name.
std::string in_words(const Error& error, bool with_place) {
    const std::string where = !with_place || error.place().empty() ? "" : error.place() + ": ";
    return without_names(where + error.problem() + ". " + error.remedy());
}

BatchRecord made(const BatchOptions& batch, const BatchInput& input, Job& job) {
    const auto begin = std::chrono::steady_clock::now();
    ReconstructOptions options = batch.reconstruct;
    options.ct = input.ct;
    options.liver_mask = input.liver_mask;
    Reconstruction found = reconstruct(options, job);
    write_case(batch.out / "cases" / (input.patient + ".hep"), found.patient);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    BatchRecord record = record_of(input.patient, found.patient, found.warnings, time.count());
    if (!batch.liver_masks.empty() && !input.liver_mask)
        record.doubts.emplace_back("No mask belonged to this scan: its liver was searched.");
    record.has_picture =
        write_case_picture(std::make_shared<const PatientCase>(std::move(found.patient)),
                           batch.out / "pictures" / (input.patient + ".png"), job);
    return record;
}

// Turns a failure into the patient's record, so that the batch continues with the others. Throws
// only Cancelled.
BatchRecord made_or_failed(const BatchOptions& batch, const BatchInput& input, Job& job) {
    BatchRecord failed;
    failed.patient = input.patient;
    const auto begin = std::chrono::steady_clock::now();
    try {
        return made(batch, input, job);
    } catch (const Cancelled&) {
        throw;
    } catch (const Error& error) {
        failed.reason = in_words(error, batch.keep_names);
    } catch (const std::bad_alloc&) {
        failed.reason = "Not enough memory.";
    } catch (const std::exception& error) {
        // Its text may hold a path that contains the scan's name.
        spdlog::error("{}: internal error: {}", input.patient, error.what());
        failed.reason = "Internal error.";
    }
    failed.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return failed;
}

// The options that a later call must repeat. The folder of scans is not among them, because it may
// have moved.
Json beginning(const BatchOptions& options) {
    return {{"format", "hepatica-batch"},
            {"liver_masks", !options.liver_masks.empty()},
            {"keep_names", options.keep_names},
            {"parameters", Json::parse(parameters_json(options.reconstruct))}};
}

void say(const BatchRecord& record) {
    char seconds[32];
    std::snprintf(seconds, sizeof seconds, "%.1f s", record.seconds);
    if (!record.done) {
        spdlog::warn("{}: failed after {}: {}", record.patient, seconds, record.reason);
        return;
    }
    spdlog::info("{}: done in {}, {} in doubt", record.patient, seconds, record.doubts.size());
    for (const std::string& doubt : record.doubts) spdlog::info("{}: {}", record.patient, doubt);
}

// A folder of masks of which none is called like a scan is another folder than was meant.
void require_masks(const std::vector<BatchInput>& inputs, const fs::path& liver_masks) {
    const bool any = std::ranges::any_of(
        inputs, [](const BatchInput& input) { return input.liver_mask.has_value(); });
    if (!liver_masks.empty() && !any)
        throw InputError("holds no liver mask of any of the scans", liver_masks.string(),
                         "Call each mask like its scan: NAME.nii.gz belongs to the scan NAME");
}

// Among the scans OUT would be taken for one of them by the next call, and the shares of all jobs
// would be others.
void require_apart(const fs::path& out, const fs::path& scans) {
    const auto whole = [](const fs::path& path) {
        return fs::weakly_canonical(fs::absolute(path));
    };
    const fs::path below = whole(out).lexically_relative(whole(scans));
    if (!below.empty() && *below.begin() != "..")
        throw UsageError("lies among the scans of " + scans.string(), "--out " + out.string(),
                         "Name a folder outside of them");
}

}  // namespace

Json run_batch(const BatchOptions& options, Job& job) {
    require_apart(options.out, options.folder);
    std::vector<BatchInput> all = batch_inputs(options.folder, options.liver_masks);
    require_masks(all, options.liver_masks);
    if (!options.keep_names) use_pseudonyms(all);
    require_writable_folder(options.out);
    require_own_or_new(options.out, batch_mark);
    open_batch(options.out, beginning(options));
    if (!options.keep_names) write_names(options.out, all);
    for (const char* folder : {"cases", "pictures"}) fs::create_directories(options.out / folder);
    std::vector<std::string> patients;
    for (const BatchInput& input : all) patients.push_back(input.patient);
    std::vector<BatchInput> open;
    for (const BatchInput& input : share_of(all, options.task, options.tasks)) {
        const auto record = read_record(options.out, input.patient);
        if (!record || (!record->done && options.retry)) open.push_back(input);
    }
    job.expect_stages(static_cast<int>(open.size()));
    write_batch_report(options.out, patients);
    for (const BatchInput& input : open) {
        job.begin_stage(input.scan == input.patient ? input.scan
                                                    : input.scan + " (" + input.patient + ")");
        Job one;
        one.observe([&](JobEvent) {
            if (job.cancelled()) one.cancel();
        });
        const BatchRecord record = made_or_failed(options, input, one);
        say(record);
        write_record(options.out, record);
        write_batch_report(options.out, patients);
    }
    std::size_t done = 0, failed = 0;
    for (const std::string& patient : patients)
        if (const auto record = read_record(options.out, patient)) ++(record->done ? done : failed);
    return {{"out", options.out.string()},
            {"patients", patients.size()},
            {"done", done},
            {"failed", failed},
            {"made_now", open.size()},
            {"summary", (options.out / "summary.csv").string()},
            {"page", (options.out / "index.html").string()}};
}

}  // namespace hepatica
