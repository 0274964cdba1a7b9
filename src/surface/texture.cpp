// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/texture.h"

#include "base/elementary.h"
#include "surface/any_finish.h"
#include "surface/lambertian.h"
#include "surface/map_place.h"
#include "surface/normal_space.h"
#include "surface/texture_map.h"

#include <algorithm>
#include <array>

namespace candelabra {

namespace {

/// Calls use(share, texture) for the entries with a weight at a place; the shares add up to 1.
template <class Use>
void for_entries(const PatternedTexture& choice, const Vec3& place, const PatternScene& scene,
                 Use use) {
    if (std::holds_alternative<Average>(choice.use.pattern)) {
        double total = 0;
        for (const TextureStop& stop : choice.map) total += stop.value;
        for (const TextureStop& stop : choice.map)
            if (stop.value != 0) use(stop.value / total, *stop.texture);
        return;
    }
    const MapPlace at = place_in(choice.map, choice.use.value(place, scene));
    use(1 - at.share, *choice.map[at.below].texture);
    if (at.share != 0) use(at.share, *choice.map[at.above].texture);
}

Vec3 place_of(const PatternedTexture& choice, const Vec3& point, const PatternScene& scene) {
    return choice.use.place(choice.transform.inverse_point(choice.uv ? uv_place(scene) : point));
}

/// The spaces of the patterns around a texture, innermost first.
struct Around {
    NormalSpace space;
    const Around* next;
};

struct Visit {
    const PatternScene& scene;
    const Vec3& normal;  ///< outside all patterns
    UseLayers use;
    const Around* place;  ///< the outermost space, if it is that of a place; null: of a pattern
};

/// `normal` is in the space of the surrounding patterns. As in POV-Ray, a layer without bumps takes
/// the normal outside all patterns, and patterns that depend on the normal use the layer's normal.
Layer layer_at(const Texture& texture, const Vec3& point, const Vec3& normal, const Around* around,
               const Visit& to) {
    const PatternScene& scene = to.scene;
    const bool bumpy = texture.normal.pattern != nullptr;
    Layer layer;
    layer.finish = &texture.finish;
    layer.normal = bumpy ? bumped(texture.normal, normal, point, scene) : to.normal;
    if (bumpy && around && around == to.place) {
        layer.normal = unit(around->space.leave(layer.normal));
        around = nullptr;
    }
    PatternScene here = scene;
    SurfaceView view;
    if (scene.view) {
        view = *scene.view;
        view.normal = layer.normal;
        here.view = &view;
    }
    layer.colour = evaluate(texture.pigment, point, here);
    for (; bumpy && around; around = around->next)
        layer.normal = unit(around->space.leave(layer.normal));
    return layer;
}

void visit(const Texture& texture, const Vec3& point, const Vec3& normal, double weight,
           const Around* around, const Visit& to) {
    if (texture.choice) {
        const PatternedTexture& choice = *texture.choice;
        const Vec3 place = place_of(choice, point, to.scene);
        const Around inner{{choice.use.steps, choice.transform, choice.frame.get()}, around};
        const Vec3 turned = unit(inner.space.enter(normal));
        PatternScene scene = to.scene;
        SurfaceAxes axes;
        if (scene.axes) {
            axes = inner.space.enter(*scene.axes, choice.uv);
            scene.axes = &axes;
        }
        for_entries(choice, place, scene, [&](double share, const Texture& entry) {
            visit(entry, place, turned, weight * share, &inner,
                  {scene, to.normal, to.use, to.place});
        });
        return;
    }
    std::array<Layer, 4> few;
    std::vector<Layer> many;
    std::size_t count = 0;
    for (const Texture* layer = &texture; layer; layer = layer->below.get()) ++count;
    if (count > few.size()) many.resize(count);
    const std::span<Layer> layers = count > few.size() ? std::span(many) : std::span(few);
    std::size_t i = 0;
    for (const Texture* layer = &texture; layer; layer = layer->below.get())
        layers[i++] = layer_at(*layer, point, normal, around, to);
    to.use(weight, layers.first(count));
}

}  // namespace

PatternedTexture::PatternedTexture(PatternUse the_use, const Transform& outside, TextureMap the_map)
    : use(std::move(the_use)),
      transform(outside),
      map(std::move(the_map)),
      nesting(candelabra::nesting(use)) {
    for (const TextureStop& stop : map) nesting.add(candelabra::nesting(*stop.texture));
}

Nesting nesting(const Texture& texture) {
    Nesting all = texture.choice ? texture.choice->nesting : nesting(texture.pigment);
    all.uv |= texture.choice && texture.choice->uv;
    all.include(nesting(texture.normal));
    if (texture.below) all.include(nesting(*texture.below));
    return all;
}

namespace {

/// Transforms a bump, or the choice of textures, with its object.
template <class Part>
void move(Part& part, const Transform& transform) {
    if (!part.uv)
        part.transform = part.transform.then(transform);
    else if (part.frame)
        part.frame = make_handle<Transform>(part.frame->then(transform));
}

}  // namespace

Texture transformed(Texture texture, const Transform& transform) {
    if (!texture.pigment.uv) texture.pigment.transform = texture.pigment.transform.then(transform);
    move(texture.normal, transform);
    if (texture.choice) move(texture.choice.edit(), transform);
    if (texture.below) texture.below = make_handle<Texture>(transformed(*texture.below, transform));
    return texture;
}

bool moves_with_object(const Texture& texture) {
    const auto stays = [](const auto& part) { return part.uv && !part.frame; };
    return !(texture.normal.pattern && stays(texture.normal)) &&
           !(texture.choice && stays(*texture.choice)) &&
           (!texture.below || moves_with_object(*texture.below));
}

Texture uv_mapped(Texture texture) {
    texture.pigment.uv = texture.normal.uv = true;
    if (texture.choice) texture.choice.edit().uv = true;
    if (texture.below) texture.below = make_handle<Texture>(uv_mapped(*texture.below));
    return texture;
}

Texture uv_mapped_with_frame(Texture texture) {
    texture = uv_mapped(std::move(texture));
    const auto frame = make_handle<Transform>();
    if (texture.normal.pattern) texture.normal.frame = frame;
    if (texture.choice) texture.choice.edit().frame = frame;
    return texture;
}

namespace {

/// Upper bound of the radiance emitted by the finishes for which `counts` is true.
Rgb max_emitted(const Texture& texture, bool (*counts)(const Finish&)) {
    if (texture.choice) {
        Rgb greatest(0);
        for (const TextureStop& stop : texture.choice->map)
            greatest = max(greatest, max_emitted(*stop.texture, counts));
        return greatest;
    }
    Rgb sum(0);
    if (counts(texture.finish))
        sum = max(brightest(texture.pigment) * texture.finish.emission, Rgb(0));
    return texture.below ? sum + max_emitted(*texture.below, counts) : sum;
}

}  // namespace

Rgb greatest_emission(const Texture& texture) {
    return max_emitted(texture, [](const Finish&) { return true; });
}

Rgb lighting_emission(const Texture& texture) {
    return max_emitted(texture, [](const Finish& finish) { return !finish.no_luminaire; });
}

Handle<Texture> ambient_as_emission(const Handle<Texture>& texture, const Rgb& ambient_light) {
    Handle<Texture> result = texture;
    if (texture->choice) {
        TextureMap map = texture->choice->map;
        bool any = false;
        for (TextureStop& stop : map) {
            Handle<Texture> entry = ambient_as_emission(stop.texture, ambient_light);
            any |= entry.get() != stop.texture.get();
            stop.texture = std::move(entry);
        }
        if (any) result.edit().choice.edit().map = std::move(map);
    } else if (max_component(texture->finish.ambient) >= 1) {
        Finish& finish = result.edit().finish;
        finish.emission += finish.ambient * ambient_light;
        finish.ambient = Rgb(0);
    }
    if (!texture->below) return result;
    Handle<Texture> below = ambient_as_emission(texture->below, ambient_light);
    if (below.get() != texture->below.get()) result.edit().below = std::move(below);
    return result;
}

Handle<Texture> as_lamp(const Handle<Texture>& texture, const LampData& lamp, bool all) {
    Handle<Texture> result = texture;
    if (texture->choice) {
        TextureMap map = texture->choice->map;
        for (TextureStop& stop : map) stop.texture = as_lamp(stop.texture, lamp, all);
        result.edit().choice.edit().map = std::move(map);
    } else if (all || texture->finish.emission != Rgb(0)) {
        Finish& finish = result.edit().finish;
        finish.emission = lamp_emission(lamp, finish.emission);
    }
    if (texture->below) result.edit().below = as_lamp(texture->below, lamp, all);
    return result;
}

Handle<LampData> stated_lamp(const Texture& texture) {
    if (texture.choice)
        for (const TextureStop& stop : texture.choice->map)
            if (Handle<LampData> found = stated_lamp(*stop.texture)) return found;
    if (!texture.choice && texture.finish.lamp) return texture.finish.lamp;
    return texture.below ? stated_lamp(*texture.below) : nullptr;
}

bool varied(const Texture& texture) {
    return texture.choice || texture.below || texture.pigment.pattern;
}

bool transparent(const Texture& texture) {
    if (texture.choice)
        return std::ranges::any_of(texture.choice->map, [](const TextureStop& stop) {
            return transparent(*stop.texture);
        });
    return transparent(texture.pigment) && (!texture.below || transparent(*texture.below));
}

void for_layers(const Texture& texture, const Vec3& point, const Vec3& normal,
                const PatternScene& scene, UseLayers use, const Transform* place) {
    if (!place) return visit(texture, point, normal, 1, nullptr, {scene, normal, use, nullptr});
    const std::vector<WarpStep> none;
    const Around placed{{none, *place, nullptr}, nullptr};
    visit(texture, place->inverse_point(point), placed.space.enter(normal), 1, &placed,
          {scene, normal, use, &placed});
}

bool scatters(const Texture& texture) {
    return any_finish(texture, [](const Finish& finish) { return finish.microfacet.on; });
}

bool takes_from_behind(const Texture& texture) {
    return any_finish(texture, [](const Finish& f) {
        const Reflection& mirror = f.reflection;
        const bool reflects = mirror.least != Rgb(0) || mirror.greatest != Rgb(0);
        return (f.conserve_energy && reflects) || f.refraction != 1 || f.microfacet.on;
    });
}

bool has_other_light(const Texture& texture) {
    return any_finish(texture, [](const Finish& f) {
        const Reflection& mirror = f.reflection;
        return !is_even_on_each_side(f) || f.phong != 0 || f.specular != 0 || f.ambient != Rgb(0) ||
               mirror.least != Rgb(0) || mirror.greatest != Rgb(0) ||
               f.subsurface.translucency != Rgb(0) || (f.no_luminaire && f.emission != Rgb(0)) ||
               min(f.emission, Rgb(0)) != Rgb(0);
    });
}

bool shows_light_from_behind(const Texture& texture) {
    return any_finish(texture, [](const Finish& finish) { return finish.diffuse_back != 0; });
}

bool lets_light_in(const Texture& texture) {
    return any_finish(
        texture, [](const Finish& finish) { return finish.subsurface.translucency != Rgb(0); });
}

bool reflects_to_a_power(const Texture& texture) {
    return any_finish(texture,
                      [](const Finish& finish) { return finish.reflection.exponent != 1; });
}

Rgb passing(const Texture& texture, const Vec3& point, const PatternScene& scene) {
    if (texture.choice) {
        Rgb sum(0);
        const Vec3 place = place_of(*texture.choice, point, scene);
        for_entries(*texture.choice, place, scene, [&](double share, const Texture& entry) {
            sum += share * passing(entry, place, scene);
        });
        return sum;
    }
    const Rgb own = evaluate(texture.pigment, point, scene).passing();
    return texture.below ? own * passing(*texture.below, point, scene) : own;
}

Rgb passing(const Texture& texture, const Vec3& point, const PatternScene& scene,
            const FocusedLight& light, const Transform* place) {
    Rgb sum(0);
    for_layers(
        texture, point, light.normal, scene,
        [&](double weight, std::span<const Layer> layers) {
            Rgb left(weight);
            for (const Layer& layer : layers) {
                const double cosine = std::abs(dot(layer.normal, light.direction));
                left *= (1 + math::pow(cosine, light.power)) * layer.colour.passing();
            }
            sum += left;
        },
        place);
    return sum;
}

Rgb emission(const Texture& texture, const Vec3& point, const PatternScene& scene,
             FunctionRef<double(const Colour&)> opacity) {
    if (texture.choice) {
        Rgb sum(0);
        const Vec3 place = place_of(*texture.choice, point, scene);
        for_entries(*texture.choice, place, scene, [&](double share, const Texture& entry) {
            sum += share * emission(entry, place, scene, opacity);
        });
        return sum;
    }
    const Colour colour = evaluate(texture.pigment, point, scene);
    const Rgb own = colour.rgb * texture.finish.emission * opacity(colour);
    if (!texture.below) return own;
    return own + colour.passing() * emission(*texture.below, point, scene, opacity);
}

}  // namespace candelabra
