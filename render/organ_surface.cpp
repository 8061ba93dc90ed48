// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/organ_surface.h"

#include <vtkFlyingEdges3D.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkImageImport.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <utility>

#include "core/image/filters.h"

namespace hepatica {
namespace {

constexpr double smoothing_mm = 2.0;
constexpr double spacing_mm = 2.0;
constexpr double margin_mm = 8.0;  // four times the smoothing: nothing of the surface is cut off

// 1 in the organ and 0 elsewhere, smoothed.
FloatVolume share_inside(const Mask& organs, std::uint8_t label, Job& job) {
    Mask organ(organs.grid);
    std::ranges::transform(organs.voxels, organ.voxels.begin(),
                           [&](std::uint8_t value) { return value == label ? 1 : 0; });
    const IndexBox box = bounding_box(organ);
    if (box.empty()) return {};
    const Mask part = crop(organ, grow_box(box, organs.grid, margin_mm));
    FloatVolume share(part.grid);
    std::ranges::copy(part.voxels, share.voxels.begin());
    gaussian_smooth(share, Vec3::Constant(smoothing_mm), job);
    const Grid coarse =
        respaced(share.grid, share.grid.spacing_mm.cwiseMax(Vec3::Constant(spacing_mm)));
    return resample(share, coarse, Interpolation::linear, job);
}

// The same with a layer of zeros around it, so that every surface is closed.
FloatVolume with_border(const FloatVolume& inner) {
    Grid grid = inner.grid;
    for (int& count : grid.dims) count += 2;
    grid.origin_mm = inner.grid.to_mm(-1, -1, -1);
    FloatVolume padded(grid);
    for (int z = 0; z < inner.grid.dims[2]; ++z)
        for (int y = 0; y < inner.grid.dims[1]; ++y)
            std::copy_n(&inner.at(0, y, z), inner.grid.dims[0], &padded.at(1, y + 1, z + 1));
    return padded;
}

double signed_volume(const TriangleMesh& mesh) {
    double six_volumes = 0.0;
    for (const auto& [a, b, c] : mesh.triangles)
        six_volumes += mesh.vertices_mm[a].dot(mesh.vertices_mm[b].cross(mesh.vertices_mm[c]));
    return six_volumes / 6.0;
}

}  // namespace

TriangleMesh organ_surface(const Mask& organs, std::uint8_t label, Job& job) {
    const FloatVolume inner = share_inside(organs, label, job);
    if (inner.voxels.empty()) return {};
    const FloatVolume share = with_border(inner);
    const Index3& dims = share.grid.dims;
    vtkNew<vtkImageImport> image;
    image->SetDataScalarTypeToFloat();
    image->SetWholeExtent(0, dims[0] - 1, 0, dims[1] - 1, 0, dims[2] - 1);
    image->SetDataExtentToWholeExtent();
    image->SetImportVoidPointer(const_cast<float*>(share.voxels.data()));  // it is only read
    vtkNew<vtkFlyingEdges3D> contour;
    contour->SetInputConnection(image->GetOutputPort());
    contour->SetValue(0, 0.5);
    contour->ComputeNormalsOff();
    contour->ComputeScalarsOff();
    contour->Update();
    vtkPolyData& drawn = *contour->GetOutput();

    TriangleMesh mesh;
    mesh.vertices_mm.reserve(static_cast<std::size_t>(drawn.GetNumberOfPoints()));
    for (vtkIdType i = 0; i < drawn.GetNumberOfPoints(); ++i)
        mesh.vertices_mm.push_back(share.grid.to_mm(Vec3(drawn.GetPoint(i))));
    vtkNew<vtkIdList> corners;
    for (vtkIdType t = 0; t < drawn.GetNumberOfCells(); ++t) {
        drawn.GetCellPoints(t, corners);
        mesh.triangles.push_back({static_cast<int>(corners->GetId(0)),
                                  static_cast<int>(corners->GetId(1)),
                                  static_cast<int>(corners->GetId(2))});
    }
    // The axes of a grid may be left-handed.
    if (signed_volume(mesh) < 0.0)
        for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    return mesh;
}

}  // namespace hepatica
