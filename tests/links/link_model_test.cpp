// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/links/link_model.h"

#include <gtest/gtest.h>

#include <fstream>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/program_files.h"
#include "core/base/temporary_folder.h"
#include "core/base/text_file.h"

namespace hepatica {
namespace {

LinkModel small_model() {
    LinkModel model;
    model.made_by = "a \"test\"";
    model.line_share = 0.8;
    model.kept_share = 0.55;
    model.forest.trees = {{{3, 1.25, 1, 2}, {-1, 0.125, -1, -1}, {-1, 1.0, -1, -1}},
                          {{-1, 0.5, -1, -1}}};
    return model;
}

class LinkModelFile : public testing::Test {
  protected:
    std::string refused(const std::string& text) {
        std::ofstream(file_) << text;
        try {
            read_link_model(file_);
        } catch (const InputError& error) {
            EXPECT_EQ(error.place(), file_.string());
            EXPECT_FALSE(error.remedy().empty());
            return error.problem();
        }
        ADD_FAILURE() << "was not refused: " << text;
        return "";
    }

    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_.path() / "links.json";
};

TEST_F(LinkModelFile, ComesBackAsItWasWritten) {
    const LinkModel model = small_model();
    write_link_model(file_, model);
    const LinkModel read = read_link_model(file_);
    EXPECT_EQ(read.made_by, model.made_by);
    EXPECT_DOUBLE_EQ(read.line_share, model.line_share);
    EXPECT_DOUBLE_EQ(read.kept_share, model.kept_share);
    ASSERT_EQ(read.forest.trees.size(), 2u);
    for (std::size_t t = 0; t < 2; ++t) {
        ASSERT_EQ(read.forest.trees[t].size(), model.forest.trees[t].size());
        for (std::size_t i = 0; i < read.forest.trees[t].size(); ++i) {
            const ForestNode &a = read.forest.trees[t][i], &b = model.forest.trees[t][i];
            EXPECT_EQ(a.feature, b.feature);
            EXPECT_DOUBLE_EQ(a.value, b.value);
            EXPECT_EQ(a.up_to, b.up_to);
            EXPECT_EQ(a.above, b.above);
        }
    }
}

TEST_F(LinkModelFile, WhatIsNoModelIsRefusedInWords) {
    write_link_model(file_, small_model());
    const std::string good = read_text_file(file_, "");
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        text.replace(text.find(from), from.size(), to);
        return text;
    };
    EXPECT_NE(refused("{").find("damaged"), std::string::npos);
    EXPECT_NE(refused("[]").find("damaged"), std::string::npos);
    EXPECT_NE(refused("{}").find("no model"), std::string::npos);
    EXPECT_NE(refused(with("hepatica-links", "hepatica-case")).find("no model"), std::string::npos);
    EXPECT_NE(refused(with("\"version\": 1", "\"version\": 2")).find("version 2"),
              std::string::npos);
    EXPECT_NE(refused(with("rise low", "rise high")).find("other features"), std::string::npos);
    EXPECT_NE(refused(with("\"line_share\": 0.8", "\"line_share\": 0.1")).find("0.1"),
              std::string::npos);
    EXPECT_NE(refused(with("\"kept_share\": 0.55", "\"kept_share\": 1.5")).find("1.5"),
              std::string::npos);
    EXPECT_NE(refused(with("[3,1.25,1,2]", "[3,1.25,1,7]")).find("node 7"), std::string::npos);
    EXPECT_NE(refused(with("[3,1.25,1,2]", "[3,1.25]")).find("damaged"), std::string::npos);
    EXPECT_NE(refused(with("[3,1.25,1,2]", "[-1,0.5,1,2]")).find("[-1,0.5,1,2]"),
              std::string::npos);
    EXPECT_NE(refused(with("[3,1.25,1,2]", "[3,1.25,1,2,3]")).find("[3,1.25,1,2,3]"),
              std::string::npos);
    EXPECT_NE(refused(with("[3,1.25,1,2]", "[1e300,1.25,1,2]")).find("whole number"),
              std::string::npos);
    EXPECT_NE(refused(with("[3,1.25,1,2]", "[]")).find("damaged"), std::string::npos);
    EXPECT_NE(refused(good.substr(0, good.size() / 2)).find("damaged"), std::string::npos);
}

TEST_F(LinkModelFile, AMissingFileIsNamed) {
    EXPECT_THROW(read_link_model(folder_.path() / "none.json"), InputError);
}

TEST(ShippedModel, CanBeReadAndSaysHowItWasMade) {
    const std::filesystem::path file = asset("models/links.json");
    const LinkModel model = read_link_model(file);
    EXPECT_EQ(model.made_by.find("hepatica-cli train --seed "), 0u);
    EXPECT_LT(std::filesystem::file_size(file), 2000000u);
    EXPECT_GE(model.forest.trees.size(), 20u);
}

}  // namespace
}  // namespace hepatica
