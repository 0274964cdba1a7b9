// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/flatten.h"

#include "csg/assemble.h"
#include "csg/extent.h"
#include "shape/watertight.h"
#include "text/message.h"
#include "world/corners.h"
#include "world/emission.h"
#include "world/emitters.h"
#include "world/light_groups.h"
#include "world/materials.h"
#include "world/mesh_copies.h"
#include "world/primitive_lists.h"
#include "world/prototype.h"
#include "world/provenance.h"
#include "world/stated_lamps.h"
#include "world/sun.h"
#include "world/volumes.h"

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>

namespace candelabra {

namespace {

/// Whether an object is one solid that cannot be taken apart into separate primitives.
bool is_composite(const Object& object) {
    const Union* group = std::get_if<Union>(&object.form);
    return object.clipping || object.inverse || (group && group->csg != Csg::together);
}

template <class T>
bool has_looks_of(const Object& object) {
    const auto* shape = std::get_if<Shape>(&object.form);
    return shape && std::holds_alternative<Shared<T>>(*shape) && object.part_textures &&
           !object.part_textures->list.empty();
}

/// Whether faces of a mesh have textures of their own.
bool has_face_looks(const Object& object) {
    return has_looks_of<Mesh>(object) &&
           !std::get<Shared<Mesh>>(std::get<Shape>(object.form))->looks.empty();
}

/// Whether components of a blob have textures of their own.
bool has_component_looks(const Object& object) { return has_looks_of<Blob>(object); }

class Flattener : private PrimitiveLists {
public:
    Flattener(const Scene& scene, World& world, Diagnostics& diagnostics,
              const FlattenOptions& options)
        : world_(world),
          geometry_(world.geometry),
          diagnostics_(&diagnostics),
          objects_(world.provenance, options.remembers_objects),
          statements_(world.provenance),
          all_(options.what == Flatten::everything),
          keeps_lamps_(options.follows_lamps || !scene.meters.empty()),
          only_lights_count_(!all_ && !scene.lights.empty() &&
                             !world.rules.settings.ambient_luminaires),
          materials_(world),
          shapes_(world.rules.settings.index) {
        if (!options.remembers_objects) plan_.emplace(scene, options.instances);
    }

    /// First pass. Primitives are numbered by kind (spheres, triangles, shapes), so each kind is
    /// kept separately until all are known. `whole`: the object is taken apart, but rays see it as
    /// one, like a union with bounds in POV-Ray.
    void add(const Object& object, const Inherited& outer, bool whole = false) {
        const auto* together = std::get_if<Union>(&object.form);
        if (!together || !together->light_name) return add_light_unnamed(object, outer, whole);
        const auto around = statements_.begin(object.span, together->light_name);
        add_light_unnamed(object, outer, whole);
        statements_.begin(around.span, around.name);
    }

