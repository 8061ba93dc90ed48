// SPDX-License-Identifier: GPL-3.0-or-later
// bench reconstruct: time, responsiveness to cancelling and peak memory of a reconstruction, stage
// by stage (core/study/job_watch.h).
#include <signal.h>
#include <spawn.h>
#include <spdlog/spdlog.h>
#include <sys/wait.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "app/output_place.h"
#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/reconstruction/reconstruct.h"
#include "core/study/job_watch.h"

extern char** environ;

namespace hepatica {

namespace fs = std::filesystem;

namespace {

struct BenchReconstructChoices {
    fs::path ct;  // empty: a synthetic patient
    fs::path liver_mask;
    fs::path vessel_mask;
    std::string dims = "512,512,300";
    std::string spacing = "0.65,0.65,0.8";
    fs::path out = "out/bench_reconstruct";
    int seed = 1;
};

// Waits for the end of a child, which is told to end where the job is cancelled.
int status_of(pid_t child, const Job& job) {
    {
        const std::stop_callback told(job.stop_token(), [child] { kill(child, SIGTERM); });
        siginfo_t end{};
        while (waitid(P_PID, static_cast<id_t>(child), &end, WEXITED | WNOWAIT) != 0 &&
               errno == EINTR) {
        }
    }
    int status = -1;
    waitpid(child, &status, 0);
    return status;
}

// Ctrl-C at a terminal reaches the child as well, which may end before this job is cancelled.
bool was_interrupted(int status) {
    if (WIFSIGNALED(status))
        return WTERMSIG(status) == SIGINT || WTERMSIG(status) == SIGTERM ||
               WTERMSIG(status) == SIGHUP;
    return WIFEXITED(status) && WEXITSTATUS(status) == exit_interrupted;
}

// Runs in a separate process, so that this one's peak memory is that of the reconstruction.
void make_phantom_elsewhere(const BenchReconstructChoices& options, const Job& job) {
    std::vector<std::string> words{"hepatica-cli",
                                   "phantom",
                                   (options.out / "patient").string(),
                                   "--seed",
                                   std::to_string(options.seed),
                                   "--dims",
                                   options.dims,
                                   "--spacing",
                                   options.spacing,
                                   "--format",
                                   "nifti",
                                   "--quiet"};
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t silent;
    posix_spawn_file_actions_init(&silent);
    posix_spawn_file_actions_addopen(&silent, 1, "/dev/null", 1 /* O_WRONLY */, 0);
    pid_t child = 0;
    const int failed =
        posix_spawn(&child, "/proc/self/exe", &silent, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&silent);
    const int status = failed == 0 ? status_of(child, job) : -1;
    job.throw_if_cancelled();
    if (failed == 0 && was_interrupted(status)) throw Cancelled();
    if (status != 0)
        throw InputError("the synthetic patient could not be made", options.out.string(),
                         "Try hepatica-cli phantom with the same --dims and --spacing");
}

Json to_json(const WatchedStage& stage) {
    return {{"name", stage.name},
            {"wall_s", stage.whole.wall_s},
            {"cpu_s", stage.whole.cpu_s},
            {"longest_unheard_cancel_s", stage.longest_check.wall_s},
            {"longest_unheard_cancel_cpu_s", stage.longest_check.cpu_s},
            {"longest_without_progress_s", stage.longest_progress.wall_s},
            {"longest_without_progress_cpu_s", stage.longest_progress.cpu_s},
            {"checks", stage.checks},
            {"reports", stage.reports}};
}

Json run_bench_reconstruct(BenchReconstructChoices options, Job& job) {
    require_writable_folder(options.out);
    require_replaceable_case(options.out / "patient.hep");
    const bool synthetic = options.ct.empty();
    if (synthetic) {
        fs::create_directories(options.out);
        spdlog::info("a synthetic patient is made");
        make_phantom_elsewhere(options, job);
        options.ct = options.out / "patient" / "ct.nii.gz";
        options.liver_mask = options.out / "patient" / "liver.nii.gz";
    }
    ReconstructOptions reconstruction;
    reconstruction.offers = shipped_link_model();  // as everybody reconstructs
    reconstruction.ct = options.ct;
    if (!options.liver_mask.empty()) reconstruction.liver_mask = options.liver_mask;
    if (!options.vessel_mask.empty()) reconstruction.vessel_mask = options.vessel_mask;
    const JobWatch watch(job);
    job.expect_stages(stage_count(reconstruction) + 1);
    const Reconstruction made = reconstruct(reconstruction, job);
    job.begin_stage("Writing the case");
    fs::create_directories(options.out);
    write_case_in_job(options.out / "patient.hep", made.patient, job);

    Json answer;
    answer["dims"] = made.patient.source.image_grid.dims;
    answer["stages"] = Json::array();
    WatchedTime total, check, progress;
    for (const WatchedStage& stage : watch.stages()) {
        answer["stages"].push_back(to_json(stage));
        total = {total.wall_s + stage.whole.wall_s, total.cpu_s + stage.whole.cpu_s};
        check.wall_s = std::max(check.wall_s, stage.longest_check.wall_s);
        check.cpu_s = std::max(check.cpu_s, stage.longest_check.cpu_s);
        progress.wall_s = std::max(progress.wall_s, stage.longest_progress.wall_s);
        progress.cpu_s = std::max(progress.cpu_s, stage.longest_progress.cpu_s);
    }
    answer["total"] = {{"wall_s", total.wall_s},
                       {"cpu_s", total.cpu_s},
                       {"longest_unheard_cancel_s", check.wall_s},
                       {"longest_unheard_cancel_cpu_s", check.cpu_s},
                       {"longest_without_progress_s", progress.wall_s},
                       {"longest_without_progress_cpu_s", progress.cpu_s}};
    answer["mask_voxels"] = made.checks.mask.voxels;
    answer["peak_memory_mb"] = static_cast<double>(peak_memory_bytes()) / 1e6;
    return answer;
}

}  // namespace

void add_bench_reconstruct(CommandLine& line) {
    auto options = std::make_shared<BenchReconstructChoices>();
    CLI::App& verb =
        line.add_verb("bench", "Benchmarks", "reconstruct",
                      "From CT to case: seconds, the longest wait for a cancel and for "
                      "progress in each stage, and the peak of memory",
                      [options](Job& job) { return run_bench_reconstruct(*options, job); });
    CLI::Option* ct =
        verb.add_option("ct", options->ct, "CT to reconstruct; without it a synthetic patient");
    verb.add_option("--liver-mask", options->liver_mask, "As of reconstruct")->needs(ct);
    verb.add_option("--vessel-mask", options->vessel_mask, "As of reconstruct")->needs(ct);
    verb.add_option("--dims", options->dims, "Voxels of the synthetic patient, x,y,z")
        ->capture_default_str();
    verb.add_option("--spacing", options->spacing, "Size of its voxels, x,y,z [mm]")
        ->capture_default_str();
    verb.add_option("--seed", options->seed, "Which synthetic patient")
        ->check(whole_number_from(0))
        ->capture_default_str();
    for (const char* of_synthetic : {"--dims", "--spacing", "--seed"})
        ct->excludes(verb.get_option(of_synthetic));
    verb.add_option("--out", options->out, "Folder for the patient and the case")
        ->capture_default_str();
}

}  // namespace hepatica
