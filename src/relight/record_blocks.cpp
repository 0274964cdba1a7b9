// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/record_blocks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <zlib.h>

namespace candelabra {

namespace {

constexpr std::uint64_t most_pixels = std::uint64_t{1} << 28;
constexpr std::uint32_t most_lamps = std::uint32_t{1} << 30;

void append_text(std::string& bytes, const std::string& text) {
    append_number(bytes, static_cast<std::uint32_t>(text.size()));
    bytes += text;
}

std::string text_from(ByteReader& reader) {
    return std::string(reader.take(reader.number<std::uint32_t>()));
}

bool take_lamps(ByteReader& reader, LampList& lamps) {
    const auto count = reader.number<std::uint32_t>();
    constexpr std::size_t least_group = 8, lamp_bytes = 8;
    if (!reader.has(count, least_group)) return false;
    std::vector<LampGroup> groups;
    for (std::uint32_t i = 0; i < count && reader.good(); ++i) {
        std::string name = text_from(reader);
        groups.push_back({std::move(name), reader.number<std::uint32_t>()});
    }
    const auto size = reader.number<std::uint32_t>();
    if (size > most_lamps || !reader.has(size, lamp_bytes)) return false;
    std::vector<std::uint32_t> numbers(size);
    std::vector<float> powers(size);
    for (std::uint32_t& number : numbers) number = reader.number<std::uint32_t>();
    for (float& power : powers) power = reader.real();
    const auto usable = [](float power) { return power >= 1e-12F && power <= 1e12F; };
    if (!reader.good() || !std::ranges::all_of(powers, usable) || !are_numbers_of(groups, numbers))
        return false;
    lamps = LampList(std::move(groups), std::move(numbers), std::move(powers));
    return true;
}

bool take_meter(ByteReader& reader, std::size_t nodes, KeptMeter& meter) {
    meter.name = text_from(reader);
    meter.quantity = text_from(reader);
    meter.unit = text_from(reader);
    const auto points = reader.number<std::uint32_t>();
    // Three coordinates of 8 bytes, the rest, and three numbers for each node.
    if (!reader.has(points, 3 * sizeof(double) + sizeof(float) * (1 + 3 * nodes))) return false;
    const auto finite = [](double value) { return std::isfinite(value); };
    for (std::uint32_t i = 0; i < points; ++i) {
        Vec3 place;
        for (int c = 0; c < 3; ++c)
            place[c] = std::bit_cast<double>(reader.number<std::uint64_t>());
        if (!finite(place.x) || !finite(place.y) || !finite(place.z)) return false;
        meter.points.push_back(place);
    }
    for (std::uint32_t i = 0; i < points; ++i) meter.rest.push_back(reader.real());
    meter.light.resize(std::size_t{3} * points * nodes);
    for (float& value : meter.light) value = reader.real();
    return reader.good() && std::ranges::all_of(meter.rest, finite) &&
           std::ranges::all_of(meter.light, finite);
}

}  // namespace

std::uint64_t most_unpacked(std::size_t file_bytes) {
    constexpr std::uint64_t small_file = std::uint64_t{1} << 28, factor = 128;
    return small_file + factor * file_bytes;
}

std::string packed_by_zlib(const std::string& raw, int effort) {
    uLongf size = compressBound(static_cast<uLong>(raw.size()));
    std::string packed(size, '\0');
    compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
              reinterpret_cast<const Bytef*>(raw.data()), static_cast<uLong>(raw.size()), effort);
    packed.resize(size);
    return packed;
}

std::string block_of(const std::string& raw) {
    constexpr int fast = 1;
    const std::string packed = packed_by_zlib(raw, fast);
    std::string block;
    append_number(block, static_cast<std::uint64_t>(raw.size()));
    append_number(block, static_cast<std::uint64_t>(packed.size()));
    return block + packed;
}

