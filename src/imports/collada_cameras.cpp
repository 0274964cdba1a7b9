// SPDX-License-Identifier: GPL-3.0-or-later
#include "imports/collada_cameras.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <system_error>

namespace candelabra {

namespace {

/// The number in an element; nothing if there is none.
std::optional<double> number_in(std::string_view block, std::string_view name) {
    const std::size_t begin = block.find("<" + std::string(name));
    const std::size_t end = begin == block.npos ? begin : block.find('>', begin);
    if (end == block.npos) return std::nullopt;
    block.remove_prefix(end + 1);
    block.remove_prefix(std::min(block.find_first_not_of(" \t\r\n"), block.size()));
    double number = 0;
    const auto read = std::from_chars(block.data(), block.data() + block.size(), number);
    return read.ec == std::errc() ? std::optional(number) : std::nullopt;
}

std::string element(std::string_view name, double number) {
    return "<" + std::string(name) + ">" + std::to_string(number) + "</" + std::string(name) + ">";
}

/// The inner part of a perspective camera that stands for a parallel one.
std::string told_parallel(std::string_view block) {
    const auto width = number_in(block, "xmag"), height = number_in(block, "ymag"),
               stated = number_in(block, "aspect_ratio");
    double aspect = stated.value_or(0);
    if (width && height && *height > 0) aspect = *width / *height;
    const double wide = width ? *width : height.value_or(1) * (aspect > 0 ? aspect : 1);
    if (!(aspect > 0) && !width) aspect = 1;
    return element("xfov", wide) +
           element("aspect_ratio", aspect > 0 ? -aspect : parallel_without_aspect);
}

constexpr std::string_view camera_tag = "<camera ";

/// Gives a name to cameras without one, whose optics Assimp does not read.
void name_cameras(std::string& text) {
    for (std::size_t at = 0; (at = text.find(camera_tag, at)) != text.npos;) {
        at += camera_tag.size();
        const std::size_t end = text.find('>', at);
        if (end == text.npos) return;
        if (std::string_view(text).substr(at, end - at).find("name=") == text.npos)
            text.insert(at, "name=\"camera\" ");
    }
}

/// Replaces what stands between the tags of this name.
template <class Change>
void change_each(std::string& text, const std::string& name, const std::string& new_name,
                 Change change) {
    const std::string open = "<" + name + ">", close = "</" + name + ">";
    for (std::size_t at = 0; (at = text.find(open, at)) != text.npos;) {
        const std::size_t inner = at + open.size(), end = text.find(close, inner);
        if (end == text.npos) return;
        const std::string made = "<" + new_name + ">" +
                                 change(std::string_view(text).substr(inner, end - inner)) + "</" +
                                 new_name + ">";
        text.replace(at, end + close.size() - at, made);
        at += made.size();
    }
}

}  // namespace

std::optional<std::string> with_told_cameras(std::string_view bytes) {
    if (bytes.find(camera_tag) == bytes.npos) return std::nullopt;
    std::string text(bytes);
    name_cameras(text);
    change_each(text, "perspective", "perspective", [](std::string_view block) {
        const bool lacks =
            block.find("<xfov") == block.npos && block.find("<aspect_ratio") == block.npos;
        return (lacks ? element("aspect_ratio", 1) : "") + std::string(block);
    });
    change_each(text, "orthographic", "perspective", told_parallel);
    return text;
}

}  // namespace candelabra
