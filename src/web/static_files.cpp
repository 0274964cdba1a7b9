// SPDX-License-Identifier: GPL-3.0-or-later
#include "web/static_files.h"

#include "text/ascii.h"
#include "text/opened_file.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <system_error>

#include <fcntl.h>

namespace candelabra {

namespace {

struct KnownType {
    std::string_view ending, type;
};
constexpr auto known_types = std::to_array<KnownType>({{".html", "text/html; charset=utf-8"},
                                                       {".css", "text/css; charset=utf-8"},
                                                       {".js", "text/javascript; charset=utf-8"},
                                                       {".json", "application/json"},
                                                       {".png", "image/png"},
                                                       {".jpg", "image/jpeg"},
                                                       {".webp", "image/webp"},
                                                       {".svg", "image/svg+xml"},
                                                       {".txt", "text/plain; charset=utf-8"}});

constexpr std::size_t max_bytes = std::size_t{64} << 20, max_path = 512;

/// Whether each part between slashes is a plain name.
bool is_plain(std::string_view path) {
    if (path.size() > max_path) return false;
    while (true) {
        const std::string_view name = path.substr(0, path.find('/'));
        const bool letters =
            std::ranges::all_of(name, [](char c) { return in_name(c) || c == '.' || c == '-'; });
        if (name.empty() || name.front() == '.' || !letters) return false;
        if (name.size() == path.size()) return true;
        path.remove_prefix(name.size() + 1);
    }
}

WebAnswer not_there() { return {"text/plain; charset=utf-8", "there is no such file\n", 404}; }

}  // namespace

WebAnswer static_file(const std::string& folder, std::string_view path) {
    std::string name(path);
    if (name.empty() || name.ends_with('/')) name += "index.html";
    const auto known = std::ranges::find_if(
        known_types, [&](const KnownType& each) { return name.ends_with(each.ending); });
    if (known == known_types.end() || !is_plain(name)) return not_there();
    std::error_code failed;
    const std::filesystem::path real = std::filesystem::canonical(folder, failed);
    if (failed) return not_there();
    const OpenedFile file = open_without_links((real / name).string(), O_RDONLY);
    if (!file || !is_regular_file(file)) return not_there();
    auto content = content_of(file, max_bytes);
    return content ? WebAnswer{std::string(known->type), std::move(*content)} : not_there();
}

}  // namespace candelabra
