// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/checkpoint.h"

#include "base/random.h"
#include "picture/layers.h"
#include "picture/write.h"
#include "text/message.h"
#include "text/printable.h"
#include "text/sha256.h"

#include <algorithm>
#include <array>
#include <bit>
#include <functional>
#include <sstream>

namespace candelabra {

namespace {

constexpr auto texts =
    std::to_array<std::string_view>({"candelabraIdentity", "candelabraShare", "candelabraState"});
constexpr auto channels = std::array{"R", "G", "B"};

/// A plane with 32 bits of the sums of each pixel.
struct StatePart {
    std::string name;
    std::function<std::uint32_t(const Film&, std::size_t pixel)> get;
    std::function<void(Film&, std::size_t pixel, std::uint32_t bits)> set;
};

/// Returns a part that is stored in the pixel's own sums.
template <class Get, class Set>
StatePart own_part(std::string name, const Get& get, const Set& set) {
    return {std::move(name),
            [get](const Film& film, std::size_t i) { return get(film.pixels()[i]); },
            [set](Film& film, std::size_t i, std::uint32_t bits) { set(film.pixels()[i], bits); }};
}

using Counts = std::array<std::uint64_t, 3>;

StatePart half_of(Counts PixelSum::*sums, std::size_t channel, int half, std::string name) {
    const int shift = 32 * half;
    return own_part(
        std::move(name),
        [=](const PixelSum& p) { return static_cast<std::uint32_t>((p.*sums)[channel] >> shift); },
        [=](PixelSum& p, std::uint32_t bits) {
            (p.*sums)[channel] |= std::uint64_t{bits} << shift;
        });
}

/// Returns a part for one word of a sum besides those of the picture.
StatePart extra_part(std::size_t which, int word) {
    return {message("extra.", which, ".", word),
            [=](const Film& film, std::size_t i) { return film.extra(i)[which].word(word); },
            [=](Film& film, std::size_t i, std::uint32_t bits) {
                film.extra(i)[which].set_word(word, bits);
            }};
}

constexpr std::string_view negative_plane = "negative";

/// Lists the parts of a state. `negative`: some samples were subtracted, which happens only with
/// wide filters.
std::vector<StatePart> parts(std::size_t aovs, bool negative) {
    std::vector<StatePart> all;
    const auto add_number = [&](std::string name, std::uint32_t PixelSum::*number) {
        all.push_back(own_part(
            std::move(name), [=](const PixelSum& p) { return p.*number; },
            [=](PixelSum& p, std::uint32_t bits) { p.*number = bits; }));
    };
    add_number("samples", &PixelSum::samples);
    add_number("target", &PixelSum::planned);
    add_number("shadow_rays", &PixelSum::shadow_rays);
    if (negative) add_number(std::string(negative_plane), &PixelSum::negative);
    for (std::size_t c = 0; c < channels.size(); ++c) {
        for (int i = 0; i < 4; ++i)
            all.push_back(own_part(
                message("sum.", channels[c], i),
                [=](const PixelSum& p) { return p.radiance[c].word(i); },
                [=](PixelSum& p, std::uint32_t bits) { p.radiance[c].set_word(i, bits); }));
        for (int i = 0; i < 2; ++i) {
            all.push_back(half_of(&PixelSum::display, c, i, message("shown.", channels[c], i)));
            all.push_back(
                half_of(&PixelSum::display_squared, c, i, message("squares.", channels[c], i)));
        }
    }
    for (std::size_t which = 0; which < aovs; ++which)
        for (int word = 0; word < 4; ++word) all.push_back(extra_part(which, word));
    return all;
}

/// Returns the number of sums per pixel besides those of the picture.
std::size_t extras_in(const LayeredPicture& picture) {
    const auto planes = std::ranges::count_if(
        picture.planes, [](const ChannelPlane& plane) { return plane.name.starts_with("extra."); });
    return static_cast<std::size_t>(planes) / 4;
}

bool has_negative(const LayeredPicture& picture) {
    return std::ranges::find(picture.planes, negative_plane, &ChannelPlane::name) !=
           picture.planes.end();
}

bool has_negative(const Film& film) {
    return std::ranges::any_of(film.pixels(),
                               [](const PixelSum& pixel) { return pixel.negative > 0; });
}

/// Returns a checksum of all state planes in order, or nothing if a plane is missing.
std::optional<std::uint64_t> checksum(const LayeredPicture& picture) {
    std::uint64_t sum = mix(static_cast<std::uint64_t>(picture.width));
    for (const StatePart& part : parts(extras_in(picture), has_negative(picture))) {
        const auto plane = std::ranges::find(picture.planes, part.name, &ChannelPlane::name);
        if (plane == picture.planes.end()) return std::nullopt;
        for (const std::uint32_t bits : plane->bits) sum = mix(sum ^ bits);
    }
    return sum;
}

std::string share_text(const Checkpoint& checkpoint) {
    const PictureShard& shard = checkpoint.state.shard;
    const Region& r = shard.region;
    return message(r.left, ' ', r.top, ' ', r.right, ' ', r.bottom, ' ', shard.first_tile, ' ',
                   shard.tile_step, ' ', shard.first_sample, ' ', checkpoint.samples, ' ',
                   checkpoint.all_samples);
}

/// Maximum number of samples in one pixel; the sums would overflow with more.
constexpr std::uint32_t max_in_pixel = std::uint32_t{1} << 31;

/// Whether the sums of all pixels can result from their numbers of samples.
bool are_possible(const Film& film) {
    constexpr std::uint64_t white = std::uint64_t{1} << 20;
    return std::ranges::all_of(film.pixels(), [](const PixelSum& pixel) {
        const std::uint64_t n = pixel.samples;
        const auto within = [&](std::size_t c) {
            return pixel.display[c] <= n * white && pixel.display_squared[c] <= n * white * white &&
                   pixel.display_squared[c] <= white * pixel.display[c];
        };
        // Beyond 2^24 samples the sums of squares may wrap around at 2^64.
        const bool shown = n >= std::uint64_t{1} << 24 || (within(0) && within(1) && within(2));
        return shown && pixel.negative <= n && n <= max_in_pixel && pixel.planned <= max_in_pixel;
    });
}

/// Reads the text attributes. Returns false if they are not those of a state.
bool read_texts(const LayeredPicture& picture, Checkpoint& checkpoint, std::uint64_t& sum) {
    checkpoint.identity = identity_from(picture.texts[0].second);
    PictureShard& shard = checkpoint.state.shard;
    Region& r = shard.region;
    shard.width = picture.width;
    std::istringstream first(picture.texts[1].second), second(picture.texts[2].second);
    first >> r.left >> r.top >> r.right >> r.bottom >> shard.first_tile >> shard.tile_step >>
        shard.first_sample >> checkpoint.samples >> checkpoint.all_samples;
    second >> checkpoint.state.rounds >> checkpoint.finished >> sum;
    const bool tiles = shard.first_tile >= 0 && shard.first_tile < shard.tile_step &&
                       shard.tile_step <= max_shards;
    const bool samples = checkpoint.samples <= checkpoint.all_samples &&
                         shard.first_sample <= checkpoint.all_samples - checkpoint.samples;
    const bool region = r.left >= 0 && r.top >= 0 && r.left <= r.right && r.top <= r.bottom &&
                        r.right <= picture.width && r.bottom <= picture.height;
    const bool counts =
        checkpoint.all_samples <= max_in_pixel && checkpoint.state.rounds <= max_in_pixel;
    return first && second && !checkpoint.identity.empty() && tiles && samples && region && counts;
}

/// Behind the picture of a state stand the bytes of the light of lamps, their digest, their number
/// (the lowest byte first) and these letters.
constexpr std::string_view lamps_mark = "CANDLAMP";
constexpr std::size_t digest_bytes = 64, number_bytes = 8;

void append_lamps(std::string& bytes, const std::string& lamps) {
    if (lamps.empty()) return;
    bytes += lamps;
    bytes += sha256(lamps);
    for (std::size_t i = 0; i < number_bytes; ++i)
        bytes += static_cast<char>(std::uint64_t{lamps.size()} >> (8 * i) & 0xFFU);
    bytes += lamps_mark;
}

/// Takes the light of lamps from the end of the bytes, if it is there. Returns false if it is
/// damaged.
bool take_lamps(std::string_view& bytes, std::string& lamps) {
    if (!bytes.ends_with(lamps_mark)) return true;
    constexpr std::size_t end = digest_bytes + number_bytes + lamps_mark.size();
    if (bytes.size() < end) return false;
    std::uint64_t size = 0;
    for (std::size_t i = 0; i < number_bytes; ++i)
        size |= std::uint64_t{static_cast<unsigned char>(
                    bytes[bytes.size() - lamps_mark.size() - number_bytes + i])}
                << (8 * i);
    if (size > bytes.size() - end) return false;
    const std::size_t first = bytes.size() - end - static_cast<std::size_t>(size);
    lamps = bytes.substr(first, static_cast<std::size_t>(size));
    const bool whole = sha256(lamps) == bytes.substr(first + lamps.size(), digest_bytes);
    bytes = bytes.substr(0, first);
    return whole;
}

}  // namespace

std::uint64_t bytes_to_encode(int width, int height, std::size_t aovs) {
    // Planes, the same pixel by pixel, and the bytes of the file.
    constexpr std::uint64_t copies = 3;
    const std::uint64_t planes = channels.size() + parts(aovs, true).size();
    return copies * planes * sizeof(std::uint32_t) * static_cast<std::uint64_t>(width) *
           static_cast<std::uint64_t>(height);
}

std::optional<std::string> encode(const Checkpoint& checkpoint, Diagnostics& diagnostics) {
    const Film& film = checkpoint.state.film;
    LayeredPicture picture{film.width(), film.height(), {}, {}};
    for (int c = 0; c < 3; ++c) {
        ChannelPlane plane{channels[static_cast<std::size_t>(c)], false, {}};
        for (const PixelSum& pixel : film.pixels())
            plane.bits.push_back(std::bit_cast<std::uint32_t>(finite_float(pixel.mean()[c])));
        picture.planes.push_back(std::move(plane));
    }
    for (const StatePart& part : parts(film.aovs(), has_negative(film))) {
        ChannelPlane plane{part.name, true, {}};
        plane.bits.reserve(film.pixels().size());
        for (std::size_t i = 0; i < film.pixels().size(); ++i)
            plane.bits.push_back(part.get(film, i));
        picture.planes.push_back(std::move(plane));
    }
    picture.texts = {
        {std::string(texts[0]), to_text(checkpoint.identity)},
        {std::string(texts[1]), share_text(checkpoint)},
        {std::string(texts[2]), message(checkpoint.state.rounds, ' ', checkpoint.finished ? 1 : 0,
                                        ' ', *checksum(picture))}};
    auto bytes = encode(picture, diagnostics);
    if (bytes) append_lamps(*bytes, checkpoint.lamps);
    return bytes;
}

std::optional<Checkpoint> read_checkpoint(const std::string& path, Diagnostics& diagnostics) {
    const auto bytes = bytes_of_layers(path, diagnostics);
    if (!bytes) return std::nullopt;
    Checkpoint checkpoint;
    std::string_view before_lamps = *bytes;
    const bool has_whole_lamps = take_lamps(before_lamps, checkpoint.lamps);
    const auto picture = read_layers(before_lamps, path, texts, diagnostics);
    if (!picture) return std::nullopt;
    const auto fail = [&](std::string_view why) {
        diagnostics.add(error(Fault::io, {}, message("`", printable(path), "` ", why)));
        return std::nullopt;
    };
    if (!has_whole_lamps) return fail("is damaged: the light of its lamps is not what it was");
    std::uint64_t sum = 0;
    if (!read_texts(*picture, checkpoint, sum)) return fail("is no state of a picture");
    if (checksum(*picture) != sum) return fail("is damaged: its sums are not those that it had");
    Film& film = checkpoint.state.film;
    film = Film(picture->width, picture->height, extras_in(*picture));
    for (const StatePart& part : parts(film.aovs(), has_negative(*picture))) {
        const auto plane = std::ranges::find(picture->planes, part.name, &ChannelPlane::name);
        for (std::size_t i = 0; i < plane->bits.size(); ++i) part.set(film, i, plane->bits[i]);
    }
    if (!are_possible(film)) return fail("is damaged: no samples add up to its sums");
    return checkpoint;
}

}  // namespace candelabra
