// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/flatten.h"

#include "text/message.h"

#include <map>

namespace {

/// What an object has from the unions around it.
struct Inherited {
    Handle<Transform> transform;  ///< null: none
    Handle<Texture> texture;      ///< in world space
    Handle<Interior> interior;
    bool no_shadow = false, no_image = false, no_reflection = false, double_illuminate = false;
};

Handle<Transform> combined(const Handle<Transform>& inner, const Handle<Transform>& outer) {
    if (!inner) return outer;
    if (!outer) return inner;
    return make_handle<Transform>(inner->then(*outer));
}

class Flattener {
public:
    Flattener(World& world, Diagnostics& diagnostics) : world_(world), diagnostics_(diagnostics) {}

    /// First pass: primitives are numbered spheres, triangles, shapes, so each kind is kept apart
    /// until all are known.
    void add(const Object& object, const Inherited& outer) {
        const Inherited here = inherit(object, outer);
        if (const Union* group = std::get_if<Union>(&object.form)) {
            for (const ObjectHandle& child : group->children) add(*child, here);
            return;
        }
        ++world_.objects;
        place(std::get<Shape>(object.form), here, material_index(here), object.span);
    }

    void finish() {
        auto& all = world_.material_of;
        all = std::move(sphere_materials_);
        all.insert(all.end(), triangle_materials_.begin(), triangle_materials_.end());
        all.insert(all.end(), shape_materials_.begin(), shape_materials_.end());
        if (!world_.normals.empty())
            world_.normals_of.resize(world_.triangles.size(), no_primitive);
        const auto triangles = static_cast<PrimitiveIndex>(world_.spheres.size());
        const auto shapes = static_cast<PrimitiveIndex>(triangles + world_.triangles.size());
        for (PrimitiveIndex& plane : world_.unbounded) plane += shapes;
        collect_luminaires(triangles, shapes);
    }

private:
    struct Unplaced {
        enum Kind { sphere, triangle, shape } kind;
        std::uint32_t index;
        Span span;
    };
    using MaterialKey = std::tuple<const Texture*, const Interior*, bool, bool, bool, bool>;
    using TextureKey = std::pair<const Texture*, const Transform*>;

    Inherited inherit(const Object& object, const Inherited& outer) {
        Inherited here = outer;
        here.transform = combined(object.transform, outer.transform);
        if (object.texture) here.texture = world_texture(object.texture, outer.transform);
        if (object.interior) here.interior = object.interior;
        here.no_shadow |= object.no_shadow;
        here.no_image |= object.no_image;
        here.no_reflection |= object.no_reflection;
        here.double_illuminate |= object.double_illuminate;
        return here;
    }

    /// A texture moves with the unions around its object. Plain colours look the same everywhere
    /// and are not copied.
    Handle<Texture> world_texture(const Handle<Texture>& texture,
                                  const Handle<Transform>& transform) {
        if (!transform || !texture->pigment.pattern) return texture;
        auto& known = textures_[TextureKey(texture.get(), transform.get())];
        if (!known) {
            known = make_handle<Texture>(transformed(*texture, *transform));
            kept_transforms_.push_back(transform);
        }
        return known;
    }

    std::uint32_t material_index(const Inherited& look) {
        const MaterialKey key(look.texture.get(), look.interior.get(), look.no_shadow,
                              look.no_image, look.no_reflection, look.double_illuminate);
        const auto next = static_cast<std::uint32_t>(world_.materials.size());
        const auto [found, added] = material_indices_.try_emplace(key, next);
        if (added) {
            const bool clear = transparent(look.texture->pigment);
            world_.materials.push_back({look.texture, look.interior, clear, look.no_shadow,
                                        look.no_image, look.no_reflection, look.double_illuminate});
            world_.any_transparent |= clear;
            world_.any_left_out |= look.no_image || look.no_reflection;
        }
        return found->second;
    }

    void place(const Shape& shape, const Inherited& here, std::uint32_t material, Span span) {
        if (const auto* sphere = std::get_if<Sphere>(&shape)) {
            const double scale = here.transform ? here.transform->uniform_scale() : 1;
            if (scale == 0) return add_shape(*sphere, here.transform, material, span);
            const Vec3 centre =
                here.transform ? here.transform->point(sphere->centre) : sphere->centre;
            add_sphere({centre, sphere->radius * scale}, material, span);
        } else if (const auto* flat = std::get_if<Shared<Triangle>>(&shape)) {
            add_triangle({(*flat)->corner1, (*flat)->corner2, (*flat)->corner3},
                         here.transform.get(), material, span);
        } else if (const auto* smooth = std::get_if<Shared<SmoothTriangle>>(&shape)) {
            const SmoothTriangle& s = **smooth;
            add_triangle({s.corner1, s.corner2, s.corner3}, here.transform.get(), material, span);
            add_normals({s.normal1, s.normal2, s.normal3}, here.transform.get());
        } else if (const auto* mesh = std::get_if<Shared<Mesh>>(&shape)) {
            // Faces of one mesh share a material that nothing else has: it tells them apart from
            // other solids.
            world_.materials.push_back(world_.materials[material]);
            add_mesh(**mesh, here.transform.get(),
                     static_cast<std::uint32_t>(world_.materials.size() - 1), span);
        } else {
            add_shape(built(shape), here.transform, material, span);
        }
    }