    void add_light_unnamed(const Object& object, const Inherited& outer, bool whole) {
        if (has_needless_bounds(object))
            return add_light_unnamed(without_bounds(object), outer, true);
        const bool inert =
            only_lights_count_ && outer.lamp == 0 && cannot_emit(object, outer.texture);
        if (inert || is_composite(object)) {
            ++world_.provenance.object_count;
            objects_.begin(object.span);
            if (!inert && (all_ || glows(object, outer))) add_composite(object, outer);
            return;
        }
        Inherited here = inherit(object, outer);
        if (const Union* group = std::get_if<Union>(&object.form)) {
            enter_group(*group, here);
            if (whole) here.heeded = heeded_in(group->csg);
            for (const ObjectHandle& child : group->children)
                if (!add_instance(*child, here)) add(*child, here);
            return;
        }
        TextureList components;
        const std::uint32_t material =
            has_face_looks(object) || has_component_looks(object)
                ? materials_.of_parts(object, here, outer.transform, components)
                : materials_.index(here);
        const auto* row = std::get_if<SphereRow>(&object.form);
        world_.provenance.object_count += row ? row->spheres.size() : 1;
        const bool placed = all_ || materials_.glows(material) || fills(material);
        if (row) {
            for (std::size_t i = 0; placed && i < row->spheres.size(); ++i) {
                objects_.begin(row->spans[i]);
                begin_lamp(here, material, row->spans[i]);
                place_sphere(row->spheres[i], here.transform, material, row->spans[i]);
            }
            return;
        }
        objects_.begin(object.span);
        const Shape& shape = std::get<Shape>(object.form);
        const auto* mesh = std::get_if<Shared<Mesh>>(&shape);
        if (!placed) return;
        begin_lamp(here, material, object.span);
        if (mesh && is_taken_apart(object, **mesh, here, material)) {
            // The faces of one mesh share a material of their own, which distinguishes the mesh
            // from other solids.
            add_mesh(**mesh, here.transform.get(),
                     has_face_looks(object) ? materials_.of_faces(object, here, outer.transform)
                                            : std::vector{materials_.own(material)},
                     object.span);
        } else {
            note_parts(PrimitiveKind::shape, geometry_.shapes.size(), std::move(components));
            place(shape, here, material, object.span);
        }
    }

    /// Adds a top-level object of the scene.
    void add_statement(const Object& object) {
        statements_.begin(object.span);
        if (!add_instance(object, {})) add(object, {});
    }

    /// Adds a light source of the scene, or of a group, already in its place.
    void add_light(PlacedLight placed, std::uint32_t group = 0) {
        LightReach reach{group};
        if (placed.projected_through)
            reach.window = make_handle<Composite>(composite_of(*placed.projected_through, shapes_));
        // Lights of a group belong to the group's statement, unless they have another name.
        const bool own = group == 0 || placed.light_name;
        const auto around =
            own ? statements_.begin(placed.span, placed.light_name) : statements_.current();
        world_.provenance.statement_of_light.push_back(statements_.number());
        if (own) statements_.begin(around.span, around.name);
        settle(placed.light);
        world_.lights.sources.push_back(std::move(placed.light));
        reach.photons = placed.photons.ways();
        reach.photons_of_grid = placed.photons.area_light;
        world_.lights.reach.push_back(std::move(reach));
    }

    void finish() {
        world_.appearance.material_of = materials_in_order(geometry_);
        objects_.finish();
        const PrimitiveIndex shapes = geometry_.shapes_begin(), leaves = geometry_.leaves_begin();
        for (std::uint32_t& item : geometry_.infinite.all) item += shapes;
        for (std::uint32_t i = 0; i < geometry_.composites.size(); ++i) {
            const PlacedComposite& placed = geometry_.composites[i];
            if (!placed.composite->bounds().empty() && !finite(placed.composite->bounds()))
                geometry_.infinite.all.push_back(leaves + i);
        }
        for (Parted& each : parted_)
            world_.appearance.part_textures[geometry_.primitive(each.kind, each.index)] =
                std::move(each.textures);
        PrimitiveIndex next = geometry_.instanced_begin();
        for (Instance& placed : geometry_.instances) {
            placed.first = next;
            next += static_cast<PrimitiveIndex>(geometry_.prototype_of(placed).primitive_count());
        }
        if (all_) lamps_.settle(world_, *diagnostics_);
        if (!all_ || keeps_lamps_ || receives_light(world_)) {
            add_luminaires(world_, glowing_, all_, *diagnostics_);
            place_luminaires(world_, statement_of_instance_);
            add_volumes(world_, filled_, all_, *diagnostics_);
        } else {
            for (const auto& prototype : geometry_.prototypes) prototype->luminaire_of.clear();
        }
        if (all_) place_photon_targets(world_, *diagnostics_);
    }

private:
    using PrototypeKey = std::pair<const Object*, const Texture*>;
    static constexpr std::uint32_t no_prototype = ~std::uint32_t{0};
    /// Number of primitives of all instances; more could not be numbered.
    static constexpr std::uint64_t max_instanced = std::uint64_t{1} << 31;

