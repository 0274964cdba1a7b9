// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/depfile.h"

#include <set>

namespace candelabra {

namespace {

std::string escaped(const std::string& path) {
    std::string text;
    for (const char c : path) {
        if (c == ' ' || c == '#' || c == '\\' || c == ':') text += '\\';
        if (c == '$') text += '$';
        text += c;
    }
    return text;
}

}  // namespace

std::string depfile(const std::string& picture, const std::vector<ReadFile>& files) {
    std::string text = escaped(picture) + ":";
    std::set<std::string> seen;
    for (const ReadFile& file : files)
        if (file.path != "-" && seen.insert(file.path).second)
            text += " \\\n  " + escaped(file.path);
    return text + "\n";
}

}  // namespace candelabra
