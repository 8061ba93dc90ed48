// SPDX-License-Identifier: GPL-3.0-or-later
// The vessel surface on the graphics card. Positions and normals are uploaded every frame in which
// they change, triangles and colours only when they change; the drug's arrival times are uploaded
// once an injection, and its clock is one uniform.
#pragma once

#include <vtkSmartPointer.h>

#include <cstdint>
#include <vector>

#include "core/base/vascular_system.h"
#include "core/scene/frame.h"
#include "render/rounded_surface.h"
#include "render/surface_geometry.h"

class vtkActor;
class vtkFloatArray;
class vtkOpenGLPolyDataMapper;
class vtkPolyData;
class vtkUnsignedCharArray;

namespace hepatica {

// Belongs to one OpenGL context; not thread-safe.
class TreeActor {
  public:
    TreeActor();

    // Returns true if the picture is another now.
    bool update(const Frame& frame);

    // Vascular system of each vertex of the frame (see palette::vessel_system); those missing at
    // the end count as unknown.
    void set_vertex_systems(std::vector<VascularSystem> systems);
    // Vertices of the frame to light up, 1 or 0 each; empty lights none.
    void set_highlight(std::vector<std::uint8_t> highlight);
    // Depths (mm from the camera) between which the tree fades into the background.
    void set_fade(double near_mm, double far_mm);

    vtkActor* actor() const { return actor_; }
    const SurfaceGeometry& surface() const { return surface_; }

  private:
    void upload_topology();
    void upload_positions();
    void upload_colours();
    void upload_arrival(const DrugView& drug);

    SurfaceGeometry surface_;
    RoundedSurface rounded_;
    std::vector<VascularSystem> systems_;
    std::vector<std::uint8_t> highlight_;
    std::uint64_t drug_version_ = 0;
    const void* drug_source_ = nullptr;
    double drug_time_s_ = 0.0;
    vtkSmartPointer<vtkPolyData> polydata_;
    vtkSmartPointer<vtkFloatArray> positions_;
    vtkSmartPointer<vtkFloatArray> normals_;
    vtkSmartPointer<vtkFloatArray> arrival_;
    vtkSmartPointer<vtkUnsignedCharArray> colours_;
    vtkSmartPointer<vtkOpenGLPolyDataMapper> mapper_;
    vtkSmartPointer<vtkActor> actor_;
};

}  // namespace hepatica
