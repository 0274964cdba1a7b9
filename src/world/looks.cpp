// SPDX-License-Identifier: GPL-3.0-or-later
// The appearance of a world's surfaces at points: textures, u and v, emitted and transmitted light.
#include "shape/triangle.h"
#include "shape/uv.h"
#include "world/passage.h"
#include "world/prototype.h"
#include "world/world.h"

namespace candelabra {

namespace {

std::array<Vec3, 3> corners(const TrianglePrimitive& t) {
    return {t.corner1, t.corner2, t.corner3};
}

Vec3 local(const Transform* place, const Vec3& point) {
    return place ? place->inverse_point(point) : point;
}

using Use = World::UseTexture;

/// Three textures, weighted as their corners; three equal ones count as one.
void blend(const std::array<const Texture*, 3>& textures, const Vec3& weights, Use use) {
    const bool same = textures[0] == textures[1] && textures[1] == textures[2];
    if (same) return use(1, *textures[0], nullptr);
    for (std::size_t i = 0; i < 3; ++i)
        if (const double weight = weights[static_cast<int>(i)]; weight > 0)
            use(weight, *textures[i], nullptr);
}

/// Clamps the weights to the triangle, against rounding.
Vec3 positive(const Vec3& weights) {
    const Vec3 clipped = glm::max(weights, Vec3(0));
    return clipped / (clipped.x + clipped.y + clipped.z);
}

struct PartLooks {
    const Texture& own;  ///< for parts without a texture
    const TextureList& list;

