// SPDX-License-Identifier: GPL-3.0-or-later
// Prints how well each method segments the patients that have a truth. For the tables of the
// documentation and for whoever changes a parameter:
//   segmentation_scores [ircadb|ircadb-thick|vascusynth|phantom|phantom-thick ...]
//       [--method coherent|multi_layer|vesselness] [--noise-hu S] [--no-liver] [--refine N]
//       [--seeds N] [--spacing MM] [--bounds]
// --bounds also prints what the best single threshold of the smoothed image reaches, chosen by the
// truth, and what the result would score if the truth told it which vessels to leave out.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/image/filters.h"
#include "core/image/morphology.h"
#include "core/segmentation/liver_region.h"
#include "tests/reconstruction/segmentation_score.h"

namespace {

using namespace hepatica;
using namespace hepatica::testing_support;

struct Request {
    std::vector<std::string> cases;
    std::vector<SegmentationMethod> methods;
    double noise_hu = 0.0;
    double spacing_mm = 0.0;
    bool liver = true;
    bool bounds = false;
    int refine = -1;
    int seeds = 1;
};

Request parse(int count, char** words) {
    Request request;
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        const auto value = [&] { return std::string(i + 1 < count ? words[++i] : ""); };
        if (word == "--method") {
            const std::string wanted = value();
            for (const auto m : {SegmentationMethod::multi_layer, SegmentationMethod::vesselness,
                                 SegmentationMethod::coherent})
                if (wanted == "all" || wanted == name_of(m)) request.methods.push_back(m);
        } else if (word == "--noise-hu") {
            request.noise_hu = std::atof(value().c_str());
        } else if (word == "--spacing") {
            request.spacing_mm = std::atof(value().c_str());
        } else if (word == "--refine") {
            request.refine = std::atoi(value().c_str());
        } else if (word == "--seeds") {
            request.seeds = std::atoi(value().c_str());
        } else if (word == "--bounds") {
            request.bounds = true;
        } else if (word == "--no-liver") {
            request.liver = false;
        } else {
            request.cases.push_back(word);
        }
    }
    if (request.methods.empty()) request.methods = {SegmentationMethod::coherent};
    if (request.cases.empty()) request.cases = {"ircadb", "vascusynth", "phantom"};
    return request;
}

std::vector<Patient> patients(const std::string& name, int seeds, Job& job) {
    std::vector<Patient> list;
    if (name == "ircadb") list.push_back(ircadb_patient(job));
    if (name == "ircadb-thick") list.push_back(thinned_out(ircadb_patient(job), 2));
    if (name == "vascusynth") list.push_back(vascusynth_patient(job));
    for (int seed = 1; seed <= seeds; ++seed) {
        if (name == "phantom") list.push_back(phantom_patient(std::uint64_t(seed), 1.0, job));
        if (name == "phantom-thick") list.push_back(phantom_patient(std::uint64_t(seed), 3.0, job));
    }
    return list;
}

// Where the truth draws walls: the intensity half way over them, between parenchyma (0) and the
// inside of vessels wide enough to have one (1). In the plane, where the resolution is best.
double level_of_outlines(const Patient& patient, double parenchyma_hu, Job& job) {
    const Mask core = erode(patient.truth, 1.2, job);
    const Mask near_core = dilate(core, 3.0, job);
    const Volume& ct = patient.ct;
    double core_sum = 0.0, wall_sum = 0.0;
    std::size_t core_count = 0, wall_count = 0;
    const std::size_t steps[] = {1, static_cast<std::size_t>(ct.grid.dims[0])};
    for (std::size_t i = 0; i + steps[1] < ct.voxels.size(); ++i) {
        if (core.voxels[i] && patient.judged.voxels[i]) {
            core_sum += ct.voxels[i];
            ++core_count;
        }
        for (const std::size_t step : steps) {
            const std::size_t n = i + step;
            if ((patient.truth.voxels[i] != 0) == (patient.truth.voxels[n] != 0)) continue;
            if (!near_core.voxels[i] || !near_core.voxels[n]) continue;
            if (!patient.judged.voxels[i] || !patient.judged.voxels[n]) continue;
            wall_sum += 0.5 * (ct.voxels[i] + ct.voxels[n]);
            ++wall_count;
        }
    }
    return (wall_sum / double(wall_count) - parenchyma_hu) /
           (core_sum / double(core_count) - parenchyma_hu);
}

