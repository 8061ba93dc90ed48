// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reconstruction/closed_surface.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace hepatica::testing_support {

namespace {

constexpr int samples = 4;  // along each axis of a voxel

// Where a line along x enters or leaves.
struct Crossing {
    double x;
    int turn;  // 1 or -1
};

// Lines along x, `samples` of them in y and z for each voxel.
class Lines {
  public:
    explicit Lines(const Grid& grid) : grid_(grid) {
        count_y_ = samples * grid.dims[1];
        crossings_.resize(static_cast<std::size_t>(count_y_) * samples * grid.dims[2]);
    }

    void add(const Vec3& a, const Vec3& b, const Vec3& c) {
        const double area = cross(b - a, c - a);
        if (area == 0.0) return;
        for (int k = first(2, std::min({a.z(), b.z(), c.z()}));
             k <= last(2, std::max({a.z(), b.z(), c.z()})); ++k)
            for (int j = first(1, std::min({a.y(), b.y(), c.y()}));
                 j <= last(1, std::max({a.y(), b.y(), c.y()})); ++j) {
                const Vec3 p(0.0, place(1, j), place(2, k));
                const double u = cross(b - p, c - p) / area;
                const double v = cross(c - p, a - p) / area;
                const double w = 1.0 - u - v;
                if (u < 0.0 || v < 0.0 || w < 0.0) continue;
                at(j, k).push_back({u * a.x() + v * b.x() + w * c.x(), area > 0.0 ? 1 : -1});
            }
    }

    void count(Image<std::uint8_t>& share) {
        for (int k = 0; k < samples * grid_.dims[2]; ++k)
            for (int j = 0; j < count_y_; ++j) {
                std::vector<Crossing>& line = at(j, k);
                std::ranges::sort(line, {}, &Crossing::x);
                int turns = 0;
                for (std::size_t i = 0; i + 1 < line.size(); ++i) {
                    turns += line[i].turn;
                    if (turns == 0) continue;
                    for (int n = first(0, line[i].x); n <= last(0, line[i + 1].x); ++n)
                        ++share.at(n / samples, j / samples, k / samples);
                }
            }
    }

  private:
    // Of the projections on the plane of y and z.
    static double cross(const Vec3& a, const Vec3& b) { return a.y() * b.z() - a.z() * b.y(); }

    // Sample points lie off the middle by a little that no vertex shares, so that no line meets an
    // edge.
    double place(int axis, int sample) const {
        return grid_.origin_mm[axis] +
               grid_.spacing_mm[axis] * ((sample + 0.5) / samples - 0.5 + 1.7e-7 * (axis + 1));
    }
    int first(int axis, double from) const {
        const double index = (from - place(axis, 0)) * samples / grid_.spacing_mm[axis];
        return std::max(0, static_cast<int>(std::ceil(index)));
    }
    int last(int axis, double to) const {
        const double index = (to - place(axis, 0)) * samples / grid_.spacing_mm[axis];
        return std::min(samples * grid_.dims[axis] - 1, static_cast<int>(std::floor(index)));
    }
    std::vector<Crossing>& at(int j, int k) {
        return crossings_[static_cast<std::size_t>(k) * count_y_ + j];
    }

    const Grid& grid_;
    int count_y_;
    std::vector<std::vector<Crossing>> crossings_;
};

}  // namespace

ClosedSurface read_surface(const std::filesystem::path& file) {
    if (!std::filesystem::exists(file))
        throw InputError("there is no such file", file.string(), "Name a surface");
    vtkNew<vtkPolyDataReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    vtkPolyData* data = reader->GetOutput();
    ClosedSurface surface;
    surface.points_mm.resize(data->GetNumberOfPoints());
    for (std::size_t i = 0; i < surface.points_mm.size(); ++i)
        data->GetPoint(static_cast<vtkIdType>(i), surface.points_mm[i].data());
    vtkCellArray* cells = data->GetPolys();
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell) {
        vtkIdType count = 0;
        const vtkIdType* ids = nullptr;
        cells->GetCellAtId(cell, count, ids);
        for (vtkIdType i = 2; i < count; ++i)
            surface.triangles.push_back(
                {static_cast<int>(ids[0]), static_cast<int>(ids[i - 1]), static_cast<int>(ids[i])});
    }
    if (surface.triangles.empty())
        throw InputError("holds no polygons", file.string(), "Name a closed surface");
    return surface;
}

Image<std::uint8_t> inside_share(const ClosedSurface& surface, const Grid& grid) {
    Lines lines(grid);
    for (const auto& [a, b, c] : surface.triangles)
        lines.add(surface.points_mm[a], surface.points_mm[b], surface.points_mm[c]);
    Image<std::uint8_t> share(grid);
    lines.count(share);
    return share;
}

}  // namespace hepatica::testing_support
