// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/checkpoint.h"

#include "base/random.h"
#include "picture/layers.h"
#include "text/harmless.h"
#include "text/message.h"

#include <algorithm>
#include <array>
#include <bit>
#include <functional>
#include <sstream>

namespace {

constexpr auto texts =
    std::to_array<std::string_view>({"candelabraIdentity", "candelabraShare", "candelabraState"});
constexpr auto channels = std::array{"R", "G", "B"};

/// One plane that holds 32 bits of each pixel's sums.
struct Part {
    std::string name;
    std::function<std::uint32_t(const PixelSum&)> get;
    std::function<void(PixelSum&, std::uint32_t)> set;
};

using Counts = std::array<std::uint64_t, 3>;

Part half_of(Counts PixelSum::*sums, std::size_t channel, int half, std::string name) {
    const int shift = 32 * half;
    return {
        std::move(name),
        [=](const PixelSum& p) { return static_cast<std::uint32_t>((p.*sums)[channel] >> shift); },
        [=](PixelSum& p, std::uint32_t bits) {
            (p.*sums)[channel] |= std::uint64_t{bits} << shift;
        }};
}

std::vector<Part> parts() {
    std::vector<Part> all;
    all.push_back({"samples", [](const PixelSum& p) { return p.samples; },
                   [](PixelSum& p, std::uint32_t bits) { p.samples = bits; }});
    all.push_back({"target", [](const PixelSum& p) { return p.target; },
                   [](PixelSum& p, std::uint32_t bits) { p.target = bits; }});
    all.push_back({"shadow_rays", [](const PixelSum& p) { return p.shadow_rays; },
                   [](PixelSum& p, std::uint32_t bits) { p.shadow_rays = bits; }});
    for (std::size_t c = 0; c < channels.size(); ++c) {
        for (int i = 0; i < 4; ++i)
            all.push_back(
                {message("sum.", channels[c], i),
                 [=](const PixelSum& p) { return p.radiance[c].word(i); },
                 [=](PixelSum& p, std::uint32_t bits) { p.radiance[c].set_word(i, bits); }});
        for (int i = 0; i < 2; ++i) {
            all.push_back(half_of(&PixelSum::display, c, i, message("shown.", channels[c], i)));
            all.push_back(
                half_of(&PixelSum::display_squared, c, i, message("squares.", channels[c], i)));
        }
    }
    return all;
}

/// Of the planes that count, in their order; nothing when one is missing.
std::optional<std::uint64_t> checksum(const LayeredPicture& picture) {
    std::uint64_t sum = mix(static_cast<std::uint64_t>(picture.width));
    for (const Part& part : parts()) {
        const auto plane = std::ranges::find(picture.planes, part.name, &Plane::name);
        if (plane == picture.planes.end()) return std::nullopt;
        for (const std::uint32_t bits : plane->bits) sum = mix(sum ^ bits);
    }
    return sum;
}

std::string share_text(const Checkpoint& checkpoint) {
    const Share& share = checkpoint.state.share;
    const Region& r = share.region;
    return message(r.left, ' ', r.top, ' ', r.right, ' ', r.bottom, ' ', share.first_tile, ' ',
                   share.tile_step, ' ', share.first_sample, ' ', checkpoint.samples, ' ',
                   checkpoint.all_samples);
}

/// False when the texts are not those of a state.
bool read_texts(const LayeredPicture& picture, Checkpoint& checkpoint, std::uint64_t& sum) {
    checkpoint.identity = identity_from(picture.texts[0].second);
    Share& share = checkpoint.state.share;
    Region& r = share.region;
    share.width = picture.width;
    std::istringstream first(picture.texts[1].second), second(picture.texts[2].second);
    first >> r.left >> r.top >> r.right >> r.bottom >> share.first_tile >> share.tile_step >>
        share.first_sample >> checkpoint.samples >> checkpoint.all_samples;
    second >> checkpoint.state.rounds >> checkpoint.finished >> sum;
    const bool tiles = share.first_tile >= 0 && share.first_tile < share.tile_step &&
                       share.tile_step <= most_shards;
    const bool samples = checkpoint.samples <= checkpoint.all_samples &&
                         share.first_sample <= checkpoint.all_samples - checkpoint.samples;
    return first && second && !checkpoint.identity.empty() && tiles && samples;
}

}  // namespace

std::optional<std::string> encode(const Checkpoint& checkpoint, Diagnostics& diagnostics) {
    const Film& film = checkpoint.state.film;
    LayeredPicture picture{film.width(), film.height(), {}, {}};
    for (int c = 0; c < 3; ++c) {
        Plane plane{channels[static_cast<std::size_t>(c)], false, {}};
        for (const PixelSum& pixel : film.pixels())
            plane.bits.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(pixel.mean()[c])));
        picture.planes.push_back(std::move(plane));
    }
    for (const Part& part : parts()) {
        Plane plane{part.name, true, {}};
        plane.bits.reserve(film.pixels().size());
        for (const PixelSum& pixel : film.pixels()) plane.bits.push_back(part.get(pixel));
        picture.planes.push_back(std::move(plane));
    }
    picture.texts = {
        {std::string(texts[0]), to_text(checkpoint.identity)},
        {std::string(texts[1]), share_text(checkpoint)},
        {std::string(texts[2]), message(checkpoint.state.rounds, ' ', checkpoint.finished ? 1 : 0,
                                        ' ', *checksum(picture))}};
    return encode(picture, diagnostics);
}

std::optional<Checkpoint> read_checkpoint(const std::string& path, Diagnostics& diagnostics) {
    const auto picture = read_layers(path, texts, diagnostics);
    if (!picture) return std::nullopt;
    const auto fail = [&](std::string_view why) {
        diagnostics.add(error(Fault::io, {}, message("`", harmless(path), "` ", why)));
        return std::nullopt;
    };
    Checkpoint checkpoint;
    std::uint64_t sum = 0;
    if (!read_texts(*picture, checkpoint, sum)) return fail("is no state of a picture");
    if (checksum(*picture) != sum) return fail("is damaged: its sums are not those that it had");
    checkpoint.state.film = Film(picture->width, picture->height);
    std::vector<PixelSum>& pixels = checkpoint.state.film.pixels();
    for (const Part& part : parts()) {
        const auto plane = std::ranges::find(picture->planes, part.name, &Plane::name);
        for (std::size_t i = 0; i < pixels.size(); ++i) part.set(pixels[i], plane->bits[i]);
    }
    return checkpoint;
}
