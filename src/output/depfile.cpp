// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/depfile.h"

#include <algorithm>
#include <set>
#include <string_view>

namespace candelabra {

namespace {

std::string escaped(const std::string& path) {
    std::string text;
    for (const char c : path) {
        if (std::string_view(" #\\:%*?[]").find(c) != std::string_view::npos) text += '\\';
        if (c == '$') text += '$';
        text += c;
    }
    return text;
}

/// Whether a rule can have the name: control characters end its line, others begin a recipe, an
/// assignment or another kind of prerequisite.
bool is_nameable(const std::string& path) {
    return std::ranges::none_of(path, [](unsigned char c) {
        return c < ' ' || c == 0x7F || c == ';' || c == '=' || c == '|';
    });
}

}  // namespace

std::string unnameable_in_depfile(const std::string& picture, const std::vector<ReadFile>& files) {
    if (!is_nameable(picture)) return picture;
    for (const ReadFile& file : files)
        if (!is_nameable(file.path)) return file.path;
    return {};
}

std::string depfile(const std::string& picture, const std::vector<ReadFile>& files) {
    std::string text = escaped(picture) + ":";
    std::set<std::string> seen;
    for (const ReadFile& file : files)
        if (file.path != "-" && seen.insert(file.path).second)
            text += " \\\n  " + escaped(file.path);
    return text + "\n";
}

}  // namespace candelabra
