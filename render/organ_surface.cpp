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
#include <vector>

#include "core/image/filters.h"
#include "core/image/morphology.h"
#include "core/image/share_inside.h"

namespace hepatica {
namespace {

struct Coarseness {
    double smoothing_mm = 0.0, spacing_mm = 0.0;
};

constexpr Coarseness of_organ{2.0, 2.0}, of_tumour{0.8, 1.0};
constexpr double reach =
    4.0;  // margin in units of the smoothing length, so that nothing of the surface is cut off

FloatVolume share_of(const Mask& part, const Coarseness& coarse, Job& job) {
    return share_inside(part, coarse.smoothing_mm,
                        part.grid.spacing_mm.cwiseMax(Vec3::Constant(coarse.spacing_mm)), job);
}

double signed_volume(const TriangleMesh& mesh) {
    double six_volumes = 0.0;
    for (const auto& [a, b, c] : mesh.triangles)
        six_volumes += mesh.vertices_mm[a].dot(mesh.vertices_mm[b].cross(mesh.vertices_mm[c]));
    return six_volumes / 6.0;
}

// Each connected component (26 neighbours) as a mask in a grid of its own with this margin around
// it.
std::vector<Mask> pieces_of(const Mask& mask, double margin_mm, const Job& job) {
    const Components found = connected_components(mask, Connectivity::all26, job);
    const Grid& grid = mask.grid;
    std::vector<IndexBox> boxes(found.sizes.size(), {grid.dims, {0, 0, 0}});
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
        if (found.labels.voxels[i] == 0) continue;
        const Index3 here = grid.index_of(i);
        IndexBox& box = boxes[found.labels.voxels[i] - 1];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            box.begin[axis] = std::min(box.begin[axis], here[axis]);
            box.end[axis] = std::max(box.end[axis], here[axis] + 1);
        }
    }
    std::vector<Mask> pieces;
    for (std::size_t p = 0; p < boxes.size(); ++p) {
        const IndexBox box = grow_box(boxes[p], grid, margin_mm);
        Mask piece(crop(grid, box));
        for (std::size_t i = 0; i < piece.voxels.size(); ++i) {
            const auto [x, y, z] = piece.grid.index_of(i);
            const std::uint32_t label =
                found.labels.at(x + box.begin[0], y + box.begin[1], z + box.begin[2]);
            piece.voxels[i] = label == p + 1 ? 1 : 0;
        }
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

void append(const TriangleMesh& more, TriangleMesh& all) {
    const auto first = static_cast<int>(all.vertices_mm.size());
    all.vertices_mm.insert(all.vertices_mm.end(), more.vertices_mm.begin(), more.vertices_mm.end());
    for (const auto& [a, b, c] : more.triangles)
        all.triangles.push_back({a + first, b + first, c + first});
}

// The surface where the share of the object is one half, triangles counter-clockwise seen from
// outside.
TriangleMesh closed_surface(const FloatVolume& inner) {
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

}  // namespace

TriangleMesh organ_surface(const Mask& organs, std::uint8_t label, Job& job) {
    Mask organ(organs.grid);
    std::ranges::transform(organs.voxels, organ.voxels.begin(),
                           [&](std::uint8_t value) { return value == label ? 1 : 0; });
    const IndexBox box = bounding_box(organ);
    if (box.empty()) return {};
    const Mask part = crop(organ, grow_box(box, organ.grid, reach * of_organ.smoothing_mm));
    return closed_surface(share_of(part, of_organ, job));
}

TriangleMesh tumour_surface(const Mask& tumours, Job& job) {
    TriangleMesh all;
    for (const Mask& piece : pieces_of(tumours, reach * of_tumour.smoothing_mm, job)) {
        TriangleMesh surface = closed_surface(share_of(piece, of_tumour, job));
        if (surface.triangles.empty()) {  // too small to survive smoothing
            FloatVolume plain(piece.grid);
            std::ranges::copy(piece.voxels, plain.voxels.begin());
            surface = closed_surface(plain);
        }
        append(surface, all);
    }
    return all;
}

}  // namespace hepatica
