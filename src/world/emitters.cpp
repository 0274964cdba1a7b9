// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/emitters.h"

#include "luminaire/brightness.h"
#include "luminaire/composite.h"
#include "luminaire/placed.h"
#include "shape/area.h"
#include "surface/any_finish.h"
#include "world/prototype.h"
#include "world/radiance.h"

#include <algorithm>
#include <optional>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <variant>

namespace candelabra {

namespace {

/// Maximum number of luminaires with a proxy mesh, which takes some time and memory.
constexpr int max_proxies = 64;

bool receives_light(const Finish& f) {
    return f.diffuse != 0 || f.diffuse_back != 0 || f.phong != 0 || f.specular != 0 ||
           f.microfacet.on || f.subsurface.translucency != Rgb(0);
}

bool receives_light(const std::vector<Media>& all) {
    return std::ranges::any_of(
        all, [](const Media& media) { return media.scattering.colour != Rgb(0); });
}

bool receives_light(const Material& material) {
    const auto lit = [](const Finish& finish) { return receives_light(finish); };
    return any_finish(*material.texture, lit) ||
           (material.inner && any_finish(*material.inner, lit)) ||
           (material.interior && receives_light(material.interior->media));
}

/// A polygon that is a rectangle in the world.
std::optional<RectangleEmitter> placed_rectangle(const PlacedShape& placed) {
    const auto* polygon = std::get_if<Shared<BuiltPolygon>>(&placed.shape);
    if (!polygon || !(*polygon)->rectangle) return {};
    const auto& [corner, side1, side2] = *(*polygon)->rectangle;
    if (!placed.transform) return RectangleEmitter{corner, side1, side2};
    const Transform& there = *placed.transform;
    const RectangleEmitter found{there.point(corner), there.direction(side1),
                                 there.direction(side2)};
    return at_right_angles(found.side1, found.side2) ? std::optional(found) : std::nullopt;
}

SealedSide sealed_by(Closure mesh) {
    if (mesh == Closure::outwards) return SealedSide::inner;
    return mesh == Closure::inwards ? SealedSide::outer : SealedSide::none;
}

class Emitters {
public:
    Emitters(const World& world, bool with_proxy)
        : world_(world), renders_(with_proxy), proxies_left_(with_proxy ? max_proxies : 0) {}

    /// Cylinders and cones with uneven emission get a proxy mesh to their bright parts instead of
    /// their formula. `face_of`: of the mesh of a triangle.
    Emitter of(const Luminaire& look, Closure face_of) {
        const Emitter plain = by_shape(look, face_of);
        if (!look.varying || proxies_left_ == 0 || !std::holds_alternative<AreaEmitter>(plain) ||
            face_count(plain) > 0)
            return plain;
        CompositeEmitter bright = alone(*world_.geometry.shape(look.primitive), look);
        return bright.proxy && bright.unevenness > Brightness::uneven ? Emitter(std::move(bright))
                                                                      : plain;
    }

private:
    Emitter by_shape(const Luminaire& look, Closure face_of) {
        // Through the near side of what is clear its far side is seen, which formulas leave out.
        const bool clear = world_.material(look.primitive).transparent;
        return world_.geometry.visit_primitive(
            look.primitive,
            [&](const SpherePrimitive& s) -> Emitter {
                if (clear) return alone({Sphere{s.centre, s.radius}, nullptr, {}}, look);
                return SphereEmitter{s.centre, s.radius};
            },
            [&](const TrianglePrimitive& t) -> Emitter {
                return TriangleEmitter{t.corner1, t.corner2, t.corner3, sealed_by(face_of)};
            },
            [&](const PlacedShape& placed) -> Emitter {
                const bool hides = visit_shape(
                    []<class S>(const S&) {
                        return std::is_same_v<S, Sphere> || std::is_same_v<S, Cuboid> ||
                               std::is_same_v<S, Cylinder> || std::is_same_v<S, Cone>;
                    },
                    placed.shape);
                if (const auto rectangle = placed_rectangle(placed)) return *rectangle;
                if (surface_area(placed.shape) > 0 && !(clear && hides))
                    return AreaEmitter{placed.shape, placed.transform, sealed_side(placed.shape)};
                return alone(placed, look);
            },
            [&](const PlacedComposite& placed, std::uint32_t leaf) -> Emitter {
                return composite(placed.composite, leaf, look);
            });
    }

    SealedSide sealed_side(const BuiltShape& shape) {
        const auto* mesh = std::get_if<Shared<BuiltMesh>>(&shape);
        if (!mesh) return SealedSide::none;
        const auto [found, added] = closures_.try_emplace(shared_content(shape));
        if (added) found->second = closure(*(*mesh)->mesh);
        return sealed_by(found->second);
    }

    Handle<Composite> of_one(const BuiltShape& shape, const Handle<Transform>& transform) {
        CompositeBuilder builder(world_.rules.settings.index);
        const PartRef part = builder.add({shape, transform});
        return make_handle<Composite>(builder.finish(part));
    }

    /// Copies of one shape share their proxy mesh, and all of them together count as one that has
    /// one.
    CompositeEmitter alone(const PlacedShape& placed, const Luminaire& look) {
        Handle<Composite> there = of_one(placed.shape, placed.transform);
        const void* content = shared_content(placed.shape);
        if (!renders_ || !content || look.varying || !placed.transform)
            return composite(there, 0, look);
        const auto [found, added] = originals_.try_emplace(content);
        if (added && proxies_left_ > 0) {
            --proxies_left_;
            found->second = composite_emitter(of_one(placed.shape, nullptr), 0);
        }
        return found->second ? placed_emitter(*found->second, there, placed.transform)
                             : composite_emitter(there, 0, false);
    }

