// SPDX-License-Identifier: GPL-3.0-or-later
// An HTML page of pictures and tables, the report of a headless session. Its pictures are files
// beside it.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace hepatica {

class HtmlReport {
  public:
    // `language`: language of its text, as in HTML: "en".
    explicit HtmlReport(std::string title, std::string language = "en")
        : title_(std::move(title)), language_(std::move(language)) {}

    void add_heading(const std::string& text);
    void add_paragraph(const std::string& text);
    // `file` is relative to the page and not copied.
    void add_picture(const std::filesystem::path& file, const std::string& caption);
    // Several pictures, two in a row.
    void add_pictures(const std::vector<std::pair<std::filesystem::path, std::string>>& pictures);
    // An object becomes rows of key and value; an array of objects becomes a table with a column
    // per key.
    void add_table(const nlohmann::ordered_json& facts);

    std::string text() const;
    // Writes atomically. Throws InputError where the page cannot be written.
    void write(const std::filesystem::path& file) const;

  private:
    std::string title_, language_;
    std::string body_;
};

}  // namespace hepatica
