// SPDX-License-Identifier: GPL-3.0-or-later
// OpenGL without a display: a software context for programs that make pictures on servers. Only
// programs that call hepatica_use_osmesa() in CMake contain it. It replaces the look-up of OpenGL
// functions, so the desktop program must not use it.
#pragma once

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkSmartPointer.h>

#include <memory>

namespace hepatica {

// An OpenGL context of fixed size in memory. The thread that made it must use and destroy it.
class OsmesaContext {
  public:
    // Throws UsageError unless both sizes are 1 to 16384 pixels, and Error where OSMesa cannot make
    // an OpenGL 3.3 context.
    OsmesaContext(int width, int height);
    ~OsmesaContext();
    OsmesaContext(const OsmesaContext&) = delete;
    OsmesaContext& operator=(const OsmesaContext&) = delete;

    vtkGenericOpenGLRenderWindow& window() { return *window_; }

  private:
    struct Buffer;
    std::unique_ptr<Buffer> buffer_;
    vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_;
};

}  // namespace hepatica
