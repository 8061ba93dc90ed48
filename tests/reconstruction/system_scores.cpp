// SPDX-License-Identifier: GPL-3.0-or-later
// Prints how well the vascular systems of patients are told apart whose systems are known, by
// reconstructions with the defaults. For the tables of the documentation and for whoever changes
// how systems are told apart:
//   system_scores [ircadb01_case01|ircadb01_case07|vascusynth|sksurgery_liver|touching|randomised
//       ...] [--phantoms N] [--first NUMBER] [--model FILE] [--offers FILE [--take CONFIDENCE]]
//       [--no-mask] [--seeds] [--case NAME=CASE] [--stages] [--keep FOLDER]
// Without names, the first five; `touching` stands for N phantoms (20) whose systems touch,
// `randomised` for N patients drawn at random from NUMBER (1) on, which no training draws.
// --model chooses lines by a model. --offers offers branches by one and says which share of their
// length lies within 2 mm of the truth, by confidence; --take takes those of this confidence or
// more before the tree is judged. --no-mask lets the liver be found.
// --seeds gives one seed in each system's trunk, taken from the truth. --case judges a case that is
// there already in place of a reconstruction, by the truth of NAME. --stages adds what each stage
// of the reconstruction cost. --keep leaves the CTs that were made in FOLDER.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "core/accuracy/system_scores.h"
#include "core/base/error.h"
#include "core/patient/corrections.h"
#include "core/reconstruction/reconstruct.h"
#include "core/tree/extraction/centreline_locator.h"
#include "tests/reconstruction/system_patients.h"

namespace {

namespace fs = std::filesystem;
using namespace hepatica;
using namespace hepatica::testing_support;

constexpr double seed_inwards_mm = 8.0;  // from where the trunk ends

struct Request {
    std::vector<std::string> names;
    std::map<std::string, fs::path> cases;
    int phantoms = 20;
    std::uint64_t first = 1;
    bool seeds = false, stages = false, liver_given = true;
    fs::path keep, model, offers;
    double take = 2.0;  // above 1: none
};

// Points of offered branches by tenths of confidence, and those of them near the truth.
struct Offers {
    std::array<long, 10> points{}, near{};
};

Request parse(int count, char** words) {
    Request request;
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        const auto value = [&] { return std::string(i + 1 < count ? words[++i] : ""); };
        if (word == "--phantoms") {
            request.phantoms = std::atoi(value().c_str());
        } else if (word == "--first") {
            request.first = std::strtoull(value().c_str(), nullptr, 10);
        } else if (word == "--model") {
            request.model = value();
        } else if (word == "--offers") {
            request.offers = value();
        } else if (word == "--take") {
            request.take = std::atof(value().c_str());
        } else if (word == "--no-mask") {
            request.liver_given = false;
        } else if (word == "--seeds") {
            request.seeds = true;
        } else if (word == "--stages") {
            request.stages = true;
        } else if (word == "--keep") {
            request.keep = value();
        } else if (word == "--case") {
            const std::string text = value();
            const std::size_t sign = text.find('=');
            if (sign == std::string::npos)
                throw UsageError("\"" + text + "\" names no patient", "--case", "Give NAME=CASE");
            request.names.push_back(text.substr(0, sign));
            request.cases[request.names.back()] = text.substr(sign + 1);
        } else {
            request.names.push_back(word);
        }
    }
    if (request.names.empty())
        request.names = {"ircadb01_case01", "ircadb01_case07", "vascusynth", "sksurgery_liver",
                         "touching"};
    return request;
}

// What one row of the table holds; negative where there is nothing.
struct Row {
    std::string name;
    std::vector<double> values;
};

const std::vector<std::pair<const char*, int>> columns{
    {"right", 3},          {"vessels R", 3},       {"vessels P", 3}, {"portal R", 3},
    {"portal P", 3},       {"portal sDice", 3},    {"hepatic R", 3}, {"hepatic P", 3},
    {"hepatic sDice", 3},  {"false joins", 2},     {"breaks", 2},    {"loops", 2},
    {"portal root mm", 1}, {"hepatic root mm", 1}, {"seconds", 1}};

void print_head() {
    std::printf("| patient |");
    for (const auto& [name, digits] : columns) std::printf(" %s |", name);
    std::printf("\n| --- |");
    for (std::size_t i = 0; i < columns.size(); ++i) std::printf(" --- |");
    std::printf("\n");
}

void print(const Row& row) {
    std::printf("| %s |", row.name.c_str());
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (row.values[i] < 0.0)
            std::printf(" none |");
        else
            std::printf(" %.*f |", columns[i].second, row.values[i]);
    }
    std::printf("\n");
    std::fflush(stdout);
}

Row row_of(const std::string& name, const SystemScores& scores, double seconds) {
    const auto of = [&](VascularSystem system) {
        for (const SystemScore& score : scores.systems)
            if (score.system == system) return score;
        return SystemScore{};
    };
    const SystemScore portal = of(VascularSystem::portal), hepatic = of(VascularSystem::hepatic);
    return {name,
            {scores.system_right, scores.vessels.length_recall, scores.vessels.length_precision,
             portal.length_recall, portal.length_precision, portal.surface_dice.value_or(-1),
             hepatic.length_recall, hepatic.length_precision, hepatic.surface_dice.value_or(-1),
             static_cast<double>(scores.false_joins), static_cast<double>(scores.breaks),
             static_cast<double>(scores.loops), portal.root_error_mm.value_or(-1),
             hepatic.root_error_mm.value_or(-1), seconds}};
}

