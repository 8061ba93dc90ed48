// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/command.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/error.h"
#include "core/session/recording_file.h"

namespace hepatica {
namespace {

using Json = nlohmann::ordered_json;

std::vector<Command> one_of_each() {
    const double odd = std::nextafter(0.1, 1.0);  // survives only if every bit does
    return {GrabPoint{Vec3(odd, -1e-300, 1e4)},
            GrabVertex{42},
            MoveGrab{Vec3(1.0 / 3.0, 2, 3)},
            MoveGrab{Vec3(1, 2, 3), odd},
            ShiftGrab{Vec3(1, odd, 3)},
            ReleaseGrab{},
            InjectDrug{Vec3(1, 2, 3), odd, 0.25, "lipiodol", "published", 1e-3},
            InjectDrug{},
            RemoveDrug{},
            PlayDrug{false},
            SetDrugTime{odd},
            SetDrugSpeed{0.5},
            SetGravity{Vec3(0, 0, -9806.65)},
            SetTether{odd},
            SetQuality{odd},
            SetPaused{true},
            ResetWorld{},
            RestoreSnapshot{},
            SetAutomaticQuality{false},
            UseSetting{},
            SetWall{odd},
            FinishInjection{},
            AddTool{"capsule", odd, 12.0, Vec3(0, odd, 1), Vec3(1, 2, odd)},
            MoveTool{Vec3(odd, 2, 3), odd},
            ShiftTool{Vec3(1, odd, 3)},
            RemoveTool{},
            TurnTool{Vec3(odd, 0, -1)},
            UseTools{false},
            AddTool{"hook", 1.0, odd, Vec3(0, odd, 1), Vec3(1, 2, odd), Vec3(odd, 1, 0)},
            CloseForceps{odd},
            OpenForceps{0.5},
            CutLine{Vec3(1, odd, 3), Vec3(odd, 2, 3), odd},
            Blade{Vec3(1, odd, 3), Vec3(odd, 2, 3)},
            UseTear{false, odd},
            UseContact{false, true, odd}};
}

TEST(Command, SurvivesJsonToTheLastBit) {
    std::set<std::size_t> kinds;
    for (const Command& command : one_of_each()) kinds.insert(command.index());
    EXPECT_EQ(kinds.size(), std::variant_size_v<Command>);
    for (const Command& command : one_of_each()) {
        const Json json = to_json(command);
        const Command back = command_from_json(Json::parse(json.dump()));
        EXPECT_EQ(back.index(), command.index());
        EXPECT_EQ(to_json(back).dump(), json.dump());
    }
    const auto point =
        std::get<GrabPoint>(command_from_json(Json::parse(to_json(one_of_each().front()).dump())));
    EXPECT_EQ(point.point_mm, std::get<GrabPoint>(one_of_each().front()).point_mm);
}

TEST(Command, NamesWhatIsWrong) {
    for (const char* text :
         {R"({})", R"([])", R"(3)", R"({"command": 3})", R"({"command": "fly"})",
          R"({"command": "grab_point"})", R"({"command": "grab_point", "point_mm": [1, 2]})",
          R"({"command": "set_quality", "quality": "high"})"})
        EXPECT_THROW(command_from_json(Json::parse(text)), InputError) << text;
}

// Such a step may never end.
TEST(Command, RefusesANumberBeyondWhatABodyCanBe) {
    int refused = 0;
    const auto expect_refused = [&](const Json& json, const std::string& field) {
        try {
            command_from_json(json);
            ADD_FAILURE() << json.dump();
        } catch (const InputError& error) {
            ++refused;
            const std::string words = error.what();
            EXPECT_NE(words.find("field " + field), std::string::npos) << words;
            EXPECT_NE(words.find("1e+308; it must lie from "), std::string::npos) << words;
        }
    };
    for (const Command& command : one_of_each()) {
        const Json sound = to_json(command);
        for (const auto& [field, value] : sound.items())
            for (const double far : {1e308, -1e308}) {
                Json json = sound;
                if (value.is_number_float()) json[field] = far;
                if (value.is_array()) json[field][1] = far;
                if (value.is_number_float() || value.is_array()) expect_refused(json, field);
            }
    }
    EXPECT_GT(refused, 60);
    EXPECT_NO_THROW(command_from_json(to_json(GrabPoint{Vec3(1e4, -1e4, 0.0)})));
    EXPECT_THROW(command_from_json(to_json(GrabPoint{Vec3(0.0, 0.0, 10001.0)})), InputError);
}

TEST(Recording, SurvivesTheDisk) {
    const auto file = std::filesystem::path(testing::TempDir()) / "session.hrec";
    Recording recording;
    recording.program = program_version();
    recording.back_end = cpu_back_end().name;
    recording.patient_hash = 0x0123456789abcdefULL;
    recording.scene = default_scene();
    recording.steps = {{one_of_each(), 1, nullptr}, {{}, 0xffffffffffffffffULL, nullptr}};
    write_recording(file, recording);
    const Recording back = read_recording(file);
    EXPECT_EQ(back.program, recording.program);
    EXPECT_EQ(back.back_end, "cpu");
    EXPECT_EQ(back.patient_hash, recording.patient_hash);
    ASSERT_EQ(back.steps.size(), 2u);
    EXPECT_EQ(back.steps[0].commands.size(), one_of_each().size());
    EXPECT_EQ(back.steps[1].state_hash, 0xffffffffffffffffULL);

    std::ofstream(file, std::ios::app) << "{\"hash\": \"12\"}\n";
    EXPECT_THROW(read_recording(file), InputError);
    std::ofstream(file) << "a text";
    EXPECT_THROW(read_recording(file), InputError);
    std::ofstream(file, std::ios::trunc).close();
    EXPECT_THROW(read_recording(file), InputError);
    try {
        read_recording(file.string() + ".missing");
        ADD_FAILURE();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("does not exist"), std::string::npos);
    }
}

template <std::size_t... alternative>
std::vector<std::string> names_of_all(std::index_sequence<alternative...> /*of the variant*/) {
    return {to_json(Command(std::in_place_index<alternative>))["command"].get<std::string>()...};
}

TEST(Command, IsDocumentedWithItsKeys) {
    std::ifstream file(std::string(HEPATICA_SOURCE_DIR) + "/docs/scenes.md");
    const std::string document{std::istreambuf_iterator<char>(file), {}};
    const std::vector<std::string> names =
        names_of_all(std::make_index_sequence<std::variant_size_v<Command>>());
    EXPECT_GT(names.size(), 25u);
    for (const std::string& name : names)
        EXPECT_NE(document.find("| `" + name + "`"), std::string::npos) << name;
}

}  // namespace
}  // namespace hepatica
