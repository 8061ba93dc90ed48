// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/scene_parts.h"

namespace hepatica {

namespace {

// Restores the removed part, or inserts a default one.
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

void SceneParts::set_contact(SceneSpec& scene, bool on,
                             const std::function<void(ContactSpec&)>& change) {
    const auto of_nothing = [&] { return scene.contact && scene.contact->nothing(); };
    if (on && (!scene.contact || of_nothing())) empty_contact_ = of_nothing();
    if (!scene.contact) scene.contact = ContactSpec{false, false};
    change(*scene.contact);
    if (of_nothing() && !empty_contact_) scene.contact.reset();
}

void SceneParts::set_touches(SceneSpec& scene, bool on) {
    set_contact(scene, on, [on](ContactSpec& contact) { contact.tools = on; });
}

void SceneParts::set_self(SceneSpec& scene, bool on) {
    set_contact(scene, on, [&](ContactSpec& contact) {
        if (contact.self && !on) friction_ = contact.friction;
        if (contact.self != on) contact.friction = on ? friction_ : 0.0;
        contact.self = on;
    });
}

void SceneParts::set_obstacles(SceneSpec& scene, bool on) {
    set_contact(scene, on, [&](ContactSpec& contact) {
        const bool had = contact.obstacles != WantedObstacles::none;
        if (had && !on) obstacles_ = contact.obstacles;
        if (had != on) contact.obstacles = on ? obstacles_ : WantedObstacles::none;
    });
}

void SceneParts::set_tears(SceneSpec& scene, bool on) {
    on ? put_in(scene.tear, tear_) : take_out(scene.tear, tear_);
}

void SceneParts::set_flows(SceneSpec& scene, bool on) {
    on ? put_in(scene.flow, flow_) : take_out(scene.flow, flow_);
}

}  // namespace hepatica