    /// Places the object as an instance. Returns false, and adds nothing, if it is not shared.
    bool add_instance(const Object& object, const Inherited& outer) {
        if (!plan_ || !plan_->shares(object) || !InstancePlan::is_bare(outer)) return false;
        const PrototypeKey key{&object, outer.texture ? outer.texture->get() : nullptr};
        const auto [found, added] = prototypes_.try_emplace(key, no_prototype);
        if (added) found->second = prototype_number(object, outer);
        if (found->second == no_prototype) return false;
        const Prototype& prototype = *geometry_.prototypes[found->second];
        if (instanced_ + prototype.primitive_count() > max_instanced) return false;
        // Luminaires are made anew in each place, if their solid angles stay what they are.
        const bool lit = !prototype.luminaires.empty();
        if (lit && outer.transform && !(outer.transform->uniform_scale() > 0)) return false;
        instanced_ += prototype.primitive_count();
        statement_of_instance_.push_back(lit ? statements_.number() : 0);
        world_.provenance.object_count += prototype.object_count;
        geometry_.instances.push_back(
            {outer.transform ? outer.transform : unmoved_, found->second});
        return true;
    }

    /// Makes a prototype of an object. Returns its number; no_prototype if its look depends on its
    /// place.
    std::uint32_t prototype_number(const Object& object, const Inherited& outer) {
        auto made = std::make_shared<Prototype>();
        Diagnostics said;
        PrimitiveLists lists;
        std::optional<InstancePlan> plan;
        const std::size_t objects = std::exchange(world_.provenance.object_count, 0);
        Diagnostics* const around = std::exchange(diagnostics_, &said);
        const auto swap_all = [&] {
            std::swap(geometry_, made->geometry);
            std::swap(static_cast<PrimitiveLists&>(*this), lists);
            std::swap(plan_, plan);
        };
        swap_all();
        Inherited here = outer;
        here.transform = nullptr;
        add(object, here);
        swap_all();
        diagnostics_ = around;
        made->object_count = std::exchange(world_.provenance.object_count, objects);
        made->material_of = lists.materials_in_order(made->geometry);
        for (std::uint32_t item = 0; item < made->geometry.item_count(); ++item)
            made->box = join(made->box, made->geometry.bounds(item));
        // All lone triangles of a material are one solid, wherever they are.
        const bool apart = !lists.filled_.empty() || !lists.parted_.empty() ||
                           lists.clear_triangle_ || !made->geometry.infinite.all.empty() ||
                           !(made->box.empty() || finite(made->box));
        if (apart || !std::ranges::all_of(made->material_of, [&](std::uint32_t number) {
                const Material& material = world_.appearance.materials[number];
                made->blocks_light &= material.stops_light();
                made->clear |= material.transparent;
                made->has_interiors |= material.transparent || material.interior;
                return InstancePlan::is_alike(material);
            }))
            return no_prototype;
        if (made->clear) number_solids(*made);
        if (!add_luminaires(world_, *made, lists.glowing_, all_, said)) return no_prototype;
        for (const Diagnostic& each : said.all()) diagnostics_->add(each);
        geometry_.prototypes.push_back(std::move(made));
        return static_cast<std::uint32_t>(geometry_.prototypes.size() - 1);
    }

    /// Tells the meshes of a prototype apart.
    void number_solids(Prototype& made) const {
        std::unordered_map<std::uint32_t, PrimitiveIndex> first;
        const PrimitiveIndex begin = made.geometry.triangles_begin();
        for (PrimitiveIndex i = begin; i < made.geometry.shapes_begin(); ++i) {
            const std::uint32_t solid = world_.appearance.materials[made.material_of[i]].solid;
            made.first_of_solids.push_back(first.try_emplace(solid, i).first->second);
        }
    }

