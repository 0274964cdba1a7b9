// SPDX-License-Identifier: GPL-3.0-or-later
// What a world says of the looks of its surfaces, point by point: textures, u and v.
#include "shape/triangle.h"
#include "shape/uv.h"
#include "world/world.h"

namespace {

std::array<Vec3, 3> corners(const TrianglePrimitive& t) {
    return {t.corner1, t.corner2, t.corner3};
}

Vec3 local(const Handle<Transform>& transform, const Vec3& point) {
    return transform ? transform->inverse_point(point) : point;
}

using Use = FunctionRef<void(double, const Texture&)>;

/// Three textures, each as strong as its corner; equal ones as one.
void blend(const std::array<const Texture*, 3>& textures, const Vec3& weights, Use use) {
    const bool same = textures[0] == textures[1] && textures[1] == textures[2];
    if (same) return use(1, *textures[0]);
    for (std::size_t i = 0; i < 3; ++i)
        if (const double weight = weights[static_cast<int>(i)]; weight > 0)
            use(weight, *textures[i]);
}

/// The textures of a blob's components, each as strong as the fields of those that have it are at
/// the point; fields that take away count as well.
template <class TextureOf>
void blend_fields(const BuiltBlob& blob, const Vec3& point, TextureOf texture_of, Use use) {
    std::vector<std::pair<const Texture*, double>> strengths;
    double sum = 0;
    blob.index.around(point, [&](std::uint32_t i) {
        const double strength = std::abs(strength_at(blob.sources[i], point));
        if (strength == 0) return;
        const Texture* const texture = texture_of(blob.sources[i].look);
        const auto same =
            std::ranges::find(strengths, texture, &std::pair<const Texture*, double>::first);
        if (same == strengths.end())
            strengths.emplace_back(texture, strength);
        else
            same->second += strength;
        sum += strength;
    });
    if (strengths.empty()) return use(1, *texture_of(-1));
    for (const auto& [texture, strength] : strengths) use(strength / sum, *texture);
}

/// Within the triangle, whatever rounding says.
Vec3 positive(const Vec3& weights) {
    const Vec3 clipped = glm::max(weights, Vec3(0));
    return clipped / (clipped.x + clipped.y + clipped.z);
}

}  // namespace

const CompositeLeaf& World::leaf(std::uint32_t number) const {
    const PlacedComposite& placed = composites[composite_of[number]];
    return placed.composite->leaf(number + leaves_begin() - placed.first_leaf);
}

void World::for_textures(PrimitiveIndex primitive, std::uint32_t part, const Vec3& point,
                         Use use) const {
    const Material& look = material(primitive);
    if (look.texture2) {
        const TrianglePrimitive& face = triangles[primitive - spheres.size()];
        return blend({look.texture.get(), look.texture2.get(), look.texture3.get()},
                     positive(corner_weights(corners(face), point)), use);
    }
    const auto found = part_textures.empty() ? part_textures.end() : part_textures.find(primitive);
    if (found == part_textures.end()) return use(1, *look.texture);
    const auto texture_of = [&](int number) {
        return number < 0 ? look.texture.get()
                          : found->second[static_cast<std::size_t>(number)].get();
    };
    const bool is_leaf = primitive >= leaves_begin();
    const CompositeLeaf* const placed = is_leaf ? &leaf(primitive - leaves_begin()) : nullptr;
    const PlacedShape* const alone =
        is_leaf ? nullptr : &shapes[primitive - spheres.size() - triangles.size()];
    const BuiltShape& shape = is_leaf ? placed->shape : alone->shape;
    const Vec3 here = local(is_leaf ? placed->transform : alone->transform, point);
    if (const auto* blob = std::get_if<Shared<BuiltBlob>>(&shape))
        return blend_fields(**blob, here, texture_of, use);
    const BuiltMesh& built = *std::get<Shared<BuiltMesh>>(shape);
    if (part == any_part) part = face_at(built, here);
    std::array<const Texture*, 3> textures;
    for (std::size_t i = 0; i < 3; ++i) textures[i] = texture_of(built.mesh->looks[part][i]);
    blend(textures, positive(corner_weights(face(*built.mesh, part).corners, here)), use);
}

Vec2 World::uv(PrimitiveIndex primitive, std::uint32_t part, const Vec3& point) const {
    const std::size_t first_shape = spheres.size() + triangles.size();
    std::optional<Vec2> found;
    if (primitive < spheres.size()) {
        const SpherePrimitive& s = spheres[primitive];
        found = ::uv(Sphere{s.centre, s.radius}, point, part);
    } else if (primitive < first_shape) {
        const auto number = static_cast<std::uint32_t>(primitive - spheres.size());
        if (number >= uvs_of.size() || uvs_of[number] == no_primitive) return Vec2(0);
        const Vec3 w = corner_weights(corners(triangles[number]), point);
        const std::array<Vec2, 3>& at = uvs[uvs_of[number]];
        return w.x * at[0] + w.y * at[1] + w.z * at[2];
    } else if (primitive < leaves_begin()) {
        const PlacedShape& placed = shapes[primitive - first_shape];
        found = ::uv(placed.shape, local(placed.transform, point), part);
    } else {
        const CompositeLeaf& placed = leaf(primitive - leaves_begin());
        found = ::uv(placed.shape, local(placed.transform, point), part);
    }
    // As in POV-Ray, around what has no u and v, pictures lie on the plane of x and y.
    return found.value_or(Vec2(point.x, point.y));
}
