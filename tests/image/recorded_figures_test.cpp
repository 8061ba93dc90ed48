// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of images as they are today: filters, distances, components, slices and files of a volume
// drawn by chance.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "core/image/filters.h"
#include "core/image/morphology.h"
#include "core/image/section.h"
#include "core/image/slice.h"
#include "core/image/volume_reader.h"
#include "core/image/volume_writer.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

using test::expect_recorded;
using test::Figures;

template <class T>
std::vector<double> values_of(const Image<T>& image) {
    return {image.voxels.begin(), image.voxels.end()};
}

std::vector<double> values_of(const Grid& grid) {
    std::vector<double> values{double(grid.dims[0]), double(grid.dims[1]), double(grid.dims[2])};
    for (const Vec3& v : {grid.spacing_mm, grid.origin_mm})
        values.insert(values.end(), v.begin(), v.end());
    for (int k = 0; k < 9; ++k) values.push_back(grid.direction(k));
    return values;
}

// Smooth hills on turned axes with unequal sides.
Volume hills() {
    Grid grid;
    grid.dims = {31, 26, 19};
    grid.spacing_mm = Vec3(0.9, 1.1, 2.3);
    grid.origin_mm = Vec3(-14.0, 33.0, 7.5);
    grid.direction = Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    Volume volume(grid);
    std::mt19937 chance(12);
    for (std::size_t i = 0; i < volume.voxels.size(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        const double hill = 400.0 * std::sin(0.31 * x) * std::cos(0.27 * y) - 90.0 * z / 3.0;
        volume.voxels[i] =
            static_cast<std::int16_t>(hill + static_cast<double>(chance() % 200) - 100.0);
    }
    return volume;
}

Mask heights(const Volume& volume, int above) {
    Mask mask(volume.grid);
    for (std::size_t i = 0; i < mask.voxels.size(); ++i)
        mask.voxels[i] = volume.voxels[i] > above ? 1 : 0;
    return mask;
}

TEST(ImageFigures, OfFilters) {
    Job job;
    const Volume volume = hills();
    Figures figures;
    const Grid finer = respaced(volume.grid, Vec3(0.7, 1.4, 1.9));
    const Grid coarser = respaced(volume.grid, Vec3(1.5, 1.0, 2.0));
    figures.add("finer", values_of(finer));
    for (const auto& [name, how] :
         {std::pair{"nearest", Interpolation::nearest}, std::pair{"linear", Interpolation::linear},
          std::pair{"cubic", Interpolation::cubic}}) {
        figures.add(name, values_of(resample(volume, finer, how, job)));
        figures.add(std::string(name) + ".float",
                    values_of(resample(to_float(volume), finer, how, job)));
        figures.add(std::string(name) + ".spaced", values_of(resample(volume, coarser, how, job)));
    }
    figures.add("mask", resample(heights(volume, 40), finer, Interpolation::linear, job).voxels);
    for (const Vec3& sigma : {Vec3(0.6, 0.0, 1.5), Vec3(3.0, 2.5, 7.0)}) {
        FloatVolume smooth = to_float(volume);
        gaussian_smooth(smooth, sigma, job);
        figures.add("smooth" + std::to_string(sigma.x()), values_of(smooth));
    }
    const Mask mask = heights(volume, 150);
    const IndexBox box = bounding_box(mask), grown = grow_box(box, volume.grid, 2.6);
    std::vector<double> boxes;
    for (const IndexBox& one : {box, grown})
        for (int a = 0; a < 3; ++a) {
            boxes.push_back(one.begin[a]);
            boxes.push_back(one.end[a]);
        }
    const auto in_space = box_mm(grown, volume.grid);
    boxes.insert(boxes.end(), in_space.min().begin(), in_space.min().end());
    boxes.insert(boxes.end(), in_space.max().begin(), in_space.max().end());
    figures.add("boxes", boxes).add("cropped", values_of(crop(volume, grown)));
    expect_recorded("image", "filters", figures);
}

TEST(ImageFigures, OfMorphology) {
    Job job;
    const Volume volume = hills();
    Figures figures;
    for (const int above : {-350, 60, 220}) {
        const Mask mask = heights(volume, above);
        const std::string name = "above" + std::to_string(above + 400);
        figures.add(name + ".distance", values_of(distance_to(mask, job)))
            .add(name + ".signed", values_of(signed_distance(mask, job)));
        for (const double radius : {1.0, 2.4}) {
            const std::string key = name + "." + std::to_string(radius);
            figures.add(key + ".dilated", dilate(mask, radius, job).voxels)
                .add(key + ".eroded", erode(mask, radius, job).voxels)
                .add(key + ".closed", close(mask, radius, job).voxels)
                .add(key + ".opened", open(mask, radius, job).voxels);
        }
        for (const Connectivity connectivity : {Connectivity::faces6, Connectivity::all26}) {
            const Components found = connected_components(mask, connectivity);
            const std::string key = name + (connectivity == Connectivity::faces6 ? ".6" : ".26");
            figures.add(key + ".labels", values_of(found.labels))
                .add(key + ".sizes", std::vector<double>(found.sizes.begin(), found.sizes.end()))
                .add(key + ".largest", largest_components(mask, connectivity, 3, 4).voxels);
        }
        figures.add(name + ".filled", fill_holes(mask).voxels);
        if (const auto section = largest_section(mask, heights(volume, above - 200)))
            figures.add(name + ".section",
                        std::vector{section->middle_mm.x(), section->middle_mm.y(),
                                    section->middle_mm.z(), section->area_mm2});
    }
    expect_recorded("image", "morphology", figures);
}

TEST(ImageFigures, OfSlices) {
    const Volume volume = hills();
    Figures figures;
    for (const auto& [name, direction] :
         {std::pair{"axial", SliceDirection::axial}, std::pair{"coronal", SliceDirection::coronal},
          std::pair{"sagittal", SliceDirection::sagittal}}) {
        const SliceStack stack(volume.grid, direction);
        const Vec3 place = stack.place_of(Vec3(1, 40, 20)), back = stack.to_mm(Vec3(3, 4, 5));
        std::vector<double> numbers{double(stack.columns()), double(stack.rows()),
                                    double(stack.count()),   stack.column_mm(),
                                    stack.row_mm(),          stack.slice_mm()};
        numbers.insert(numbers.end(), place.begin(), place.end());
        numbers.insert(numbers.end(), back.begin(), back.end());
        for (const char edge : stack.edges()) numbers.push_back(edge);
        figures.add(std::string(name) + ".geometry", numbers);
        for (const int slice : {0, 7, stack.count() - 1})
            figures.add(std::string(name) + std::to_string(slice),
                        grey_slice(volume, stack, slice, {.level_hu = 40.0, .width_hu = 350.0}));
        figures.add(std::string(name) + ".labels", label_slice(heights(volume, 60), stack, 6));
    }
    expect_recorded("image", "slices", figures);
}

TEST(ImageFigures, OfFiles) {
    namespace fs = std::filesystem;
    Job job;
    const fs::path folder = fs::path(testing::TempDir()) / "recorded image";
    fs::remove_all(folder);
    fs::create_directories(folder);
    const Volume volume = hills();
    const auto bytes = [](const fs::path& file) {
        std::ifstream in(file, std::ios::binary);
        return std::vector<std::uint8_t>{std::istreambuf_iterator<char>(in), {}};
    };
    Figures figures;
    write_nifti(folder / "a.nii", volume);
    write_nifti(folder / "b.nii", heights(volume, 60));
    write_nifti(folder / "c.nii", to_float(volume));
    for (const char* name : {"a.nii", "b.nii", "c.nii"}) figures.add(name, bytes(folder / name));
    figures.add("read.nii", values_of(read_volume(folder / "a.nii", job)));
    LabelMap labels(volume.grid);
    for (std::size_t i = 0; i < labels.voxels.size(); ++i)
        labels.voxels[i] = static_cast<std::uint16_t>(volume.voxels[i] > 0 ? i % 4 : 0);
    const std::array segments{SegmentDescription{1, "portal vein", Vec3(0.2, 0.3, 0.9)},
                              SegmentDescription{2, "hepatic veins", Vec3(0.1, 0.5, 0.8)}};
    write_segmentation(folder / "d.seg.nrrd", labels, segments);
    figures.add("segmentation.bytes", bytes(folder / "d.seg.nrrd"));
    figures.add("segmentation.labels", values_of(read_label_map(folder / "d.seg.nrrd", job)));
    write_dicom_series(folder / "series", volume, {}, job);
    const Volume read = read_volume(folder / "series", job);
    figures.add("series", values_of(read)).add("series.grid", values_of(read.grid));
    fs::remove_all(folder);
    expect_recorded("image", "files", figures);
}

}  // namespace
}  // namespace hepatica
