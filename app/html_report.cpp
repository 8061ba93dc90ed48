// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/html_report.h"

#include <cmath>
#include <cstdio>

#include "core/base/atomic_write.h"

namespace hepatica {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* style =
    "body{font:16px/1.5 system-ui,sans-serif;max-width:60rem;margin:2rem auto;padding:0 1rem;"
    "color:#222;background:#fff}figure{margin:1.5rem 0}img{max-width:100%;border-radius:4px}"
    "figcaption{color:#555}table{border-collapse:collapse;margin:1rem 0}"
    "td,th{border-bottom:1px solid #ddd;padding:.2rem .8rem;text-align:left}"
    ".pair{display:grid;grid-template-columns:1fr 1fr;gap:1rem}.pair figure{margin:0}"
    "td.number{text-align:right;font-variant-numeric:tabular-nums}";

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += c;
        }
    }
    return out;
}

// A path below the page as an address: what would end the path, or is no ASCII, as %XX.
std::string address_of(const std::filesystem::path& file) {
    std::string out;
    for (const char c : file.generic_string()) {
        const auto byte = static_cast<unsigned char>(c);
        char code[4];
        std::snprintf(code, sizeof code, "%%%02X", byte);
        const bool plain = byte > ' ' && byte < 0x7f && c != '%' && c != '#' && c != '?';
        out += plain ? std::string(1, c) : code;
    }
    return escaped(out);
}

std::string words(const std::string& key) {
    std::string text = key;
    for (char& c : text)
        if (c == '_') c = ' ';
    return escaped(text);
}

std::string cell(const Json& value) {
    if (value.is_number_float() && !std::isfinite(value.get<double>())) return "<td>none</td>";
    if (value.is_number_float()) {
        char text[32];
        std::snprintf(text, sizeof text, "%.4g", value.get<double>());
        return std::string("<td class=\"number\">") + text + "</td>";
    }
    if (value.is_number()) return "<td class=\"number\">" + value.dump() + "</td>";
    return "<td>" + escaped(value.is_string() ? value.get<std::string>() : value.dump()) + "</td>";
}

bool is_table(const Json& facts) {
    return facts.is_array() && !facts.empty() && facts.front().is_object();
}

}  // namespace

void HtmlReport::add_heading(const std::string& text) {
    body_ += "<h2>" + escaped(text) + "</h2>\n";
}

void HtmlReport::add_paragraph(const std::string& text) {
    body_ += "<p>" + escaped(text) + "</p>\n";
}

void HtmlReport::add_picture(const std::filesystem::path& file, const std::string& caption) {
    body_ += "<figure><img src=\"" + address_of(file) + "\" alt=\"" + escaped(caption) +
             "\"><figcaption>" + escaped(caption) + "</figcaption></figure>\n";
}

void HtmlReport::add_pictures(
    const std::vector<std::pair<std::filesystem::path, std::string>>& pictures) {
    body_ += "<div class=\"pair\">\n";
    for (const auto& [file, caption] : pictures) add_picture(file, caption);
    body_ += "</div>\n";
}

void HtmlReport::add_table(const Json& facts) {
    body_ += "<table>\n";
    if (is_table(facts)) {
        body_ += "<thead><tr>";  // repeated on each printed page
        for (const auto& [key, value] : facts.front().items())
            body_ += "<th>" + words(key) + "</th>";
        body_ += "</tr></thead>\n";
        for (const Json& row : facts) {
            body_ += "<tr>";
            for (const auto& [key, value] : row.items()) body_ += cell(value);
            body_ += "</tr>\n";
        }
    } else {
        for (const auto& [key, value] : facts.items())
            body_ += "<tr><th>" + words(key) + "</th>" + cell(value) + "</tr>\n";
    }
    body_ += "</table>\n";
}

std::string HtmlReport::text() const {
    return "<!doctype html>\n<html lang=\"" + language_ + "\"><meta charset=\"utf-8\"><title>" +
           escaped(title_) + "</title><style>" + style + "</style>\n<h1>" + escaped(title_) +
           "</h1>\n" + body_ + "</html>\n";
}

void HtmlReport::write(const std::filesystem::path& file) const {
    write_text_atomically(file, text());
}

}  // namespace hepatica
