// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/hidden_context.h"

#include <QOpenGLFunctions>

namespace hepatica {

HiddenContext::HiddenContext() {
    if (!context_.create()) return;
    surface_.setFormat(context_.format());
    surface_.create();
}

bool HiddenContext::make_current() {
    return context_.isValid() && surface_.isValid() && context_.makeCurrent(&surface_);
}

std::string HiddenContext::renderer_name() {
    const auto* name = context_.functions()->glGetString(GL_RENDERER);
    return name ? reinterpret_cast<const char*>(name) : "";
}

}  // namespace hepatica
