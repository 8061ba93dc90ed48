// SPDX-License-Identifier: GPL-3.0-or-later
// A surface that does not move, as VTK draws it: with smooth normals.
#pragma once

#include <vtkSmartPointer.h>

#include "core/mesh/tet_mesh.h"

class vtkPolyData;

namespace hepatica {

// Triangles counter-clockwise from outside.
vtkSmartPointer<vtkPolyData> still_surface(const TriangleMesh& surface);

}  // namespace hepatica