std::optional<std::string> take_block(ByteReader& reader, std::uint64_t& left) {
    const auto size = reader.number<std::uint64_t>(), packed_size = reader.number<std::uint64_t>();
    const std::string_view packed = reader.take(packed_size);
    if (!reader.good() || size > left) return std::nullopt;
    left -= size;
    std::string raw(static_cast<std::size_t>(size), '\0');
    auto made = static_cast<uLongf>(size);
    const int result = uncompress(reinterpret_cast<Bytef*>(raw.data()), &made,
                                  reinterpret_cast<const Bytef*>(packed.data()),
                                  static_cast<uLong>(packed.size()));
    if (result != Z_OK || made != size) return std::nullopt;
    return raw;
}

std::string head_of(const LightRecords& records) {
    std::string head;
    append_number(head, static_cast<std::uint32_t>(records.width));
    append_number(head, static_cast<std::uint32_t>(records.height));
    append_text(head, records.origin);
    append_text(head, records.film);
    append_number(head, static_cast<std::uint32_t>(records.lamps.groups().size()));
    for (const LampGroup& group : records.lamps.groups()) {
        append_text(head, group.name);
        append_number(head, group.lamps);
    }
    append_number(head, records.lamps.size());
    for (const std::uint32_t number : records.lamps.numbers()) append_number(head, number);
    for (const float power : records.lamps.powers()) append_float(head, power);
    return head;
}

bool take_head(const std::string& raw, LightRecords& records) {
    ByteReader reader(raw);
    const auto width = reader.number<std::uint32_t>(), height = reader.number<std::uint32_t>();
    if (width == 0 || height == 0 || width > most_pixels || height > most_pixels / width)
        return false;
    records.width = static_cast<int>(width);
    records.height = static_cast<int>(height);
    records.origin = text_from(reader);
    records.film = text_from(reader);
    return take_lamps(reader, records.lamps) && reader.left().empty();
}

std::string normals_of(const std::vector<std::int8_t>& normals) {
    return {normals.begin(), normals.end()};
}

bool take_normals(const std::string& raw, LightRecords& records) {
    const std::size_t numbers =
        3 * static_cast<std::size_t>(records.width) * static_cast<std::size_t>(records.height);
    if (!raw.empty() && raw.size() != numbers) return false;
    records.normals.assign(raw.begin(), raw.end());
    return true;
}

std::string meters_of(const KeptMeters& kept) {
    std::string bytes;
    append_number(bytes, static_cast<std::uint32_t>(kept.nodes.size()));
    for (const LampRange& node : kept.nodes) append_number(bytes, node.last);
    append_number(bytes, static_cast<std::uint32_t>(kept.meters.size()));
    for (const KeptMeter& meter : kept.meters) {
        for (const std::string* text : {&meter.name, &meter.quantity, &meter.unit})
            append_text(bytes, *text);
        append_number(bytes, static_cast<std::uint32_t>(meter.points.size()));
        for (const Vec3& point : meter.points)
            for (int c = 0; c < 3; ++c)
                append_number(bytes, std::bit_cast<std::uint64_t>(point[c]));
        for (const float value : meter.rest) append_float(bytes, value);
        for (const float value : meter.light) append_float(bytes, value);
    }
    return bytes;
}

bool take_meters(const std::string& raw, std::uint32_t lamps, KeptMeters& kept) {
    ByteReader reader(raw);
    const auto nodes = reader.number<std::uint32_t>();
    if (!reader.has(nodes, sizeof(std::uint32_t))) return false;
    std::uint32_t at = 0;
    for (std::uint32_t i = 0; i < nodes; ++i) {
        const auto last = reader.number<std::uint32_t>();
        if (last <= at || last > lamps) return false;
        kept.nodes.push_back({std::exchange(at, last), last});
    }
    const auto meters = reader.number<std::uint32_t>();
    constexpr std::size_t least_meter = 16;
    if (!reader.has(meters, least_meter)) return false;
    for (std::uint32_t i = 0; i < meters; ++i)
        if (!take_meter(reader, nodes, kept.meters.emplace_back())) return false;
    return reader.left().empty() && reader.good();
}

}  // namespace candelabra
