// SPDX-License-Identifier: GPL-3.0-or-later
#include "preview/inspect.h"

#include "base/parallel.h"
#include "film/film.h"
#include "output/light_report.h"
#include "render/pilot.h"
#include "scene/dump_function.h"
#include "scene/dump_texture.h"
#include "text/message.h"
#include "transport/integrator.h"
#include "transport/primary_hit.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace candelabra {

namespace {

/// Returns an image with reduced rows and columns.
Image blank(const RenderedPicture& shown, int step) {
    return Image((shown.film.width() + step - 1) / step, (shown.film.height() + step - 1) / step);
}

/// Returns the primary hit at the centre of each pixel.
std::vector<PrimaryHit> sights(const RenderedPicture& shown, int width, int height,
                               const std::function<bool()>& cancelled) {
    std::vector<PrimaryHit> all(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    run_parallel(static_cast<std::size_t>(height), shown.settings.threads, [&](std::size_t row) {
        if (cancelled && cancelled()) return;
        const int y = static_cast<int>(row);
        for (int x = 0; x < width; ++x)
            all[row * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] =
                primary_hit(*shown.shot.world, middle_ray(shown.shot, {x, y, width, height}));
    });
    return all;
}

/// Returns a colour that distinguishes a number from its neighbours.
Rgb colour_of(std::uint32_t number) {
    if (number == 0) return Rgb(0);
    const std::uint64_t bits = mix(number);
    const auto channel = [&](int shift) {
        return 0.1 + 0.9 * static_cast<double>(bits >> shift & 0xff) / 255;
    };
    return {channel(0), channel(8), channel(16)};
}

/// The resolution of a layer, and whether it is still wanted.
struct Detail {
    int step;
    const std::function<bool()>& cancelled;
};

template <class Colour>
Image of_sights(const RenderedPicture& shown, const Detail& detail, const Colour& colour) {
    Image image = blank(shown, detail.step);
    const std::vector<PrimaryHit> seen = sights(shown, image.width, image.height, detail.cancelled);
    for (std::size_t i = 0; i < seen.size(); ++i)
        if (seen[i].met) image.pixels[i] = colour(seen[i]);
    return image;
}

Image depths(const RenderedPicture& shown, const Detail& detail) {
    Image image = blank(shown, detail.step);
    const std::vector<PrimaryHit> seen = sights(shown, image.width, image.height, detail.cancelled);
    double nearest = std::numeric_limits<double>::infinity();
    for (const PrimaryHit& each : seen)
        if (each.met) nearest = std::min(nearest, each.distance);
    for (std::size_t i = 0; i < seen.size(); ++i)
        if (seen[i].met) image.pixels[i] = Rgb(nearest / seen[i].distance);
    return image;
}

template <class Value>
Image of_film(const RenderedPicture& shown, const Detail& detail, const Value& value) {
    const int step = detail.step;
    Image image = blank(shown, step);
    double most = 0;
    for (const PixelSum& pixel : shown.film.pixels()) most = std::max(most, value(pixel));
    for (int y = 0; y < image.height && most > 0; ++y)
        for (int x = 0; x < image.width; ++x)
            image.at(x, y) = Rgb(value(shown.film.at(x * step, y * step)) / most);
    return image;
}

struct NamedView {
    std::string_view name;
    bool still;
    Image (*made)(const RenderedPicture&, const Detail&);
};
constexpr auto all_views = std::to_array<NamedView>({
    {"albedo", true,
     [](const RenderedPicture& shown, const Detail& detail) {
         return of_sights(shown, detail, [](const PrimaryHit& seen) { return seen.albedo; });
     }},
    {"normal", true,
     [](const RenderedPicture& shown, const Detail& detail) {
         return of_sights(shown, detail,
                          [](const PrimaryHit& seen) { return rgb_of(0.5 * (seen.normal + 1.0)); });
     }},
    {"depth", true, depths},
    {"object", true,
     [](const RenderedPicture& shown, const Detail& detail) {
         return of_sights(shown, detail,
                          [](const PrimaryHit& seen) { return colour_of(seen.object); });
     }},
    {"variance", false,
     [](const RenderedPicture& shown, const Detail& detail) {
         return of_film(shown, detail,
                        [](const PixelSum& pixel) { return pixel.variance_of_mean(); });
     }},
    {"samples", false,
     [](const RenderedPicture& shown, const Detail& detail) {
         return of_film(shown, detail, [](const PixelSum& pixel) { return double(pixel.samples); });
     }},
    {"shadow_rays", false,
     [](const RenderedPicture& shown, const Detail& detail) {
         return of_film(shown, detail,
                        [](const PixelSum& pixel) { return double(pixel.shadow_rays); });
     }},
});

std::string vector_text(const Vec3& v) {
    const auto number = [](double value) { return static_cast<float>(value); };
    return message("<", number(v.x), ", ", number(v.y), ", ", number(v.z), ">");
}

/// Estimates the share of each statement in the light that reaches the pixel, from many samples.
std::string lights_of(const RenderedPicture& shown, const PicturePoint& at) {
    const World& world = *shown.shot.world;
    // With photons, many samples are expensive.
    const std::uint32_t tries = world.photon_targets.empty() ? 256 : 16;
    Integrator integrator(shown.shot, {pilot(shown.shot, shown.settings).shadow_rays, true});
    Key key;
    key.pixel = mix(static_cast<std::uint64_t>(shown.settings.seed)) + shown.film.index(at.x, at.y);
    double all = 0;
    std::vector<double> share(world.provenance.light_statements.size());
    for (key.sample = 0; key.sample < tries; ++key.sample) {
        const Vec2 place{uniform(key, Purpose::pixel_x), uniform(key, Purpose::pixel_y)};
        all += grey(integrator.radiance(ray_through(shown.shot, at, place, key), key));
        take_lights(integrator.ledger(), [&](std::size_t statement, const Rgb& light) {
            share[statement] += grey(light);
        });
    }
    std::vector<std::size_t> order(share.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater(), [&](std::size_t i) { return share[i]; });
    std::string text;
    constexpr double least = 0.0005;
    const auto line = [&](double light, const std::string& what) {
        if (all > 0 && light / all >= least)
            text += message("  ", std::round(1000 * light / all) / 10, " %  ", what, "\n");
    };
    for (const std::size_t i : order)
        line(share[i], statement_text(world.provenance.light_statements[i], shown.sources));
    line(all - std::accumulate(share.begin(), share.end(), 0.0), "sky, ambient light and fog");
    return text.empty() ? "" : message("light:\n", text);
}

}  // namespace

std::vector<std::string_view> views() {
    std::vector<std::string_view> names;
    for (const NamedView& each : all_views) names.push_back(each.name);
    return names;
}

bool is_still(std::string_view name) {
    const auto found = std::ranges::find(all_views, name, &NamedView::name);
    return found != all_views.end() && found->still;
}

std::optional<Image> view(const RenderedPicture& shown, std::string_view name, int step,
                          const std::function<bool()>& cancelled) {
    const auto found = std::ranges::find(all_views, name, &NamedView::name);
    if (found == all_views.end()) return std::nullopt;
    return found->made(shown, {step, cancelled});
}

std::string what_is_under(const RenderedPicture& shown, int x, int y) {
    const Film& film = shown.film;
    if (x < 0 || y < 0 || x >= film.width() || y >= film.height()) return {};
    const PicturePoint at{x, y, film.width(), film.height()};
    std::string text =
        message("<", x, ", ", y, ">: rgb ", vector_text(vec3_of(film.at(x, y).mean())), "\n");
    const World& world = *shown.shot.world;
    const PrimaryHit seen = primary_hit(world, middle_ray(shown.shot, at));
    if (seen.object > 0)
        text += message(
            "object ", seen.object, ": ",
            statement_text(world.provenance.object_spans[seen.object - 1], shown.sources), "\n");
    if (seen.met)
        text +=
            message("at ", vector_text(seen.hit.position), ", normal ", vector_text(seen.normal),
                    ", distance ", static_cast<float>(seen.distance), "\n");
    if (const Texture* texture = texture_at(world, seen))
        text += FunctionWriter().replaced(dump(*texture)) + "\n";
    return text + lights_of(shown, at);
}

}  // namespace candelabra
