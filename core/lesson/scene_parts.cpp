// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/scene_parts.h"

namespace hepatica {

namespace {

// The one that was taken out comes back, else a new one.
template <class Part>
void put_in(std::optional<Part>& part, const std::optional<Part>& taken_out) {
    if (!part) part = taken_out.value_or(Part{});
}

template <class Part>
void take_out(std::optional<Part>& part, std::optional<Part>& kept) {
    if (part) kept = part;
    part.reset();
}

}  // namespace

void SceneParts::set_moves(SceneSpec& scene, bool on) {
    if (on == scene.deform.has_value()) return;
    if (on && moving_taken_) {
        scene.deform = with_moving_.deform;
        scene.contact = with_moving_.contact;
        scene.tear = with_moving_.tear;
    } else if (on) {
        scene.deform.emplace();
    } else {
        with_moving_ = scene;
        moving_taken_ = true;
        scene.deform.reset();
        scene.contact.reset();
        scene.tear.reset();
    }
}

void SceneParts::set_contact(SceneSpec& scene, bool ContactSpec::*which, bool on) {
    const auto of_nothing = [&] {
        return scene.contact && !scene.contact->tools && !scene.contact->self;
    };
    if (on && (!scene.contact || of_nothing())) empty_contact_ = of_nothing();
    if (!scene.contact) scene.contact = ContactSpec{false, false};
    (*scene.contact).*which = on;
    if (of_nothing() && !empty_contact_) scene.contact.reset();
}

void SceneParts::set_touches(SceneSpec& scene, bool on) {
    set_contact(scene, &ContactSpec::tools, on);
}

void SceneParts::set_self(SceneSpec& scene, bool on) {
    set_contact(scene, &ContactSpec::self, on);
}

void SceneParts::set_tears(SceneSpec& scene, bool on) {
    on ? put_in(scene.tear, tear_) : take_out(scene.tear, tear_);
}

void SceneParts::set_flows(SceneSpec& scene, bool on) {
    on ? put_in(scene.flow, flow_) : take_out(scene.flow, flow_);
}

}  // namespace hepatica