// The mean over rows, of what each has.
Row mean_of(const std::vector<Row>& rows) {
    Row mean{"mean of " + std::to_string(rows.size()), std::vector<double>(columns.size(), -1.0)};
    for (std::size_t i = 0; i < columns.size(); ++i) {
        double sum = 0.0;
        int count = 0;
        for (const Row& row : rows)
            if (row.values[i] >= 0.0) {
                sum += row.values[i];
                ++count;
            }
        if (count > 0) mean.values[i] = sum / count;
    }
    return mean;
}

PatientCase made_case(const SystemPatient& patient, const KnownSystems& known,
                      const Request& request, double& seconds) {
    ReconstructOptions options;
    options.ct = patient.ct;
    if (request.liver_given) options.liver_mask = patient.liver_mask;
    if (!request.model.empty()) options.model = request.model;
    if (!request.offers.empty()) options.offers = request.offers;
    if (request.seeds)
        for (const KnownSystem& system : known.all())
            if (const auto seed = known.point_in_trunk(system, seed_inwards_mm))
                options.seeds.push_back({*seed, system.system});
    Job job;
    const auto start = std::chrono::steady_clock::now();
    Reconstruction made = reconstruct(options, job);
    seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (request.stages)
        for (const StageTime& stage : job.stage_times())
            std::printf("    %-36s %.2f s\n", stage.name.c_str(), stage.seconds);
    return std::move(made.patient);
}

void count_offers(const SystemPatient& patient, const PatientCase& found, Offers& offers) {
    constexpr double near_mm = 2.0;  // as SystemScoreOptions::length_tolerance_mm
    Job job;
    std::vector<CentrelineLocator> truths;
    for (const SystemTruth& truth : patient.truths)
        truths.emplace_back(truth.tree.segments.empty() ? centrelines_of(truth.mask, job)
                                                        : truth.tree);
    for (const Bridge& branch : found.corrections.bridges) {
        if (!branch.is_branch()) continue;
        const auto tenth = static_cast<std::size_t>(std::min(9.0, 10.0 * branch.confidence));
        for (const Vec3& point_mm : branch.path_mm) {
            ++offers.points[tenth];
            offers.near[tenth] += std::ranges::any_of(truths, [&](const CentrelineLocator& truth) {
                return truth.nearest(point_mm, near_mm).has_value();
            });
        }
    }
}

void print(const Offers& offers) {
    long points = 0, near = 0;
    for (std::size_t tenth = 0; tenth < 10; ++tenth) {
        points += offers.points[tenth];
        near += offers.near[tenth];
        const auto of = static_cast<double>(offers.points[tenth]);
        if (of > 0.0)
            std::printf("    offered with %.1f: %.3f of %.0f points near the truth\n",
                        0.1 * static_cast<double>(tenth),
                        static_cast<double>(offers.near[tenth]) / of, of);
    }
    if (points > 0)
        std::printf("    offered in all: %.3f of %ld\n",
                    static_cast<double>(near) / static_cast<double>(points), points);
}

Row judged(const SystemPatient& patient, const Request& request, Offers& offers) {
    Job job;
    const KnownSystems known(patient.truths, patient.liver ? &*patient.liver : nullptr, nullptr, {},
                             job);
    double seconds = -1.0;
    const auto given = request.cases.find(patient.name);
    PatientCase found = given != request.cases.end() ? read_case(given->second)
                                                     : made_case(patient, known, request, seconds);
    count_offers(patient, found, offers);
    if (request.take <= 1.0) found = with_edited_tree(found, acceptances(found, request.take, job));
    return row_of(patient.name, judge_systems(found.tree, found.mask, known, {}, job), seconds);
}

void run(const std::string& name, const Request& request, const fs::path& folder) {
    Job job;
    Offers offers;
    if (name == "touching" || name == "randomised") {
        std::vector<Row> rows;
        for (int k = 0; k < request.phantoms; ++k) {
            const std::uint64_t number = request.first + static_cast<std::uint64_t>(k);
            const fs::path own = folder / (name + std::to_string(number));
            try {
                rows.push_back(judged(name == "touching" ? touching_phantom(number, own, job)
                                                         : randomised_patient(number, own, job),
                                      request, offers));
                print(rows.back());
            } catch (const Error& error) {
                std::printf("| %s phantom %llu | %s |\n", name.c_str(),
                            static_cast<unsigned long long>(number), error.what());
            }
            if (request.keep.empty()) fs::remove_all(own);
        }
        if (!rows.empty()) print(mean_of(rows));
    } else if (name == "vascusynth") {
        print(judged(patient_of_vascusynth(job), request, offers));
    } else if (name == "sksurgery_liver") {
        print(judged(patient_of_surfaces(folder / name, job), request, offers));
    } else if (name.starts_with("ircadb")) {
        print(judged(patient_of_ircadb(name, job), request, offers));
    } else {
        throw UsageError("\"" + name + "\" is no patient", "", "See the head of this file");
    }
    print(offers);
}

}  // namespace

int main(int count, char** words) {
    try {
        const Request request = parse(count, words);
        const fs::path folder =
            request.keep.empty()
                ? fs::temp_directory_path() / ("system_scores_" + std::to_string(getpid()))
                : request.keep;
        print_head();
        for (const std::string& name : request.names) run(name, request, folder);
        if (request.keep.empty()) fs::remove_all(folder);
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n%s\n", error.what(), error.remedy().c_str());
        return 1;
    }
    return 0;
}
