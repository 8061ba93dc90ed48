// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/potentials/tool_load_sum.h"

namespace hepatica {

void ToolLoadSum::press(const PadContact& contact, double share) {
    const double size = share * contact.force_un;
    const Vec3 force = size * contact.normal;
    drag(contact.at_mm, force);
    load_.at_mm += size * contact.at_mm;
    pressed_un_ += size;
    load_.grip_un -= force.dot(tool_.parts[contact.part].opens);
}

void ToolLoadSum::drag(const Vec3& at_mm, const Vec3& on_touched_un) {
    load_.force_un -= on_touched_un;
    load_.torque_un_mm -= (at_mm - centre_mm_).cross(on_touched_un);
}

ToolLoad ToolLoadSum::load() const {
    ToolLoad load = load_;
    if (pressed_un_ > 0.0) load.at_mm /= pressed_un_;
    return load;
}

}  // namespace hepatica
