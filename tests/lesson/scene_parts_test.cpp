// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/scene_parts.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "core/lesson/lesson_file.h"

namespace hepatica {
namespace {

using Set = void (SceneParts::*)(SceneSpec&, bool);

bool on(const SceneSpec& scene, int part) {
    const bool ticks[] = {scene.deform.has_value(),
                          scene.contact && scene.contact->tools,
                          scene.contact && scene.contact->self,
                          scene.contact && scene.contact->obstacles != WantedObstacles::none,
                          scene.tear.has_value(),
                          scene.flow.has_value()};
    return ticks[part];
}

// Each tick that the scene allows the other way and back leaves it as it was.
void expect_ticks_undo_themselves(const SceneSpec& before, const std::string& which) {
    constexpr Set sets[] = {&SceneParts::set_moves, &SceneParts::set_touches,
                            &SceneParts::set_self,  &SceneParts::set_obstacles,
                            &SceneParts::set_tears, &SceneParts::set_flows};
    SceneParts parts;
    for (int part = 0; part < 6; ++part) {
        const bool needs_moving = part >= 1 && part <= 4;
        if (needs_moving && !before.deform) continue;
        SceneSpec scene = before;
        const bool was = on(scene, part);
        (parts.*sets[part])(scene, !was);
        EXPECT_NE(on(scene, part), was) << which << ", tick " << part;
        (parts.*sets[part])(scene, was);
        EXPECT_EQ(to_json(scene), to_json(before)) << which << ", tick " << part;
    }
}

SceneSpec random_scene(std::mt19937& random) {
    const auto yes = [&] { return random() % 2 == 0; };
    const auto number = [&] { return std::uniform_real_distribution<double>(0.1, 0.9)(random); };
    SceneSpec scene;
    scene.deform.reset();
    scene.flow.reset();
    scene.dt_s = 0.01 * number();
    if (yes()) {
        scene.deform = DeformSpec{"hepatic vein", FixedEnds::all};
        scene.deform->gravity_mm_per_s2 = Vec3(number(), -number(), 0.0);
        scene.deform->tether_pa_per_mm2 = 30.0 * number();
        scene.deform->wall_mm = yes() ? number() : 0.0;
        scene.deform->quality = number();
        scene.deform->velocity_error = {number(), number()};
        if (yes()) scene.deform->setting = StepperOptions{};
        if (yes()) scene.contact = ContactSpec{yes(), yes(), WantedObstacles(random() % 3)};
        if (scene.contact && scene.contact->self && yes()) scene.contact->friction = number();
        if (yes()) {
            scene.tear = TearSpec{number(), TearStop::vertices, number(), 17, yes()};
        }
    }
    if (yes() || !scene.deform) scene.flow = FlowSpec{7.0 * number()};
    return scene;
}

TEST(SceneParts, TakenOutAndPutInAgainAreAsBefore) {
    for (const BuiltInLesson& entry : built_in_lessons())
        expect_ticks_undo_themselves(find_lesson(entry.id).scene, entry.id);
    std::mt19937 random(7);
    for (int i = 0; i < 200; ++i)
        expect_ticks_undo_themselves(random_scene(random), "scene " + std::to_string(i));
}

TEST(SceneParts, WhatWasTakenOutBeforeTheVesselsStoppedDoesNotComeWithThem) {
    SceneSpec scene;
    scene.tear = TearSpec{2.0};
    SceneParts parts;
    parts.set_tears(scene, false);
    parts.set_moves(scene, false);
    parts.set_moves(scene, true);
    EXPECT_FALSE(scene.tear);
    parts.set_tears(scene, true);
    EXPECT_EQ(scene.tear->tear_factor, 2.0);
}

// Which a scene could not be read with.
TEST(SceneParts, WhatDoesNotTouchDoesNotRub) {
    SceneSpec scene;
    scene.contact = ContactSpec{true, true, WantedObstacles::none, 0.3};
    SceneParts parts;
    parts.set_self(scene, false);
    EXPECT_EQ(scene.contact->friction, 0.0);
    parts.set_self(scene, true);
    EXPECT_EQ(scene.contact->friction, 0.3);
}

TEST(SceneParts, OfAnotherLessonBeginAnew) {
    SceneSpec scene;
    scene.tear = TearSpec{2.0};
    SceneParts parts;
    parts.set_tears(scene, false);
    parts.forget();
    parts.set_tears(scene, true);
    EXPECT_EQ(*scene.tear, TearSpec{});
}

}  // namespace
}  // namespace hepatica