    const Texture& operator[](int number) const {
        return number < 0 ? own : *list[static_cast<std::size_t>(number)];
    }
};

/// Textures of a mesh's face.
void blend_corners(const BuiltMesh& built, const PartLooks& looks, std::uint32_t part,
                   const Vec3& point, Use use) {
    if (part == any_part) part = face_at(built, point);
    std::array<const Texture*, 3> textures;
    for (std::size_t i = 0; i < 3; ++i) textures[i] = &looks[built.mesh->looks[part][i]];
    blend(textures, positive(corner_weights(face(*built.mesh, part).corners, point)), use);
}

/// Each component is weighted by the absolute strength of its field.
void blend_components(const BuiltBlob& blob, const PartLooks& looks, const Vec3& point, Use use) {
    std::vector<double> strengths(looks.list.size() + 1);  // first, that of the blob's own texture
    double sum = 0;
    blob.index.around(point, [&](std::uint32_t i) {
        const BuiltBlob::Source& source = blob.sources[i];
        const double strength = std::abs(strength_at(source, point));
        strengths[static_cast<std::size_t>(source.look + 1)] += strength;
        sum += strength;
    });
    if (sum == 0) return use(1, looks.own, nullptr);
    for (std::size_t i = 0; i < strengths.size(); ++i)
        if (strengths[i] > 0) use(strengths[i] / sum, looks[static_cast<int>(i) - 1], nullptr);
}

/// The u and v of a primitive that belongs to no instance; nothing if its shape has none.
std::optional<Vec2> uv_on(const Geometry& geometry, PrimitiveIndex primitive, std::uint32_t part,
                          const Vec3& point) {
    using MaybeUv = std::optional<Vec2>;
    const auto of_placed = [&](const auto& placed) -> MaybeUv {
        return candelabra::uv(placed.shape, local(placed.transform.get(), point), part);
    };
    return geometry.visit_primitive(
        primitive,
        [&](const SpherePrimitive& s) -> MaybeUv {
            return candelabra::uv(Sphere{s.centre, s.radius}, point, part);
        },
        [&](const TrianglePrimitive& face) -> MaybeUv {
            const std::array<Vec2, 3>* at = geometry.uvs_of_triangle(primitive);
            if (!at) return std::nullopt;
            const Vec3 w = corner_weights(corners(face), point);
            return w.x * (*at)[0] + w.y * (*at)[1] + w.z * (*at)[2];
        },
        of_placed,
        [&](const PlacedComposite& whole, std::uint32_t leaf) {
            return of_placed(whole.composite->leaf(leaf));
        });
}

}  // namespace

std::uint32_t World::instanced_material(PrimitiveIndex primitive) const {
    const Instance& placed = geometry.instance_of(primitive);
    return geometry.prototype_of(placed).material_of[primitive - placed.first];
}

std::uint32_t World::instanced_luminaire(PrimitiveIndex primitive) const {
    if (!geometry.is_instanced(primitive)) return no_primitive;
    const Instance& placed = geometry.instance_of(primitive);
    const auto& own = geometry.prototype_of(placed).luminaire_of;
    const std::uint32_t light = own.empty() ? no_primitive : own[primitive - placed.first];
    return light == no_primitive ? light : placed.first_luminaire + light;
}

void World::for_textures(PrimitiveIndex primitive, std::uint32_t part, const Vec3& point, Side side,
                         Use use) const {
    const Material& look = material(primitive);
    if (geometry.is_instanced(primitive)) {
        const bool moves = !look.texture->plain();
        return use(1, *look.texture, moves ? geometry.instance_of(primitive).place.get() : nullptr);
    }
    if (look.inner && side == Side::inner) return use(1, *look.inner, nullptr);
    if (look.texture2) {
        const TrianglePrimitive& face = geometry.triangle(primitive);
        return blend({look.texture.get(), look.texture2.get(), look.texture3.get()},
                     positive(corner_weights(corners(face), point)), use);
    }
    const auto found = appearance.part_textures.empty() ? appearance.part_textures.end()
                                                        : appearance.part_textures.find(primitive);
    if (found == appearance.part_textures.end()) return use(1, *look.texture, nullptr);
    const PartLooks looks{*look.texture, found->second};
    const auto show = [&](const auto& placed) {
        const Vec3 here = local(placed.transform.get(), point);
        if (const auto* blob = std::get_if<Shared<BuiltBlob>>(&placed.shape))
            blend_components(**blob, looks, here, use);
        else
            blend_corners(*std::get<Shared<BuiltMesh>>(placed.shape), looks, part, here, use);
    };
    const auto has_no_parts = [](const auto&) {};
    geometry.visit_primitive(primitive, has_no_parts, has_no_parts, show,
                             [&](const PlacedComposite& whole, std::uint32_t leaf) {
                                 show(whole.composite->leaf(leaf));
                             });
}

Vec2 World::uv(PrimitiveIndex primitive, std::uint32_t part, const Vec3& point) const {
    std::optional<Vec2> found;
    if (geometry.is_instanced(primitive)) {
        const Instance& placed = geometry.instance_of(primitive);
        found = uv_on(geometry.prototype_of(placed).geometry, primitive - placed.first, part,
                      placed.place->inverse_point(point));
    } else {
        found = uv_on(geometry, primitive, part, point);
    }
    // As in POV-Ray, shapes without u and v show pictures of the plane of x and y.
    return found.value_or(Vec2(point.x, point.y));
}

PatternScene World::pattern_scene(const SeenPoint& seen, SurfaceAxes& axes) const {
    PatternScene scene = pattern_scene(seen.primitive, seen.part, seen.point);
    const Material& look = material(seen.primitive);
    if (!look.by_axes) return scene;
    axes.behind = seen.side == Side::inner;
    scene.axes = &axes;
    if (!look.uv) return scene;
    axes.u = axes.v = Vec3(0);
    // Differences over a step that is short beside the surface, and exact where u and v are linear.
    constexpr double share = 1e-5;
    const Box box = geometry.bounds(geometry.item_of(seen.primitive));
    const double step =
        share * (finite(box) ? max_component(box.size()) : 1 + max_component(glm::abs(seen.point)));
    const auto [right, up] = perpendiculars(seen.normal);
    if (!(step > 0)) return scene;
    for (const Vec3& along : {right, up}) {
        Vec2 rise = uv(seen.primitive, seen.part, seen.point + step * along) -
                    uv(seen.primitive, seen.part, seen.point - step * along);
        rise -= glm::round(rise);  // where u begins again
        axes.u += rise.x / (2 * step) * along;
        axes.v += rise.y / (2 * step) * along;
    }
    return scene;
}

Rgb passed(const World& world, const Passage& passage, const Ray& ray) {
    const Material& m = world.material(passage.primitive);
    const double power = m.interior ? caustics_power * m.interior->caustics : 0;
    const Vec3 normal = unit(passage.normal);
    const FocusedLight light{ray.direction, dot(normal, ray.direction) > 0 ? -normal : normal,
                             power};
    const Vec3 point = ray.at(passage.t);
    const SurfaceView view{point, light.normal, ray.direction};
    const Side side = light.normal != normal ? Side::inner : Side::outer;
    SurfaceAxes axes;
    PatternScene scene =
        world.pattern_scene({passage.primitive, passage.part, point, normal, side}, axes);
    scene.view = &view;
    Rgb sum(0);
    const auto pass = [&](double share, const Texture& texture, const Transform* place) {
        sum += share * (power != 0 ? passing(texture, point, scene, light, place)
                                   : passing(texture, local(place, point), scene));
    };
    // The ray leads towards the light: it sees a surface that it leaves from inside.
    world.for_textures(passage.primitive, passage.part, point, side, pass);
    return sum;
}

Rgb World::passed(const Hit& hit, const Ray& ray) const {
    const Material& m = material(hit.primitive);
    if (m.no_shadow) return Rgb(1);
    if (!m.transparent) return Rgb(0);
    const double t = dot(hit.position - ray.origin, ray.direction);
    return candelabra::passed(*this, {t, hit.primitive, hit.normal, hit.part}, ray);
}

Rgb World::emission(PrimitiveIndex primitive, const Vec3& point, Side side,
                    const Vec3* direction) const {
    const PatternScene scene = pattern_scene(primitive, any_part, point);
    Rgb sum(0);
    for_textures(primitive, any_part, point, side,
                 [&](double weight, const Texture& texture, const Transform* place) {
                     sum += weight * candelabra::emission(
                                         texture, local(place, point), scene,
                                         [&](const Colour& colour) { return opacity(colour); });
                 });
    return sum * output(primitive, direction);
}

Rgb World::emission(const SeenPoint& seen, const Vec3& direction) const {
    const Vec3 normal = seen.side == Side::inner ? -seen.normal : seen.normal;
    const SurfaceView view{seen.point, normal, -direction};
    SurfaceAxes axes;
    PatternScene scene = pattern_scene(seen, axes);
    scene.view = &view;
    Rgb sum(0);
    for_textures(seen.primitive, seen.part, seen.point, seen.side,
                 [&](double share, const Texture& texture, const Transform* place) {
                     const auto add = [&](double weight, std::span<const Layer> layers) {
                         Rgb passing(share * weight);
                         for (const Layer& layer : layers) {
                             const Colour& colour = layer.colour;
                             sum += passing * colour.rgb * layer.finish->emission * opacity(colour);
                             passing *= colour.passing();
                         }
                     };
                     for_layers(texture, seen.point, normal, scene, add, place);
                 });
    return sum * output(seen.primitive, &direction);
}

double World::opacity(const Colour& colour) const {
    // Before version 3.7, filter counted by the brightest channel of the colour.
    if (rules.language_version < 3.7)
        return 1 - colour.filter * max_component(colour.rgb) - colour.transmit;
    return colour.opacity();
}

}  // namespace candelabra