    Inherited inherit(const Object& object, const Inherited& outer) {
        Inherited here = outer;
        here.transform = combined(object.transform, outer.transform);
        here.uv |= object.uv_mapping;
        if (object.texture)
            here.texture = &materials_.world_texture(object.texture, outer.transform, here.uv);
        else if (here.uv && !outer.uv)
            here.texture = &materials_.world_texture(*here.texture, {}, true);
        if (object.part_textures && object.part_textures->interior)
            here.inner =
                &materials_.world_texture(object.part_textures->interior, outer.transform, here.uv);
        // As in POV-Ray, components with their own textures show these on the inside, too.
        if (has_component_looks(object)) here.inner = nullptr;
        if (object.interior) {
            const auto* group = std::get_if<Union>(&object.form);
            here.interior = &materials_.world_interior(object.interior, outer.transform);
            const bool shared = outer.of_several || (group && group->csg == Csg::together);
            here.shared_interior = shared ? ++shared_interiors_ : 0;
        }
        here.said = outer.said | Hidden{object.no_shadow, object.no_image, object.no_reflection,
                                        object.no_radiosity};
        static_cast<Hidden&>(here) = outer | (here.said & outer.heeded);
        if (object.lamp) {
            here.lamp = lamps_.begin(object.lamp, here.transform, object.span);
            here.lamp_data = &object.lamp;
            here.all_of_lamp = !emits(object, outer.texture);
        }
        here.no_luminaire |= object.no_luminaire;
        here.double_illuminate |= object.double_illuminate;
        here.hollow |= object.hollow;
        if (object.photons) here.photons = photon_surface(world_, *object.photons, object.span);
        return here;
    }

    /// Notes which lamp the next primitives belong to: that of an object around them, or one of
    /// their own, if their finish states its flux.
    void begin_lamp(const Inherited& here, std::uint32_t material, Span span) {
        const Handle<LampData>& own = materials_.lamp(material);
        lamp_ = here.lamp != 0 || !own || !own->has_flux()
                    ? here.lamp
                    : lamps_.begin(own, here.transform, span);
        closure_ = Closure::none;
    }

    /// Adds the lights of a light group where the group stands.
    void enter_group(const Union& group, Inherited& here) {
        if (!opens_group(world_.lights.groups, group, here)) return;
        const std::uint32_t number = here.light_group;
        for (const PlacedLight& light : group.lights)
            add_light(here.transform ? transformed(light, *here.transform) : light, number);
    }

    /// Whether any part of the object glows.
    bool glows(const Object& object, const Inherited& outer) {
        const Inherited here = inherit(object, outer);
        bool any = false;
        if (const Union* group = std::get_if<Union>(&object.form))
            for (const ObjectHandle& child : group->children) any |= glows(*child, here);
        else
            any = materials_.glows(materials_.index(here)) || fills(materials_.index(here));
        if (object.clipping)
            for (const ObjectHandle& clip : object.clipping->clips) any |= glows(*clip, here);
        return any;
    }

    /// Whether the faces of a mesh become primitives. If only some faces glow, each is a luminaire;
    /// and if the mesh has an inner texture, only faces know which side is the inner one.
    bool is_taken_apart(const Object& object, const Mesh& mesh, const Inherited& here,
                        std::uint32_t material) {
        return here.inner || (has_face_looks(object) && materials_.glows(material)) ||
               copies_.takes_apart(mesh);
    }

    /// Records the textures of parts of the next primitive; most have none.
    void note_parts(PrimitiveKind kind, std::size_t index, TextureList textures) {
        if (!textures.empty())
            parted_.push_back({kind, static_cast<std::uint32_t>(index), std::move(textures)});
    }

