// SPDX-License-Identifier: GPL-3.0-or-later
// A triangle surface on the graphics card: each of its arrays is uploaded only when it was set
// anew. Colours have an alpha of 255, because VTK would otherwise convert the array to four
// components for every picture in which the points have moved.
#pragma once

#include <vtkSmartPointer.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "render/halo_actor.h"

class vtkActor;
class vtkFloatArray;
class vtkOpenGLPolyDataMapper;
class vtkPlane;
class vtkPolyData;
class vtkUnsignedCharArray;

namespace hepatica {

// Belongs to one OpenGL context; not thread-safe. For closed surfaces only: back faces are culled
// unless the surface is cut open by a clip plane.
class DrawnSurface {
  public:
    DrawnSurface();

    // Call set_triangles() first. The others take one value (arrival), three (positions, normals)
    // or four (colours) per vertex.
    void set_triangles(std::span<const std::array<int, 3>> triangles, std::size_t vertex_count);
    void set_positions(std::span<const float> positions_mm, std::span<const float> normals);
    void set_colours(std::span<const std::uint8_t> rgba);
    void set_arrival(std::span<const float> arrival_s);

    // Draws only the part on the plane's positive side, and the inside that it exposes; null draws
    // all. The plane must outlive its use.
    void set_clip(vtkPlane* plane);

    vtkActor* actor() const;
    HaloActor& halo() { return halo_; }
    const HaloActor& halo() const { return halo_; }
    vtkOpenGLPolyDataMapper* mapper() const;

  private:
    vtkSmartPointer<vtkPolyData> polydata_;
    vtkSmartPointer<vtkFloatArray> positions_;
    vtkSmartPointer<vtkFloatArray> normals_;
    vtkSmartPointer<vtkFloatArray> arrival_;
    vtkSmartPointer<vtkUnsignedCharArray> colours_;
    vtkSmartPointer<vtkOpenGLPolyDataMapper> mapper_;
    vtkSmartPointer<vtkActor> actor_;
    HaloActor halo_;
};

}  // namespace hepatica
