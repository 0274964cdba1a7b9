// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/stated_lamps.h"

#include "base/elementary.h"
#include "photometry/light_colour.h"
#include "shape/area.h"
#include "world/lit_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

namespace candelabra {

namespace {

/// What leaves a surface if its emission is not scaled.
struct Emitted {
    double area = 0;            ///< of all sides that shine
    double light = 0;           ///< integral of the luminance over that area
    FacetedBody body;           ///< in the space of the scene, if facets are asked for
};

bool varies(const Material& look) {
    return varied(*look.texture) || look.texture2 || (look.inner && varied(*look.inner));
}

void include(Emitted& sum, const LitSurface& surface, FunctionRef<double(const Vec3&, Side)> light,
             bool even, bool facets) {
    for (const Side side : {Side::outer, Side::inner}) {
        if (side == Side::inner && !surface.open) continue;
        sum.area += surface.area;
        const auto light_of = [&](const SurfacePiece& piece) {
            const bool outer = (side == Side::outer) != piece.turned;
            return light(piece.position, outer ? Side::outer : Side::inner);
        };
        if (even && !surface.pieces.empty())
            sum.light += surface.area * light_of(surface.pieces.front());
        else
            for (const SurfacePiece& piece : surface.pieces)
                sum.light += piece.area * light_of(piece);
        if (facets && surface.round) sum.body.round += surface.area;
        if (facets && !surface.round)
            for (const SurfacePiece& piece : surface.pieces)
                sum.body.facets.push_back(
                    {side == Side::outer ? piece.normal : -piece.normal, piece.area});
    }
}

/// The address of what copies of a shape share, and its scale; null if there is no such copy.
std::pair<const void*, double> shared_by_copies(const World& world, PrimitiveIndex primitive) {
    const PlacedShape* placed = world.geometry.shape(primitive);
    if (!placed || surface_area(placed->shape) > 0) return {nullptr, 1};
    const double scale = placed->transform ? placed->transform->uniform_scale() : 1;
    if (!(scale > 0)) return {nullptr, 1};
    return {shared_content(placed->shape), scale};
}

/// Numbers by which bodies in the frame of their web are found to be the same: sums over the
/// facets, which follow from their areas and normals, rounded.
using BodyKey = std::array<double, 8>;

BodyKey body_key(const FacetedBody& body) {
    double area = 0;
    Vec3 squares(0), products(0);
    for (const Facet& facet : body.facets) {
        const Vec3& n = facet.normal;
        area += facet.area;
        squares += facet.area * n * n + facet.area * n;
        products += facet.area * Vec3(n.y * n.z, n.z * n.x, n.x * n.y);
    }
    constexpr double rounding = 1e-9;
    const double most = std::fmax(area + body.round, 1e-300);
    // The size by its logarithm, the rest as shares of it.
    BodyKey key{std::round(math::log(most) / rounding), std::round(body.round / most / rounding)};
    std::size_t next = 2;
    for (const Vec3& v : {squares, products})
        for (int axis = 0; axis < 3; ++axis) key[next++] = std::round(v[axis] / most / rounding);
    return key;
}

/// Lamps with the same web and axes, of the same body, whose emission is scaled alike.
using WebKey = std::array<double, 8>;

WebKey web_key(const WebPlace& place, double scale) {
    WebKey key{};
    std::size_t next = 0;
    for (const Vec3& v : {place.aim, place.c0})
        for (int axis = 0; axis < 3; ++axis) key[next++] = v[axis];
    key[next++] = place.mirrored ? 1 : 0;
    key[next] = scale;
    return key;
}

/// Webs of lamps, of which what does not depend on the lamp's place is made once.
class BodyWebs {
public:
    const WebbedBody* body(const WebPlace& place, FacetedBody body) {
        const AimedWeb& web = aimed(place);
        body.facets = in_frame(web, std::move(body.facets));
        auto& known = bodies_[{place.web.get(), body_key(body)}];
        if (!known) known = make_handle<WebbedBody>(place.web, body);
        last_ = known;
        return known.get();
    }
    /// The web of the place with the body that was made last.
    Handle<BodyWeb> last() const { return make_handle<BodyWeb>(*place_, last_); }

private:
    const AimedWeb& aimed(const WebPlace& place) {
        const auto [known, fresh] = files_.try_emplace(place.web.get(), place);
        place_.emplace(known->second, place);
        return *place_;
    }