    void add_mesh(const Mesh& mesh, const Transform* transform, std::uint32_t material, Span span) {
        for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
            const MeshTriangle f = face(mesh, i);
            add_triangle({f.corners[0], f.corners[1], f.corners[2]}, transform, material, span);
            if (f.smooth) add_normals({f.normals[0], f.normals[1], f.normals[2]}, transform);
        }
    }

    void add_sphere(const SpherePrimitive& sphere, std::uint32_t material, Span span) {
        note_luminaire(Unplaced::sphere, world_.spheres.size(), material, span);
        world_.spheres.push_back(sphere);
        sphere_materials_.push_back(material);
    }

    void add_triangle(TrianglePrimitive t, const Transform* transform, std::uint32_t material,
                      Span span) {
        if (transform)
            t = {transform->point(t.corner1), transform->point(t.corner2),
                 transform->point(t.corner3)};
        note_luminaire(Unplaced::triangle, world_.triangles.size(), material, span);
        world_.triangles.push_back(t);
        triangle_materials_.push_back(material);
    }

    /// Of the triangle that was added last.
    void add_normals(CornerNormals n, const Transform* transform) {
        if (transform)
            n = {transform->normal(n.normal1), transform->normal(n.normal2),
                 transform->normal(n.normal3)};
        world_.normals_of.resize(world_.triangles.size(), no_primitive);
        world_.normals_of.back() = static_cast<std::uint32_t>(world_.normals.size());
        world_.normals.push_back({unit(n.normal1), unit(n.normal2), unit(n.normal3)});
    }

    void add_shape(const BuiltShape& shape, const Handle<Transform>& transform,
                   std::uint32_t material, Span span) {
        const auto index = static_cast<std::uint32_t>(world_.shapes.size());
        if (finite(bounds(shape))) {
            note_luminaire(Unplaced::shape, index, material, span);
        } else {
            world_.unbounded.push_back(index);
            if (greatest_emission(*world_.materials[material].texture) != Vec3(0))
                diagnostics_.add(
                    warning(Fault::degenerate, span,
                            "an unbounded luminaire glows, but lights nothing")
                        .with_help("make it a large `box` or `disc`, which can be sampled"));
        }
        world_.shapes.push_back({shape, transform});
        shape_materials_.push_back(material);
    }

    void note_luminaire(Unplaced::Kind kind, std::size_t index, std::uint32_t material, Span span) {
        if (greatest_emission(*world_.materials[material].texture) != Vec3(0))
            glowing_.push_back({kind, static_cast<std::uint32_t>(index), span});
    }

    void collect_luminaires(PrimitiveIndex first_triangle, PrimitiveIndex first_shape) {
        for (const Unplaced& glow : glowing_) {
            Luminaire luminaire;
            if (glow.kind == Unplaced::sphere) {
                const SpherePrimitive& s = world_.spheres[glow.index];
                luminaire.emitter = SphereEmitter{s.centre, s.radius};
                luminaire.primitive = glow.index;
            } else if (glow.kind == Unplaced::triangle) {
                const TrianglePrimitive& t = world_.triangles[glow.index];
                luminaire.emitter = TriangleEmitter{t.corner1, t.corner2, t.corner3};
                luminaire.primitive = first_triangle + glow.index;
            } else {
                luminaire.emitter = AreaEmitter{world_.shapes[glow.index].shape,
                                                world_.shapes[glow.index].transform};
                luminaire.primitive = first_shape + glow.index;
            }
            const Texture& texture = *world_.material(luminaire.primitive).texture;
            luminaire.radiance = greatest_emission(texture);
            luminaire.varying = texture.pigment.pattern.has_value();
            if (emitting_area(luminaire.emitter) > 0)
                world_.luminaires.push_back(std::move(luminaire));
            else
                diagnostics_.add(
                    warning(Fault::degenerate, glow.span,
                            "this luminaire has no area, so it gives no light")
                        .with_help(
                            "give it three corners that do not lie on one line, or leave it out"));
        }
    }

    World& world_;
    Diagnostics& diagnostics_;
    std::vector<std::uint32_t> sphere_materials_, triangle_materials_, shape_materials_;
    std::vector<Unplaced> glowing_;
    std::map<MaterialKey, std::uint32_t> material_indices_;
    std::map<TextureKey, Handle<Texture>> textures_;
    std::vector<Handle<Transform>>
        kept_transforms_;  ///< so that no address in textures_ is used twice
};

}  // namespace

void flatten(const Scene& scene, World& world, Diagnostics& diagnostics) {
    Flattener flattener(world, diagnostics);
    for (const ObjectHandle& object : scene.objects) flattener.add(*object, {});
    flattener.finish();
}
