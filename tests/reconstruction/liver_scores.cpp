// SPDX-License-Identifier: GPL-3.0-or-later
// Prints how good the liver is that the program finds, against what experts or a phantom drew. For
// the tables of the documentation and for whoever changes a parameter:
//   liver_scores [ircadb01_case01|ircadb01_case07|totalseg_dicom ...] [--bodies FIRST-LAST]
//       [--case CASE.hep LIVER_MASK]
// --bodies: randomised synthetic ones (tests/segmentation/random_abdomen.h). --case: the share of
// each of Couinaud's segments of a case that lies outside of an expert's closed liver.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "core/accuracy/organ_score.h"
#include "core/base/error.h"
#include "core/image/filters.h"
#include "core/image/volume_reader.h"
#include "core/segmentation/liver_region.h"
#include "tests/reconstruction/segmentation_score.h"
#include "tests/segmentation/random_abdomen.h"

namespace {

using namespace hepatica;
namespace fs = std::filesystem;

constexpr double vessels_closed_mm = 8.0;
constexpr int segments = 8;

OrganScore scored(const std::string& name, const Volume& ct, const Mask& truth, Job& job) {
    const auto start = std::chrono::steady_clock::now();
    const Mask found = find_liver(ct, job).liver;
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    const OrganScore score = organ_score(found, truth, job);
    std::printf("| %s | %.3f | %.3f | %.3f | %.1f | %.1f |\n", name.c_str(), score.dice,
                score.outside_share, score.missed_share, score.surface_mean_mm, seconds.count());
    std::fflush(stdout);
    return score;
}

void of_patient(const std::string& name, Job& job) {
    const fs::path folder = testing_support::data_folder() / name;
    if (name == "totalseg_dicom") {
        const int liver[] = {5};
        scored(name, read_volume(folder / "dicom", job),
               read_mask(folder / "example_seg_dicom.nii.gz", job, liver), job);
        return;
    }
    scored(name, read_volume(folder / "PATIENT_DICOM", job),
           close_liver(read_mask(folder / "masks" / "liver.nii.gz", job), vessels_closed_mm, job),
           job);
}

void of_bodies(const std::string& range, Job& job) {
    const int first = std::atoi(range.c_str());
    const int last = std::atoi(range.substr(range.find('-') + 1).c_str());
    OrganScore sum{0.0, 0.0, 0.0, 0.0}, worst{1.0, 0.0, 0.0, 0.0};
    for (int seed = first; seed <= last; ++seed) {
        const test::RandomAbdomen body =
            test::random_abdomen({.seed = static_cast<std::uint64_t>(seed)});
        const OrganScore score = scored("body " + std::to_string(seed), body.ct, body.liver, job);
        sum.dice += score.dice;
        sum.outside_share += score.outside_share;
        sum.missed_share += score.missed_share;
        sum.surface_mean_mm += score.surface_mean_mm;
        worst.dice = std::min(worst.dice, score.dice);
        worst.outside_share = std::max(worst.outside_share, score.outside_share);
        worst.missed_share = std::max(worst.missed_share, score.missed_share);
        worst.surface_mean_mm = std::max(worst.surface_mean_mm, score.surface_mean_mm);
    }
    const double n = last - first + 1;
    std::printf("| mean | %.3f | %.3f | %.3f | %.1f | |\n", sum.dice / n, sum.outside_share / n,
                sum.missed_share / n, sum.surface_mean_mm / n);
    std::printf("| worst | %.3f | %.3f | %.3f | %.1f | |\n", worst.dice, worst.outside_share,
                worst.missed_share, worst.surface_mean_mm);
}

// Nothing where the case has no voxel of the segment.
std::string outside_of(const fs::path& couinaud, int segment, const Mask& liver, Job& job) {
    const int label[] = {segment};
    try {
        const Mask voxels = read_mask(couinaud, job, label);
        const Mask inside = resample(liver, voxels.grid, Interpolation::linear, job);
        return std::to_string(organ_score(voxels, inside, job).outside_share).substr(0, 5);
    } catch (const InputError&) {
        return "";
    }
}

void of_segments(const fs::path& folder, const fs::path& liver_file, Job& job) {
    const fs::path couinaud = folder / "couinaud.nii.gz";
    if (!fs::exists(couinaud)) throw InputError("has no segments", folder.string(), "");
    const Mask liver = close_liver(read_mask(liver_file, job), vessels_closed_mm, job);
    std::printf("| outside, by segment |");
    for (int k = 1; k <= segments; ++k)
        std::printf(" %s |", outside_of(couinaud, k, liver, job).c_str());
    std::printf("\n");
}

}  // namespace

int main(int count, char** words) {
    try {
        Job job;
        for (int i = 1; i < count; ++i) {
            const std::string word = words[i];
            if (word == "--bodies" && i + 1 < count) {
                of_bodies(words[++i], job);
            } else if (word == "--case" && i + 2 < count) {
                of_segments(words[i + 1], words[i + 2], job);
                i += 2;
            } else {
                of_patient(word, job);
            }
        }
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n%s\n", error.what(), error.remedy().c_str());
        return 1;
    }
    return 0;
}