void print_bounds(const Patient& patient, const Mask& found, Job& job) {
    FloatVolume smooth = to_float(patient.ct);
    gaussian_smooth(smooth, Vec3::Constant(0.8), job);
    double best = 0.0;
    float best_hu = 0.0f;
    for (float hu = 120.0f; hu <= 180.0f; hu += 2.0f) {
        std::size_t both = 0, sum = 0;
        for (std::size_t i = 0; i < smooth.voxels.size(); ++i) {
            if (!patient.judged.voxels[i]) continue;
            const bool bright = smooth.voxels[i] > hu;
            both += bright && patient.truth.voxels[i];
            sum += std::size_t(bright) + (patient.truth.voxels[i] != 0);
        }
        const double dice = sum > 0 ? 2.0 * double(both) / double(sum) : 0.0;
        if (dice > best) {
            best = dice;
            best_hu = hu;
        }
    }
    constexpr double near_mm = 1.5;
    Patient told = patient;
    const Mask near_truth = dilate(patient.truth, near_mm, job);
    for (std::size_t i = 0; i < told.judged.voxels.size(); ++i)
        if (!near_truth.voxels[i]) told.judged.voxels[i] = 0;
    const Score s = score(found, told, job);
    std::printf("    best single threshold (%.0f HU)  dice %.4f\n", double(best_hu), best);
    std::printf("    told which vessels to leave out dice %.4f P %.3f R %.3f cldice %.4f\n", s.dice,
                s.precision, s.recall, s.cldice);
}

void run(const Patient& patient, SegmentationMethod method, const Request& request) {
    SegmentationOptions options;
    options.method = method;
    options.spacing_mm = request.spacing_mm;
    if (request.liver) options.liver = patient.liver;
    if (request.refine >= 0) options.refinement_recursions = request.refine;
    Job job;
    const auto start = std::chrono::steady_clock::now();
    const Segmentation found = segment_vessels(patient.ct, options, job);
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const Score s = score(found.mask, patient, job);
    if (!request.liver) {
        Patient organ = patient;
        organ.truth = close_liver(patient.liver, 8.0, job);
        organ.judged = Mask(patient.ct.grid, 1);
        const Score l = score(found.liver, organ, job);
        std::printf("liver found without a mask: dice %.3f P %.3f R %.3f\n", l.dice, l.precision,
                    l.recall);
    }
    std::printf(
        "%-24s %-11s dice %.4f P %.3f R %.3f cldice %.4f P %.3f R %.3f length>1.2 %.3f  "
        "components %d  parenchyma %.0f contrast %.0f noise %.1f HU  %.1f s\n",
        patient.name.c_str(), name_of(method).c_str(), s.dice, s.precision, s.recall, s.cldice,
        s.centreline_precision, s.centreline_recall,
        length_found(found.mask, patient, 1.2, 2.0, job), found.components,
        found.statistics.parenchyma_hu, found.statistics.contrast_hu(), found.statistics.noise_hu,
        seconds);
    if (request.bounds) {
        print_bounds(patient, found.mask, job);
        std::printf("    the truth's outlines run at %.2f of the vessels' rise\n",
                    level_of_outlines(patient, found.statistics.parenchyma_hu, job));
    }
    for (const StageTime& stage : job.stage_times())
        std::printf("    %-28s %.2f s\n", stage.name.c_str(), stage.seconds);
    std::fflush(stdout);
}

}  // namespace

int main(int count, char** words) {
    try {
        const Request request = parse(count, words);
        for (const std::string& name : request.cases) {
            Job job;
            for (Patient& patient : patients(name, request.seeds, job)) {
                if (request.noise_hu > 0.0) add_noise(patient.ct, request.noise_hu, 1, job);
                for (const SegmentationMethod method : request.methods)
                    run(patient, method, request);
            }
        }
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n%s\n", error.what(), error.remedy().c_str());
        return 1;
    }
    return 0;
}
