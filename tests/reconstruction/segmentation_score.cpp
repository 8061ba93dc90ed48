// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reconstruction/segmentation_score.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>

#include "core/image/filters.h"
#include "core/image/morphology.h"
#include "core/image/volume_reader.h"
#include "core/phantom/phantom.h"
#include "core/segmentation/liver_region.h"
#include "core/skeleton/thinning.h"
#include "core/tree/files/tree_io.h"

namespace hepatica::testing_support {

namespace {

constexpr double judged_closing_mm = 8.0;

void unite(Mask& mask, const Mask& with) {
    for (std::size_t i = 0; i < mask.voxels.size(); ++i)
        if (with.voxels[i]) mask.voxels[i] = 1;
}

Mask intersection(const Mask& a, const Mask& b) {
    Mask both(a.grid);
    for (std::size_t i = 0; i < both.voxels.size(); ++i)
        both.voxels[i] = a.voxels[i] && b.voxels[i];
    return both;
}

std::size_t count(const Mask& mask) {
    return mask.voxels.size() - static_cast<std::size_t>(std::count(
                                    mask.voxels.begin(), mask.voxels.end(), std::uint8_t{0}));
}

double share(std::size_t part, std::size_t whole) {
    return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

double harmonic(double a, double b) {
    return a + b > 0.0 ? 2.0 * a * b / (a + b) : 0.0;
}

// Two uniform numbers to one normal one, the same on every machine.
class Normal {
  public:
    explicit Normal(std::uint64_t seed) : engine_(seed) {}
    double operator()() {
        const double u = (static_cast<double>(engine_() >> 11) + 0.5) * 0x1p-53;
        const double v = static_cast<double>(engine_() >> 11) * 0x1p-53;
        return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * std::numbers::pi * v);
    }

  private:
    std::mt19937_64 engine_;
};

template <class T>
Image<T> every_nth(const Image<T>& image, int n) {
    Grid grid = image.grid;
    grid.dims[2] = (grid.dims[2] + n - 1) / n;
    grid.spacing_mm[2] *= n;
    Image<T> out(grid);
    for (int z = 0; z < grid.dims[2]; ++z)
        std::copy_n(&image.voxels[image.grid.offset(0, 0, z * n)], grid.offset(0, 0, 1),
                    &out.voxels[grid.offset(0, 0, z)]);
    return out;
}

}  // namespace

std::filesystem::path data_folder() {
    const char* from_environment = std::getenv("HEPATICA_TEST_DATA");
    return from_environment ? std::filesystem::path(from_environment)
                            : std::filesystem::path(HEPATICA_SOURCE_DIR) / ".." / "shared" / "data";
}

Patient ircadb_patient(Job& job) {
    const std::filesystem::path folder = data_folder() / "ircadb01_case01";
    Patient patient;
    patient.name = "ircadb01_case01";
    patient.ct = read_volume(folder / "PATIENT_DICOM", job);
    patient.liver = read_mask(folder / "masks" / "liver.nii.gz", job);
    patient.truth = read_mask(folder / "masks" / "portalvein.nii.gz", job);
    unite(patient.truth, read_mask(folder / "masks" / "venoussystem.nii.gz", job));
    patient.judged = close_liver(patient.liver, judged_closing_mm, job);
    return patient;
}

Patient vascusynth_patient(Job& job) {
    const std::filesystem::path folder = data_folder() / "vascusynth";
    Patient patient;
    patient.name = "vascusynth";
    patient.ct = read_volume(folder / "phantom_ct_hu.nii.gz", job);
    patient.liver = read_mask(folder / "phantom_labels.nii.gz", job);
    patient.truth = read_mask(folder / "mask_portal.nii.gz", job);
    for (const char* name : {"artery", "portal", "hvein"}) {
        unite(patient.truth, read_mask(folder / (std::string("mask_") + name + ".nii.gz"), job));
        const VesselTree tree = read_tree(folder / (std::string("tree_") + name + ".vtp"),
                                          {.space = PatientSpace::lps});
        patient.tree.segments.insert(patient.tree.segments.end(), tree.segments.begin(),
                                     tree.segments.end());
    }
    patient.judged = Mask(patient.ct.grid, 1);
    return patient;
}

Patient phantom_patient(const PhantomOptions& options, Job& job) {
    Phantom phantom = make_phantom(options, job);
    Patient patient;
    patient.name = "phantom " + std::to_string(options.seed);
    patient.ct = std::move(phantom.ct);
    patient.liver = std::move(phantom.liver);
    patient.truth = std::move(phantom.vessels);
    patient.judged = Mask(patient.ct.grid, 1);
    patient.tree = std::move(phantom.tree);
    return patient;
}

Patient phantom_patient(std::uint64_t seed, double slice_mm, Job& job) {
    PhantomOptions options;
    options.seed = seed;
    options.dims[2] =
        static_cast<int>(std::lround(options.dims[2] * options.spacing_mm[2] / slice_mm));
    options.spacing_mm[2] = slice_mm;
    return phantom_patient(options, job);
}

void add_noise(Volume& ct, double deviation_hu, std::uint64_t seed, Job& job) {
    Normal normal(seed);
    FloatVolume noise(ct.grid);
    for (float& v : noise.voxels) v = static_cast<float>(normal());
    gaussian_smooth(noise, Vec3(0.7, 0.7, 0.3).cwiseProduct(ct.grid.spacing_mm), job);
    double squares = 0.0;
    for (const float v : noise.voxels) squares += static_cast<double>(v) * v;
    const double scale =
        deviation_hu / std::sqrt(squares / static_cast<double>(noise.voxels.size()));
    for (std::size_t i = 0; i < noise.voxels.size(); ++i)
        ct.voxels[i] = static_cast<std::int16_t>(
            std::clamp(std::lround(ct.voxels[i] + scale * noise.voxels[i]), -32768L, 32767L));
}

Patient thinned_out(const Patient& patient, int every_nth_slice) {
    Patient thin = patient;
    thin.name += ", every " + std::to_string(every_nth_slice) + ". slice";
    thin.ct = every_nth(patient.ct, every_nth_slice);
    thin.liver = every_nth(patient.liver, every_nth_slice);
    thin.truth = every_nth(patient.truth, every_nth_slice);
    thin.judged = every_nth(patient.judged, every_nth_slice);
    return thin;
}

Score score(const Mask& mask, const Patient& patient, Job& job) {
    const Mask result =
        intersection(resample(mask, patient.ct.grid, Interpolation::linear, job), patient.judged);
    const Mask truth = intersection(patient.truth, patient.judged);
    const Mask hit = intersection(result, truth);
    Score score;
    score.precision = share(count(hit), count(result));
    score.recall = share(count(hit), count(truth));
    score.dice = harmonic(score.precision, score.recall);
    const Mask result_skeleton = thin(result, ThinningMethod::queue, job);
    const Mask truth_skeleton = thin(truth, ThinningMethod::queue, job);
    score.centreline_precision =
        share(count(intersection(result_skeleton, truth)), count(result_skeleton));
    score.centreline_recall =
        share(count(intersection(truth_skeleton, result)), count(truth_skeleton));
    score.cldice = harmonic(score.centreline_precision, score.centreline_recall);
    return score;
}

double length_found(const Mask& mask, const Patient& patient, double radius_mm, double tolerance_mm,
                    Job& job) {
    const FloatVolume distance = distance_to(thin(mask, ThinningMethod::queue, job), job);
    double length = 0.0;
    double found = 0.0;
    for (const VesselSegment& segment : patient.tree.segments)
        for (std::size_t p = 1; p < segment.points_mm.size(); ++p) {
            if (0.5 * (segment.radii_mm[p] + segment.radii_mm[p - 1]) <= radius_mm) continue;
            const Vec3 middle = 0.5 * (segment.points_mm[p] + segment.points_mm[p - 1]);
            const double step = (segment.points_mm[p] - segment.points_mm[p - 1]).norm();
            length += step;
            const Vec3 index = mask.grid.to_index(middle);
            const Index3 at{static_cast<int>(std::lround(index[0])),
                            static_cast<int>(std::lround(index[1])),
                            static_cast<int>(std::lround(index[2]))};
            if (mask.grid.contains(at[0], at[1], at[2]) &&
                distance.at(at[0], at[1], at[2]) <= tolerance_mm)
                found += step;
        }
    return length > 0.0 ? found / length : 0.0;
}

}  // namespace hepatica::testing_support