    void place(const Shape& shape, const Inherited& here, std::uint32_t material, Span span) {
        if (const auto* sphere = std::get_if<Sphere>(&shape)) {
            place_sphere(*sphere, here.transform, material, span);
        } else if (const auto* flat = std::get_if<Shared<Triangle>>(&shape)) {
            clear_triangle_ |= world_.appearance.materials[material].transparent;
            const TrianglePrimitive own{(*flat)->corner1, (*flat)->corner2, (*flat)->corner3};
            const TrianglePrimitive there = placed(own, here.transform.get());
            const bool sided = here.inner && here.transform;
            add_triangle(sided ? outer_side_first(there) : there, material, span);
        } else if (const auto* smooth = std::get_if<Shared<SmoothTriangle>>(&shape)) {
            SmoothCorners there = placed(**smooth, here.transform.get());
            if (here.inner) there.put_outer_side_first();
            add_triangle(there.corners, material, span);
            add_normals(there.normals);
        } else {
            note_loose_surface(shape);
            add_shape(shapes_.built(shape, here.transform), here.transform, material, span);
        }
    }

    void note_loose_surface(const Shape& shape) {
        const auto* julia = std::get_if<Shared<JuliaFractal>>(&shape);
        world_.appearance.any_loose_surface |= julia && is_by_formula(**julia);
    }

    void place_sphere(const Sphere& sphere, const Handle<Transform>& transform,
                      std::uint32_t material, Span span) {
        const double scale = transform ? transform->uniform_scale() : 1;
        // For a rotated sphere, only the shape in its place knows where u is 0.
        const bool wrapped = transform && world_.appearance.materials[material].uv;
        if (scale == 0 || wrapped) return add_shape(sphere, transform, material, span);
        const Vec3 centre = transform ? transform->point(sphere.centre) : sphere.centre;
        add_sphere({centre, sphere.radius * scale}, material, span);
    }

    /// `materials`: that of the mesh, and those of its textures.
    void add_mesh(const Mesh& mesh, const Transform* transform,
                  const std::vector<std::uint32_t>& materials, Span span) {
        const bool sided = world_.appearance.materials[materials.front()].inner != nullptr;
        // Reflection does not change the outer side of a mesh.
        const bool mirrored = transform && transform->determinant() < 0;
        const auto emits = [&](std::uint32_t material) { return materials_.emits(material); };
        if (std::ranges::any_of(materials, emits)) {
            closure_ = closure(mesh);
            if (mirrored) closure_ = turned_over(closure_);
        }
        for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
            MeshFace f{face(mesh, i), face_uvs(mesh, i),
                       mesh.looks.empty() ? Face{-1, -1, -1} : mesh.looks[i]};
            if (sided && f.is_inside_out() != mirrored) f.turn_over();
            const std::uint32_t material = materials_.of_face(materials, f.looks);
            const auto& [a, b, c] = f.shape.corners;
            add_triangle(placed(TrianglePrimitive{a, b, c}, transform), material, span);
            if (world_.appearance.materials[material].uv) {
                geometry_.uvs_of.resize(geometry_.triangles.size(), no_primitive);
                geometry_.uvs_of.back() = static_cast<std::uint32_t>(geometry_.uvs.size());
                geometry_.uvs.push_back(f.uvs);
            }
            // As in POV-Ray, normals of a mesh are interpolated before they are transformed.
            const auto& normals = f.shape.normals;
            if (f.shape.smooth)
                add_normals(placed(units({normals[0], normals[1], normals[2]}), transform));
        }
    }

    void add_sphere(const SpherePrimitive& sphere, std::uint32_t material, Span span) {
        note_luminaire(PrimitiveKind::sphere, geometry_.spheres.size(), material, span);
        geometry_.spheres.push_back(sphere);
        sphere_materials_.push_back(material);
        objects_.placed(PrimitiveKind::sphere);
    }

    void add_triangle(const TrianglePrimitive& t, std::uint32_t material, Span span) {
        note_luminaire(PrimitiveKind::triangle, geometry_.triangles.size(), material, span);
        geometry_.triangles.push_back(t);
        triangle_materials_.push_back(material);
        objects_.placed(PrimitiveKind::triangle);
    }