    CompositeEmitter composite(Handle<Composite> whole, std::uint32_t leaf, const Luminaire& look) {
        if (!renders_) return unmeasured_emitter(std::move(whole), leaf);
        const bool with_proxy = proxies_left_ > 0;
        if (with_proxy) --proxies_left_;
        if (!with_proxy || !look.varying)
            return composite_emitter(std::move(whole), leaf, with_proxy);
        return bright_composite_emitter(std::move(whole), leaf, [&](const Vec3& point) {
            return luminance_at(world_, look.primitive, point);
        });
    }

    const World& world_;
    bool renders_;
    int proxies_left_;
    std::unordered_map<const void*, Closure> closures_;  ///< of meshes, by their content
    /// Shapes in their own space, by the address of the content that their copies share.
    std::unordered_map<const void*, std::optional<CompositeEmitter>> originals_;
};

void set_radiance(const World& world, Luminaire& luminaire) {
    const Material& look = world.material(luminaire.primitive);
    luminaire.radiance = greatest_emission(look);
    luminaire.varying = varied(*look.texture) || (look.inner && varied(*look.inner));
    luminaire.two_faced = static_cast<bool>(look.inner);
    luminaire.one_sided = look.inner && (greatest_emission(*look.texture) == Rgb(0) ||
                                         greatest_emission(*look.inner) == Rgb(0));
    luminaire.keeps_inner_light = !look.transparent && !look.inner;
    const auto include = [&](const Handle<Texture>& other) {
        luminaire.radiance = max(luminaire.radiance, greatest_emission(*other));
        luminaire.varying = true;
    };
    if (look.texture2) include(look.texture2), include(look.texture3);
    const auto parts = world.appearance.part_textures.find(luminaire.primitive);
    if (parts != world.appearance.part_textures.end())
        std::ranges::for_each(parts->second, include);
    // What is partly transparent emits by its opacity only.
    if (look.transparent && !luminaire.varying && !luminaire.two_faced)
        luminaire.radiance = emission(*look.texture, Vec3(0), world.pattern_scene(),
                                      [&](const Colour& colour) { return world.opacity(colour); });
    luminaire.radiance *= world.output(luminaire.primitive, nullptr);
    if (!world.appearance.output_of.empty())
        luminaire.web =
            world.appearance.outputs[world.appearance.output_of[luminaire.primitive]].web;
}

}  // namespace

void add_luminaires(World& world, std::span<const GlowingPrimitive> glowing, bool with_proxy,
                    Diagnostics& diagnostics) {
    Emitters emitters(world, with_proxy);
    auto& luminaires = world.lights.luminaires.own();
    luminaires.reserve(luminaires.size() + glowing.size());
    for (const GlowingPrimitive& glow : glowing) {
        Luminaire luminaire;
        luminaire.primitive = world.geometry.primitive(glow.kind, glow.index);
        set_radiance(world, luminaire);
        if (luminaire.radiance == Rgb(0)) continue;
        luminaire.emitter = emitters.of(luminaire, glow.closure);
        if (emitting_area(luminaire.emitter) > 0) {
            luminaires.push_back(std::move(luminaire));
            world.provenance.statement_of_luminaire.push_back(glow.statement);
        } else
            diagnostics.add(
                warning(Fault::degenerate, glow.span,
                        "this luminaire has no area, so it gives no light")
                    .with_help(
                        "give it three corners that do not lie on one line, or leave it out"));
    }
}

bool add_luminaires(World& world, Prototype& prototype, std::span<const GlowingPrimitive> glowing,
                    bool guided, Diagnostics& diagnostics) {
    std::vector<std::uint32_t> statements;
    const auto exchange = [&] {
        std::swap(world.geometry, prototype.geometry);
        std::swap(world.appearance.material_of, prototype.material_of);
        std::swap(world.lights.luminaires.own(), prototype.luminaires);
        std::swap(world.provenance.statement_of_luminaire, statements);
    };
    exchange();
    add_luminaires(world, glowing, guided, diagnostics);
    exchange();
    if (prototype.luminaires.empty()) return true;
    prototype.luminaire_of.assign(prototype.primitive_count(), no_primitive);
    for (LightIndex light = 0; light < prototype.luminaires.size(); ++light)
        prototype.luminaire_of[prototype.luminaires[light].primitive] = light;
    return std::ranges::all_of(prototype.luminaires, can_be_placed);
}

void place_luminaires(World& world, std::span<const std::uint32_t> statements) {
    for (std::size_t i = 0; i < world.geometry.instances.size(); ++i) {
        Instance& placed = world.geometry.instances[i];
        const Prototype& prototype = world.geometry.prototype_of(placed);
        const auto count = static_cast<std::uint32_t>(prototype.luminaires.size());
        if (count == 0) continue;
        placed.first_luminaire =
            world.lights.luminaires.add(placed.first, prototype, *placed.place);
        world.provenance.statement_of_placed.push_back(
            {placed.first_luminaire, count, statements[i]});
    }
}

bool receives_light(const World& world) {
    return receives_light(world.sky.media) ||
           std::ranges::any_of(world.appearance.materials,
                               [](const Material& m) { return receives_light(m); });
}

std::size_t glows_without_light(const World& world) {
    std::vector<bool> glows;
    for (const Material& material : world.appearance.materials)
        glows.push_back(greatest_emission(material) != Rgb(0));
    std::size_t count = 0;
    for (std::size_t i = 0; i < world.appearance.material_of.size(); ++i)
        if (world.luminaire_of(static_cast<PrimitiveIndex>(i)) == no_primitive)
            count += glows[world.appearance.material_of[i]] ? 1 : 0;
    return count;
}

}  // namespace candelabra
