// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/cosine_direction.h"
#include "proof/laws.h"
#include "transport/integrator.h"
#include "world/world.h"

#include <algorithm>
#include <string>

namespace candelabra::proof {

namespace {

/// A place on the stage, and its upward normal.
const Vec3 place(0.9, 0.55, -1.1);
const std::string patch =
    "disc { <0.9, 0.55, -1.1>, y, 0.001 pigment { rgb 1 } finish { diffuse 1 } }";

/// Pixels of which each is a mean of samples along rays of its own.
template <class RayOf>
Image followed(const Prepared& scene, int samples, int seed, const Deadline& end,
               const RayOf& ray_of) {
    const RenderSettings settings = scene.settings(samples, seed);
    Tracing tracing;
    tracing.sent = SentLight::of(scene.shot(), seed, 1);
    Integrator integrator(scene.shot(), tracing);
    Image image(settings.width, settings.height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        if (end.over()) return {};
        for (int sample = 0; sample < samples; ++sample) {
            Key key;
            key.pixel = mix(static_cast<std::uint64_t>(seed)) + i;
            key.sample = static_cast<std::uint32_t>(sample);
            integrator.prepare(key.sample);
            image.pixels[i] += integrator.radiance(ray_of(key), key) / double(samples);
        }
    }
    return image;
}

/// What comes to the place, as a diffuse surface weighs it.
Image received(const Prepared& scene, int samples, int seed, const Deadline& end) {
    return followed(scene, samples, seed, end, [](const Key& key) {
        const Vec2 drawn(uniform(key, Purpose::pixel_x), uniform(key, Purpose::pixel_y));
        return Ray{place, cosine_direction(Vec3(0, 1, 0), drawn)};
    });
}

/// What the patch at the place shows.
Image shown(const Prepared& scene, int samples, int seed, const Deadline& end) {
    return followed(scene, samples, seed, end, [](const Key&) {
        return Ray{place + Vec3(0, 0.01, 0), Vec3(0, -1, 0)};
    });
}

/// The element without `inverse` where media fill it: as in POV-Ray, a camera in an inverse solid
/// notices it within an upright box only.
Element with_noticed_media(Element element) {
    const bool filled = std::ranges::any_of(element.inner, [](const Element& each) {
        return each.head == "interior" && mentions(each, "media");
    });
    if (filled) element = replaced(std::move(element), R"(\binverse\b)", "");
    for (Element& each : element.inner) each = with_noticed_media(std::move(each));
    return element;
}

}  // namespace

Claims receiving(const Script& drawn, Dice& dice) {
    Script script = drawn;
    for (Element& each : script.elements)
        each = with_closed_sets(with_noticed_media(std::move(each)));
    const bool bounces = dice.chance(0.5);
    const auto paths = [](const char* count) {
        return std::string("path_traced reflected_luminaires 0 bounces ") + count;
    };
    const Script seen = with_setting(script, "integrator", paths(bounces ? "1" : "0"));
    Script lit = with_setting(script, "integrator", paths(bounces ? "2" : "1"));
    lit.elements.push_back(words(patch));
    std::vector<Term> left = picture(lit), right = picture(seen);
    left.front().view = shown;
    right.front().view = received;
    return {same_mean("patch = camera in its place", left, right, 1e-2)};
}

}  // namespace candelabra::proof
