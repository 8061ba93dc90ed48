// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/osmesa_context.h"

#include <GL/osmesa.h>
#include <dlfcn.h>

#include <string>
#include <vector>

#include "core/base/error.h"
#include "render/picture.h"

// VTK resolves OpenGL through the system's GLEW, which asks GLX. These entry points in the
// executable take precedence over those of libGL and libGLEW and redirect the look-up to OSMesa.
extern "C" {

using GlFunction = void (*)();

__attribute__((visibility("default"))) GlFunction glXGetProcAddressARB(const GLubyte* name) {
    return OSMesaGetProcAddress(reinterpret_cast<const char*>(name));
}

__attribute__((visibility("default"))) GlFunction glXGetProcAddress(const GLubyte* name) {
    return OSMesaGetProcAddress(reinterpret_cast<const char*>(name));
}

__attribute__((visibility("default"))) GLenum glewInit() {
    using Initialise = GLenum (*)();
    constexpr GLenum no_glx_display = 4;
    void* symbol = dlsym(RTLD_NEXT, "glewInit");
    if (!symbol) return 1;
    const GLenum result = reinterpret_cast<Initialise>(symbol)();
    return result == no_glx_display ? 0 : result;
}
}

namespace hepatica {

struct OsmesaContext::Buffer {
    OSMesaContext context = nullptr;
    std::vector<unsigned char> pixels;
};

OsmesaContext::OsmesaContext(int width, int height) : buffer_(std::make_unique<Buffer>()) {
    if (width < 1 || height < 1 || width > largest_picture_px || height > largest_picture_px) {
        throw UsageError("a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                             " pixels cannot be made",
                         "picture size",
                         "choose 1 to " + std::to_string(largest_picture_px) + " pixels each way");
    }
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              24,
                              OSMESA_STENCIL_BITS,
                              8,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              3,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              3,
                              0};
    buffer_->context = OSMesaCreateContextAttribs(attributes, nullptr);
    // VTK draws into framebuffers of its own; OSMesa only needs a buffer to make the context
    // current.
    buffer_->pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    if (!buffer_->context || !OSMesaMakeCurrent(buffer_->context, buffer_->pixels.data(),
                                                GL_UNSIGNED_BYTE, width, height)) {
        if (buffer_->context) OSMesaDestroyContext(buffer_->context);
        throw Error("no software OpenGL 3.3 context could be made", "OSMesa",
                    "install the package libosmesa6 and try again");
    }
    window_ = vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New();
    window_->SetReadyForRendering(true);
    window_->SetIsCurrent(true);
    window_->SetOwnContext(0);
    window_->SetOffScreenRendering(true);
    window_->InitializeFromCurrentContext();
    window_->SetFrameBlitModeToNoBlit();
    window_->SetSize(width, height);
}

OsmesaContext::~OsmesaContext() {
    window_->Finalize();
    window_ = nullptr;
    OSMesaDestroyContext(buffer_->context);
}

}  // namespace hepatica