    /// Sets the normals of the last triangle.
    void add_normals(const CornerNormals& n) {
        geometry_.normals_of.resize(geometry_.triangles.size(), no_primitive);
        geometry_.normals_of.back() = static_cast<std::uint32_t>(geometry_.normals.size());
        geometry_.normals.push_back(n);
    }

    void add_shape(const BuiltShape& shape, const Handle<Transform>& transform,
                   std::uint32_t material, Span span) {
        const auto index = static_cast<std::uint32_t>(geometry_.shapes.size());
        const Box own = bounds(shape);
        note(PrimitiveKind::shape, index, material, span, finite(own));
        if (!finite(own)) geometry_.infinite.all.push_back(index);
        geometry_.shapes.push_back({shape, transform, transform ? transform->box(own) : own});
        shape_materials_.push_back(material);
        objects_.placed(PrimitiveKind::shape);
    }

    /// Collects the materials of a composite's leaves.
    struct LeafVisitor {
        Flattener& flattener;
        struct OwnLamp {
            Handle<LampData> data;
            std::uint32_t number;
        };

        std::vector<Inherited> around;
        bool transparent = false;
        std::vector<OwnLamp> own_lamps = {};

        void enter(const Object& object) {
            around.push_back(flattener.inherit(object, around.back()));
            const Union* group = std::get_if<Union>(&object.form);
            around.back().of_several = group && group->children.size() > 1;
            if (!group) return;
            around.back().heeded = heeded_in(group->csg);
            flattener.enter_group(*group, around.back());
        }
        void leave() { around.pop_back(); }
        /// All leaves whose finishes state the same flux are one lamp.
        std::uint32_t lamp_of(const Inherited& look, std::uint32_t material, Span span) {
            const Handle<LampData>& own = flattener.materials_.lamp(material);
            if (look.lamp != 0 || !own || !own->has_flux()) return look.lamp;
            const auto found = std::ranges::find(own_lamps, own, &OwnLamp::data);
            if (found != own_lamps.end()) return found->number;
            own_lamps.push_back({own, flattener.lamps_.begin(own, look.transform, span)});
            return own_lamps.back().number;
        }
        void leaf(const Object& object) {
            const Inherited& look = around.back();
            if (const auto* shape = std::get_if<Shape>(&object.form))
                flattener.note_loose_surface(*shape);
            const Handle<Transform>& outside = around[around.size() - 2].transform;
            TextureList parts;
            const std::uint32_t material =
                has_face_looks(object) || has_component_looks(object)
                    ? flattener.materials_.of_parts(object, look, outside, parts)
                    : flattener.materials_.index(look);
            flattener.note_parts(PrimitiveKind::leaf, flattener.leaf_materials_.size(),
                                 std::move(parts));
            transparent |= flattener.world_.appearance.materials[material].transparent;
            flattener.leaf_materials_.push_back(material);
            flattener.leaf_spans_.push_back(object.span);
            flattener.leaf_lamps_.push_back(lamp_of(look, material, object.span));
            flattener.objects_.placed(PrimitiveKind::leaf);
        }
    };

    void add_composite(const Object& object, const Inherited& outer) {
        const auto first = static_cast<PrimitiveIndex>(leaf_materials_.size());
        CompositeBuilder builder(world_.rules.settings.index);
        LeafVisitor visitor{*this, {outer}};
        const PartRef root =
            Assembler<LeafVisitor>(builder, shapes_, visitor).add(object, outer.transform);
        const auto composite = make_handle<Composite>(builder.finish(root));
        const auto number = static_cast<std::uint32_t>(geometry_.composites.size());
        const Box around = bounds_of_inside(object);
        geometry_.composites.push_back({composite, first, visitor.transparent,
                                        outer.transform ? outer.transform->box(around) : around});
        for (std::size_t leaf = first; leaf < leaf_materials_.size(); ++leaf) {
            geometry_.composite_of.push_back(number);
            const Box& seen = composite->leaf_bounds(static_cast<std::uint32_t>(leaf - first));
            lamp_ = leaf_lamps_[leaf];
            if (!seen.empty())
                note(PrimitiveKind::leaf, leaf, leaf_materials_[leaf], leaf_spans_[leaf],
                     finite(seen));
        }
    }

