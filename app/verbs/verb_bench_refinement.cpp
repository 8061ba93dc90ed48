// SPDX-License-Identifier: GPL-3.0-or-later
// bench refinement: how many recursions of the Gaussian refinement (II.A.1) to use, by the noise of
// the surface and the volume lost on a synthetic patient.
#include <cmath>

#include "app/verbs/verbs.h"
#include "core/accuracy/accuracy.h"
#include "core/image/morphology.h"
#include "core/phantom/phantom.h"
#include "core/segmentation/gaussian_refinement.h"
#include "core/skeleton/topology.h"

namespace hepatica {

namespace {

struct BenchRefinementChoices {
    int seed = 1;
    int recursions = 8;
    int generations = 4;
};

// Thresholds the CT half-way between parenchyma and vessel, within two voxels of the true vessels:
// their surface with the noise of the scan.
Mask thresholded(const Phantom& phantom, const PhantomOptions& made, Job& job) {
    const double half_hu = made.parenchyma_hu + 0.5 * made.contrast_hu;
    Mask mask = dilate(phantom.vessels, 2.0 * made.spacing_mm.minCoeff(), job);
    for (std::size_t i = 0; i < mask.voxels.size(); ++i)
        if (phantom.ct.voxels[i] < half_hu) mask.voxels[i] = 0;
    return mask;
}

// The signed distance of a mask's outermost voxels from the true surface: its mean, outwards, and
// its standard deviation, the noise.
struct SurfacePlace {
    double shift_mm = 0.0;
    double noise_mm = 0.0;
};

bool is_outermost(const Mask& mask, int x, int y, int z) {
    return mask.at(x, y, z) != 0 &&
           (mask.at(x - 1, y, z) == 0 || mask.at(x + 1, y, z) == 0 || mask.at(x, y - 1, z) == 0 ||
            mask.at(x, y + 1, z) == 0 || mask.at(x, y, z - 1) == 0 || mask.at(x, y, z + 1) == 0);
}

SurfacePlace place_of_surface(const Mask& mask, const FloatVolume& distance_mm) {
    double sum = 0.0, squares = 0.0, count = 0.0;
    const Index3& dims = mask.grid.dims;
    for (int z = 1; z + 1 < dims[2]; ++z)
        for (int y = 1; y + 1 < dims[1]; ++y)
            for (int x = 1; x + 1 < dims[0]; ++x) {
                if (!is_outermost(mask, x, y, z)) continue;
                const double d = distance_mm.at(x, y, z);
                sum += d;
                squares += d * d;
                count += 1.0;
            }
    const double mean = sum / count;
    return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean))};
}

Json run_bench_refinement(const BenchRefinementChoices& options, Job& job) {
    PhantomOptions made;
    made.seed = static_cast<std::uint64_t>(options.seed);
    made.dims = {240, 240, 200};
    made.spacing_mm = Vec3::Constant(0.8);
    made.generations = options.generations;
    const Phantom phantom = make_phantom(made, job);
    job.begin_stage("Refining");
    const Mask rough = thresholded(phantom, made, job);
    const SurfaceMeasure truth = measure_surface(phantom.vessels);
    const FloatVolume distance_mm = signed_distance(phantom.vessels, job);
    const double true_shift_mm = place_of_surface(phantom.vessels, distance_mm).shift_mm;
    const SurfaceMeasure start = measure_surface(rough);
    Json rows = Json::array();
    for (int n = 0; n <= options.recursions; ++n) {
        const Mask refined = refine(rough, n, job);
        const SurfaceMeasure found = measure_surface(refined);
        const SurfacePlace surface = place_of_surface(refined, distance_mm);
        rows.push_back({{"recursions", n},
                        {"surface_noise_mm", surface.noise_mm},
                        {"surface_shift_mm", surface.shift_mm - true_shift_mm},
                        {"area_mm2", found.area_mm2},
                        {"volume_lost", 1.0 - found.volume_mm3 / start.volume_mm3},
                        {"dice", dice_of(refined, phantom.vessels, job)},
                        {"components", betti_numbers(refined).components}});
    }
    return {
        {"rows", rows}, {"true_area_mm2", truth.area_mm2}, {"true_volume_mm3", truth.volume_mm3}};
}

}  // namespace

void add_bench_refinement(CommandLine& line) {
    auto options = std::make_shared<BenchRefinementChoices>();
    CLI::App& verb = line.add_verb(
        "bench", "Benchmarks", "refinement",
        "The level of the Gaussian refinement: noise of the surface against volume lost",
        [options](Job& job) { return run_bench_refinement(*options, job); });
    verb.add_option("--seed", options->seed, "Which synthetic patient")
        ->check(whole_number_from(0))
        ->capture_default_str();
    verb.add_option("--generations", options->generations, "Of its vessels")->capture_default_str();
    verb.add_option("--recursions", options->recursions, "0 to so many")
        ->check(CLI::Range(0, 50))
        ->capture_default_str();
}

}  // namespace hepatica
