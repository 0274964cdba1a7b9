// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster/exr_writer.h"

#include "raster/exr_blocks.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include <zlib.h>

namespace candelabra {

namespace {

/// Numbers of the format, low byte first.
void append_exr(std::string& bytes, std::uint64_t number, int size) {
    for (int i = 0; i < size; ++i) bytes += static_cast<char>(number >> (8 * i) & 0xff);
}
void append_exr(std::string& bytes, float number) {
    append_exr(bytes, std::bit_cast<std::uint32_t>(number), 4);
}

/// The header's attributes in the order of their names, as OpenEXR sorts them.
class ExrHead {
public:
    ExrHead(int width, int height) {
        add("compression", "compression", std::string(1, static_cast<char>(exr_zip)));
        std::string window;
        for (const int corner : {0, 0, width - 1, height - 1})
            append_exr(window, static_cast<std::uint32_t>(corner), 4);
        add("dataWindow", "box2i", window);
        add("displayWindow", "box2i", window);
        add("lineOrder", "lineOrder", std::string(1, '\0'));
        std::string one, centre;
        append_exr(one, 1.0F);
        for (int i = 0; i < 2; ++i) append_exr(centre, 0.0F);
        add("pixelAspectRatio", "float", one);
        add("screenWindowCenter", "v2f", centre);
        add("screenWindowWidth", "float", one);
        add_text("Software", "Candelabra");
        add_text("capDate", "");  // a picture has no date, or it would be another file each time
    }

    void add(const std::string& name, std::string_view type, std::string value) {
        attributes_[name] = {type, std::move(value)};
    }
    void add_text(const std::string& name, const std::string& text) { add(name, "string", text); }

    /// Returns the file up to its table of chunks. `longest`: length of the longest channel name.
    std::string bytes(std::size_t longest) const {
        constexpr std::size_t short_name = 31;
        constexpr std::uint32_t long_names = 0x400, version = 2;
        for (const auto& [name, value] : attributes_) longest = std::max(longest, name.size());
        std::string bytes = std::string(exr_magic);
        append_exr(bytes, version | (longest > short_name ? long_names : 0), 4);
        for (const auto& [name, value] : attributes_) {
            bytes.append(name) += '\0';
            bytes.append(value.first) += '\0';
            append_exr(bytes, value.second.size(), 4);
            bytes += value.second;
        }
        return bytes += '\0';
    }

private:
    std::map<std::string, std::pair<std::string_view, std::string>> attributes_;
};

/// A channel, and where its values are: those of a row are `step` apart.
struct ExrChannel {
    std::string name;
    bool whole = false;
    const std::uint32_t* values = nullptr;
    std::size_t step = 1;
};

std::string channel_list(std::span<const ExrChannel> channels) {
    std::string list;
    for (const ExrChannel& channel : channels) {
        list.append(channel.name) += '\0';
        append_exr(list, channel.whole ? exr_uint : exr_float, 4);
        append_exr(list, 0, 4);  // it is not perceptually linear; three bytes are reserved
        append_exr(list, 1, 4);
        append_exr(list, 1, 4);
    }
    return list += '\0';
}

/// Returns the values of some rows as a chunk stores them: row by row, channel by channel.
std::string rows_of(std::span<const ExrChannel> channels, std::size_t width, std::size_t first,
                    std::size_t last) {
    std::string raw;
    raw.reserve(channels.size() * width * (last - first) * 4);
    for (std::size_t y = first; y < last; ++y)
        for (const ExrChannel& channel : channels)
            for (std::size_t x = 0; x < width; ++x)
                append_exr(raw, channel.values[(y * width + x) * channel.step], 4);
    return raw;
}

/// Returns the compressed rows, or the rows themselves if that is shorter.
std::string packed(std::string raw) {
    const std::string split = exr_split(raw);
    uLongf size = compressBound(split.size());
    std::string result(size, '\0');
    constexpr int level = 4;  // OpenEXR's
    const bool done =
        compress2(reinterpret_cast<Bytef*>(result.data()), &size,
                  reinterpret_cast<const Bytef*>(split.data()), split.size(), level) == Z_OK;
    if (!done || size >= raw.size()) return raw;
    result.resize(size);
    return result;
}

std::string write(ExrHead head, int width, int height, std::vector<ExrChannel> channels,
                  std::string& bytes) {
    if (width < 1 || height < 1 || channels.empty()) return "it has no pixels";
    std::ranges::stable_sort(channels, {}, &ExrChannel::name);
    std::size_t longest = 0;
    for (const ExrChannel& channel : channels) longest = std::max(longest, channel.name.size());
    head.add("channels", "chlist", channel_list(channels));
    bytes = head.bytes(longest);
    const auto rows = static_cast<std::size_t>(height);
    const std::size_t chunks = (rows + exr_zip_rows - 1) / exr_zip_rows;
    std::size_t table = bytes.size();
    bytes.resize(table + 8 * chunks);
    for (std::size_t first = 0; first < rows; first += exr_zip_rows, table += 8) {
        std::string place;
        append_exr(place, bytes.size(), 8);
        std::ranges::copy(place, bytes.begin() + static_cast<std::ptrdiff_t>(table));
        const std::string chunk = packed(rows_of(channels, static_cast<std::size_t>(width), first,
                                                 std::min(first + exr_zip_rows, rows)));
        append_exr(bytes, first, 4);
        append_exr(bytes, chunk.size(), 4);
        bytes += chunk;
    }
    return {};
}

}  // namespace

std::string write_exr(const RawPicture& picture, std::string& bytes) {
    const auto* values = std::get_if<std::vector<float>>(&picture.values);
    if (!values) return "an OpenEXR file has floats";
    std::vector<std::uint32_t> bits;
    bits.reserve(values->size());
    for (const float each : *values) bits.push_back(std::bit_cast<std::uint32_t>(each));
    ExrHead head(picture.width, picture.height);
    if (!picture.description.empty()) head.add_text("comments", picture.description);
    constexpr std::array colours = {"R", "G", "B", "A"};
    constexpr std::array greys = {"Y", "A"};
    const auto count = static_cast<std::size_t>(picture.channels);
    std::vector<ExrChannel> channels;
    for (std::size_t c = 0; c < count; ++c)
        channels.push_back({count < 3 ? greys[c] : colours[c], false, bits.data() + c, count});
    return write(std::move(head), picture.width, picture.height, std::move(channels), bytes);
}

std::string write_exr(const LayeredPicture& picture, std::string& bytes) {
    ExrHead head(picture.width, picture.height);
    for (const auto& [name, text] : picture.texts) head.add_text(name, text);
    std::vector<ExrChannel> channels;
    for (const ChannelPlane& plane : picture.planes)
        channels.push_back({plane.name, plane.whole, plane.bits.data(), 1});
    return write(std::move(head), picture.width, picture.height, std::move(channels), bytes);
}

}  // namespace candelabra