    /// Records a glowing primitive as a luminaire, unless it is infinite.
    void note(PrimitiveKind kind, std::size_t index, std::uint32_t material, Span span,
              bool bounded) {
        if (bounded) return note_luminaire(kind, index, material, span);
        note_volume(kind, index, material, span);
        if (!materials_.glows(material)) return;
        diagnostics_->add(
            warning(Fault::degenerate, span, "an unbounded luminaire glows, but lights nothing")
                .with_help("make it a large `box` or `disc`, which can be sampled"));
    }

    /// Whether media in such a primitive light the scene.
    bool fills(std::uint32_t material) const {
        return lights_from_inside(world_.appearance.materials[material]);
    }

    void note_volume(PrimitiveKind kind, std::size_t index, std::uint32_t material, Span span) {
        const Handle<Interior>& interior = world_.appearance.materials[material].interior;
        if (!interior || !interior->luminaire) return;
        const bool hollow = world_.appearance.materials[material].hollow,
                   solid = kind != PrimitiveKind::triangle;
        if (hollow && solid && fills(material))
            filled_.push_back(
                {kind, static_cast<std::uint32_t>(index), span, statements_.number()});
        if ((hollow && solid) || std::exchange(idle_volume_said_, true)) return;
        diagnostics_->add(
            solid ? warning(Fault::no_effect, span,
                            "the media in this object have no effect: it is not hollow")
                        .with_help("sphere { 0, 1 hollow pigment { rgbt 1 } interior { ... } }")
                  : warning(Fault::no_effect, span,
                            "the media in a mesh light nothing, though its interior has "
                            "`luminaire`")
                        .with_help("put the media into a `sphere` or a `box` around it"));
    }

    void note_luminaire(PrimitiveKind kind, std::size_t index, std::uint32_t material, Span span) {
        note_volume(kind, index, material, span);
        if (materials_.emits(material)) lamps_.add(lamp_, kind, index, closure_ != Closure::none);
        if (materials_.glows(material))
            glowing_.push_back(
                {kind, static_cast<std::uint32_t>(index), span, statements_.number(), closure_});
    }

    World& world_;
    Geometry& geometry_;
    Diagnostics* diagnostics_;
    std::optional<InstancePlan> plan_;  ///< none: everything is taken apart
    std::map<PrototypeKey, std::uint32_t> prototypes_;
    std::uint64_t instanced_ = 0;  ///< primitives of the instances so far
    std::vector<std::uint32_t> statement_of_instance_;  ///< of its light; 0 without any
    Handle<Transform> unmoved_ = make_handle<Transform>();
    StatedLamps lamps_;
    std::uint32_t lamp_ = 0;                 ///< of the next primitives, in lamps_; 0: none
    Closure closure_ = Closure::none;        ///< the mesh whose faces they are
    bool idle_volume_said_ = false;
    MeshCopies copies_;
    ObjectMemory objects_;
    LightStatements statements_;
    std::uint32_t shared_interiors_ = 0;  ///< number of shared interiors so far
    bool all_;
    bool keeps_lamps_;        ///< also if no surface shows their light
    bool only_lights_count_;  ///< materials of objects that do not glow are not needed
    Materials materials_;
    ShapeStore shapes_;
};

}  // namespace

void flatten(const Scene& scene, World& world, Diagnostics& diagnostics,
             const FlattenOptions& options) {
    Flattener flattener(scene, world, diagnostics, options);
    for (const PlacedLight& light : scene.lights) flattener.add_light(light);
    if (const auto sun = sun_of(world.sky.daylight, scene.daylight_statement))
        flattener.add_light(*sun);
    for (const ObjectHandle& object : scene.objects) flattener.add_statement(*object);
    flattener.finish();
}

}  // namespace candelabra