    std::map<const PhotometricWeb*, AimedWeb> files_;
    std::map<std::pair<const PhotometricWeb*, BodyKey>, Handle<WebbedBody>> bodies_;
    std::optional<AimedWeb> place_;
    Handle<WebbedBody> last_;
};

/// Measures surfaces. Copies of one shape that glow evenly are measured once.
class Measuring {
public:
    explicit Measuring(const World& world) : world_(world) {}

    void add(Emitted& sum, PrimitiveIndex primitive, bool sealed, bool facets) {
        const Material& look = world_.material(primitive);
        const bool parts = world_.appearance.part_textures.contains(primitive);
        const bool even = !varies(look) && !parts;
        const auto light = [&](const Vec3& point, Side side) {
            return std::fmax(light_luminance(world_.emission(primitive, point, side)), 0);
        };
        const auto [content, scale] = shared_by_copies(world_, primitive);
        if (facets || !even || !content)
            return include(sum, lit_surface(world_, primitive, {!even, facets, sealed}), light,
                           even, facets);
        const auto [found, added] = known_.try_emplace(content);
        if (added) {
            LitSurface fresh = lit_surface(world_, primitive, {});
            fresh.area /= scale * scale;
            if (!fresh.pieces.empty()) fresh.pieces.resize(1);
            found->second = std::move(fresh);
        }
        LitSurface here = found->second;
        here.area *= scale * scale;
        include(sum, here, light, true, false);
    }

private:
    const World& world_;
    std::map<const void*, LitSurface> known_;
};

}  // namespace

std::uint32_t StatedLamps::begin(const Handle<LampData>& data, const Handle<Transform>& place,
                                 Span span) {
    lamps_.push_back({data, place, span});
    return static_cast<std::uint32_t>(lamps_.size());
}

void StatedLamps::add(std::uint32_t lamp, PrimitiveKind kind, std::size_t index, bool sealed) {
    if (lamp == 0 || !lamps_[lamp - 1].data->has_flux()) return;
    parts_.push_back({lamp, kind, static_cast<std::uint32_t>(index), sealed});
}

void StatedLamps::settle(World& world, Diagnostics& diagnostics) const {
    if (parts_.empty()) return;
    std::vector<Part> parts = parts_;
    std::ranges::stable_sort(parts, {}, &Part::lamp);
    std::vector<std::uint32_t> output_of(world.appearance.material_of.size(), 0);
    std::vector<LightOutput> outputs{1};
    std::map<double, std::uint32_t> even;
    std::map<std::pair<const WebbedBody*, WebKey>, std::uint32_t> webs;
    BodyWebs body_webs;
    Measuring measuring(world);
    for (std::size_t first = 0; first < parts.size();) {
        std::size_t end = first;
        const Lamp& lamp = lamps_[parts[first].lamp - 1];
        Emitted emitted;
        for (; end < parts.size() && parts[end].lamp == parts[first].lamp; ++end)
            measuring.add(emitted, world.geometry.primitive(parts[end].kind, parts[end].index),
                          parts[end].sealed, static_cast<bool>(lamp.data->web));
        std::uint32_t number = 0;
        const auto make = [&](auto& known, const auto& key, double scale, auto web) {
            const auto [found, added] =
                known.try_emplace(key, static_cast<std::uint32_t>(outputs.size()));
            if (added) outputs.push_back({scale, web()});
            number = found->second;
        };
        if (!(emitted.light > 0)) {
            diagnostics.add(
                warning(Fault::degenerate, lamp.span,
                        "this luminaire has a flux, but nothing of it glows")
                    .with_help("emission is multiplied by the pigment, which is black where none "
                               "is given: pigment { rgb 1 }"));
        } else if (lamp.data->web) {
            LampData place = *lamp.data;
            if (lamp.place) turn(place, *lamp.place);
            // Over the mean luminance, and by the web's own flux, which is that of its candela.
            const double scale = std::numbers::pi * place.total_flux() * emitted.area /
                                 (emitted.light * place.web->flux());
            const WebbedBody* const body = body_webs.body(place, std::move(emitted.body));
            make(webs, std::pair(body, web_key(place, scale)), scale,
                 [&] { return body_webs.last(); });
        } else {
            const double scale = lamp.data->total_flux() / emitted.light;
            make(even, scale, scale, [] { return Handle<BodyWeb>(); });
        }
        for (std::size_t i = first; i < end; ++i)
            output_of[world.geometry.primitive(parts[i].kind, parts[i].index)] = number;
        first = end;
    }
    world.appearance.outputs = std::move(outputs);
    world.appearance.output_of = std::move(output_of);
}

}  // namespace candelabra
