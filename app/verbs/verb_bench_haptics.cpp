// SPDX-License-Identifier: GPL-3.0-or-later
// bench haptics: processor time of the haptic loop's periods beside a play
// (core/study/haptic_study.h).
#include <filesystem>
#include <memory>

#include "app/verbs/verbs.h"
#include "core/patient/patient_case.h"
#include "core/study/haptic_study.h"

namespace hepatica {

namespace {

struct BenchHapticsChoices {
    std::filesystem::path patient;  // empty: a tree of the program's own
    HapticStudyOptions study;
};

Json run_bench_haptics(const BenchHapticsChoices& choices, Job& job) {
    std::shared_ptr<const PatientCase> patient;
    if (!choices.patient.empty())
        patient = std::make_shared<const PatientCase>(read_case_without_voxels(choices.patient));
    const HapticStudy study = study_haptics(patient, choices.study, job);
    return {{"seconds", choices.study.seconds},
            {"threads", choices.study.threads},
            {"periods", study.periods},
            {"in_time", study.in_time},
            {"median_us", study.median_us},
            {"p999_us", study.p999_us},
            {"longest_us", study.longest_us},
            {"late", study.late},
            {"contacts", study.contacts},
            {"contacts_most", study.contacts_most},
            {"full", study.full},
            {"work_nj", study.work_nj},
            {"steps", study.steps},
            {"step_ms", study.step_ms},
            {"tetrahedra", study.tetrahedra}};
}

}  // namespace

void add_bench_haptics(CommandLine& line) {
    const auto choices = std::make_shared<BenchHapticsChoices>();
    CLI::App& verb =
        line.add_verb("bench", "Benchmarks", "haptics",
                      "Processor time of the haptic loop's periods while a play runs beside it",
                      [choices](Job& job) { return run_bench_haptics(*choices, job); });
    verb.add_option("case", choices->patient,
                    "Case to play on; a tree of the program's own without");
    verb.add_option("--seconds", choices->study.seconds, "Measured")
        ->check(CLI::Range(0.1, 3600.0))
        ->capture_default_str();
    verb.add_option("--threads", choices->study.threads, "Of the play")
        ->check(CLI::Range(1, 256))
        ->capture_default_str();
}

}  // namespace hepatica
