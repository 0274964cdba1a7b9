// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/emitters.h"

#include "luminaire/composite.h"
#include "shape/area.h"

#include <algorithm>

namespace {

/// So many luminaires without a formula may take some time and memory.
constexpr int most_guides = 64;

class Emitters {
public:
    explicit Emitters(const World& world) : world_(world) {}

    Emitter of(const GlowingPrimitive& glow) {
        switch (glow.kind) {
            case PrimitiveKind::sphere: {
                const SpherePrimitive& s = world_.spheres[glow.index];
                return SphereEmitter{s.centre, s.radius};
            }
            case PrimitiveKind::triangle: {
                const TrianglePrimitive& t = world_.triangles[glow.index];
                return TriangleEmitter{t.corner1, t.corner2, t.corner3};
            }
            case PrimitiveKind::leaf: {
                const PlacedComposite& placed = world_.composites[world_.composite_of[glow.index]];
                const PrimitiveIndex leaf = world_.leaves_begin() + glow.index;
                return composite_emitter(placed.composite, leaf - placed.first_leaf, may_guide());
            }
            case PrimitiveKind::shape:
                break;
        }
        const PlacedShape& placed = world_.shapes[glow.index];
        if (surface_area(placed.shape) > 0) return AreaEmitter{placed.shape, placed.transform};
        CompositeBuilder builder;
        const PartRef alone = builder.add({placed.shape, placed.transform});
        return composite_emitter(make_handle<Composite>(builder.finish(alone)), alone.index,
                                 may_guide());
    }

private:
    bool may_guide() { return guides_left_ > 0 && guides_left_-- > 0; }

    const World& world_;
    int guides_left_ = most_guides;
};

void set_radiance(const World& world, Luminaire& luminaire) {
    const Material& look = world.material(luminaire.primitive);
    luminaire.radiance = greatest_emission(*look.texture);
    luminaire.varying = varied(*look.texture);
    const auto include = [&](const Handle<Texture>& other) {
        luminaire.radiance = glm::max(luminaire.radiance, greatest_emission(*other));
        luminaire.varying = true;
    };
    if (look.texture2) include(look.texture2), include(look.texture3);
    const auto parts = world.part_textures.find(luminaire.primitive);
    if (parts != world.part_textures.end()) std::ranges::for_each(parts->second, include);
}

}  // namespace

void add_luminaires(World& world, std::span<const GlowingPrimitive> glowing,
                    Diagnostics& diagnostics) {
    Emitters emitters(world);
    for (const GlowingPrimitive& glow : glowing) {
        Luminaire luminaire;
        luminaire.emitter = emitters.of(glow);
        luminaire.primitive = primitive(world, glow.kind, glow.index);
        set_radiance(world, luminaire);
        if (emitting_area(luminaire.emitter) > 0) {
            world.luminaires.push_back(std::move(luminaire));
            world.statement_of_luminaire.push_back(glow.statement);
        } else
            diagnostics.add(
                warning(Fault::degenerate, glow.span,
                        "this luminaire has no area, so it gives no light")
                    .with_help(
                        "give it three corners that do not lie on one line, or leave it out"));
    }
}
