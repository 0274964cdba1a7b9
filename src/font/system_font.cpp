// SPDX-License-Identifier: GPL-3.0-or-later
#include "font/system_font.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace candelabra {

namespace fs = std::filesystem;

namespace {

constexpr auto folders = std::array{"/usr/share/fonts", "/usr/local/share/fonts"};

std::optional<fs::path> find(const fs::path& folder, const std::string& file_name) {
    std::error_code wrong;
    fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied,
                                        wrong);
    for (; !wrong && at != fs::recursive_directory_iterator(); at.increment(wrong))
        if (at->path().filename() == file_name) return at->path();
    return std::nullopt;
}

}  // namespace

std::optional<std::string> system_font(const std::string& file_name) {
    if (file_name.empty() || file_name.find('/') != std::string::npos) return std::nullopt;
    for (const char* folder : folders)
        if (const auto path = find(folder, file_name)) {
            std::ifstream file(*path, std::ios::binary);
            if (file) return std::string(std::istreambuf_iterator<char>(file), {});
        }
    return std::nullopt;
}

std::span<const char* const> fonts_like(std::string_view file_name) {
    static constexpr const char* serif[] = {"LiberationSerif-Regular.ttf", "DejaVuSerif.ttf"};
    static constexpr const char* sans[] = {"LiberationSans-Regular.ttf", "DejaVuSans.ttf"};
    static constexpr const char* mono[] = {"LiberationMono-Regular.ttf", "DejaVuSansMono.ttf"};
    if (file_name.ends_with(".ttf")) file_name.remove_suffix(4);
    if (file_name == "timrom") return serif;
    if (file_name == "cyrvetic") return sans;
    if (file_name == "crystal") return mono;
    return {};
}

}  // namespace candelabra
