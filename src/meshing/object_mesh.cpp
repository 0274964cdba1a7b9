// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/object_mesh.h"

#include "base/long_work.h"
#include "csg/assemble.h"
#include "csg/solid.h"
#include "shape/tessellation.h"
#include "shape/transformed.h"
#include "text/message.h"

#include <iterator>

namespace candelabra {

namespace {

/// The steps that build a solid, or a half space, which becomes a solid when it is known how much
/// of it is needed.
struct Part {
    std::vector<SolidOperation> steps = {};
    std::vector<Polyhedron> solids = {};
    Box box = {};
    std::optional<Plane> plane = {};
    bool inverse = false;  ///< the complement of the solid
};

Part solid(Polyhedron mesh) {
    Part part;
    for (const auto& [x, y, z] : mesh.points) part.box = join(part.box, Vec3(x, y, z));
    part.steps.push_back(SolidOperation::take);
    part.solids.push_back(std::move(mesh));
    return part;
}

Part combination(SolidOperation how, Part lower, Part upper) {
    lower.steps.insert(lower.steps.end(), upper.steps.begin(), upper.steps.end());
    lower.steps.push_back(how);
    std::ranges::move(upper.solids, std::back_inserter(lower.solids));
    if (how == SolidOperation::join) lower.box = join(lower.box, upper.box);
    return lower;
}

/// The union of all parts, joined in pairs, so that large parts are not processed again for each
/// small one.
Part joined(std::vector<Part> parts) {
    while (parts.size() > 1) {
        std::vector<Part> pairs;
        for (std::size_t i = 0; i + 1 < parts.size(); i += 2)
            pairs.push_back(
                combination(SolidOperation::join, std::move(parts[i]), std::move(parts[i + 1])));
        if (parts.size() % 2 == 1) pairs.push_back(std::move(parts.back()));
        parts = std::move(pairs);
    }
    return std::move(parts.front());
}

/// The part of the half space that matters in the box, as a block larger than the box.
Polyhedron block(const Plane& plane, const Box& box) {
    const Vec3 normal = unit(plane.normal), centre = box.centre();
    const double size = 2 * length(box.size()) + std::abs(dot(normal, centre) - plane.distance);
    const auto [x, y] = perpendiculars(normal);
    const Vec3 foot = centre + (plane.distance - dot(normal, centre)) * normal;
    Mesh cube = tessellation(Cuboid{Vec3(-1, -1, -2), Vec3(1, 1, 0)}, 4);
    for (Vec3& v : cube.vertices) v = foot + size * (v.x * x + v.y * y + v.z * normal);
    return polyhedron(cube);
}

class Maker {
public:
    explicit Maker(int cells) : cells_(cells) {}

    std::string problem;

    std::optional<Part> part(const Object& object, const Handle<Transform>& outer) {
        const Handle<Transform> transform = combined(object.transform, outer);
        if (object.clipping && !object.clipping->clips.empty())
            return fail("`clipped_by` leaves it open; use `intersection`");
        std::optional<Part> made = content(object, transform);
        if (made && object.inverse) invert(*made);
        return made;
    }

private:
    std::nullopt_t fail(std::string why) {
        if (problem.empty()) problem = std::move(why);
        return std::nullopt;
    }
    static void invert(Part& part) {
        if (part.plane)
            part.plane = Plane{-part.plane->normal, -part.plane->distance};
        else
            part.inverse = !part.inverse;
    }

    std::optional<Part> content(const Object& object, const Handle<Transform>& transform) {
        if (const auto* group = std::get_if<Union>(&object.form))
            return together(*group, transform);
        if (const auto* shape = std::get_if<Shape>(&object.form))
            return of_shape(*shape, transform.get());
        std::vector<Part> spheres;
        for (const Sphere& sphere : std::get<SphereRow>(object.form).spheres) {
            std::optional<Part> made = of_shape(sphere, transform.get());
            if (!made) return made;
            spheres.push_back(std::move(*made));
        }
        return joined(std::move(spheres));
    }

    std::optional<Part> of_shape(const Shape& shape, const Transform* transform) {
        if (const auto* plane = std::get_if<Plane>(&shape)) {
            Part half;
            half.plane = transform ? transformed(*plane, *transform) : *plane;
            return half;
        }
        Mesh mesh;
        append(tessellation(built(shape), cells_), transform, mesh);
        if (mesh.faces.empty())
            return fail(message("its `", Kinds<Shape>::infos[shape.index()]->name,
                                "` is no solid, has no end, or is too thin for the `resolution`"));
        return solid(polyhedron(mesh));
    }

    std::optional<Part> together(const Union& group, const Handle<Transform>& transform) {
        const bool cuts = group.csg == Csg::intersection || group.csg == Csg::difference;
        std::vector<Part> parts;
        for (const ObjectHandle& child : group.children) {
            const auto* inner = std::get_if<Union>(&child->form);
            if (inner && inner->children.empty()) continue;
            std::optional<Part> made = part(*child, transform);
            if (!made) return made;
            if (group.csg == Csg::difference && !parts.empty()) invert(*made);
            parts.push_back(std::move(*made));
        }
        if (parts.empty()) return fail("there is nothing in it");
        return cuts ? cut(std::move(parts)) : united(std::move(parts));
    }

    std::optional<Part> united(std::vector<Part> parts) {
        for (const Part& each : parts)
            if (each.plane || each.inverse) return fail("it has no end");
        return joined(std::move(parts));
    }

    /// The intersection of all parts.
    std::optional<Part> cut(std::vector<Part> parts) {
        std::optional<Part> kept;
        std::vector<Part> taken;
        for (Part& each : parts) {
            if (each.plane) continue;
            if (each.inverse)
                taken.push_back(std::move(each));
            else if (kept)
                kept = combination(SolidOperation::intersect, std::move(*kept), std::move(each));
            else
                kept = std::move(each);
        }
        if (!kept) return fail("it has no end");
        const Box box = kept->box;
        for (const Part& each : parts)
            if (each.plane)
                kept = combination(SolidOperation::intersect, std::move(*kept),
                                   solid(block(*each.plane, box)));
        if (taken.empty()) return kept;
        return combination(SolidOperation::subtract, std::move(*kept), joined(std::move(taken)));
    }

    int cells_;
};

/// Parameters of the triangulation.
struct How {
    int cells;
    const Polyhedra* library;
};

/// Parts of a union stay separate, as they do for rays.
void append_surface(const ObjectHandle& object, const Handle<Transform>& outer, const How& how,
                    Mesh& all) {
    const auto* group = std::get_if<Union>(&object->form);
    if (group && group->csg == Csg::together && !object->clipping && !object->inverse) {
        const Handle<Transform> transform = combined(object->transform, outer);
        for (const ObjectHandle& child : group->children)
            append_surface(child, transform, how, all);
        return;
    }
    if (const auto* row = std::get_if<SphereRow>(&object->form)) {
        const Handle<Transform> transform = combined(object->transform, outer);
        for (const Sphere& sphere : row->spheres)
            append(tessellation(sphere, how.cells), transform.get(), all);
        return;
    }
    const SolidMesh solid = solid_mesh(*object, how.cells, how.library);
    if (solid.problem.empty()) return append(mesh(solid.polyhedron), outer.get(), all);
    Solids solids;
    append(seen_tessellation(solids.composite(object), how.cells), outer.get(), all);
}

}  // namespace

SolidMesh solid_mesh(const Object& object, int cells, const Polyhedra* library) {
    Maker maker(cells);
    std::optional<Part> made = maker.part(object, {});
    if (!made) return {{}, maker.problem};
    if (made->plane || made->inverse) return {{}, "it has no end"};
    if (made->solids.size() == 1) return {std::move(made->solids.front()), {}};
    if (!library) return {{}, "the library for it is missing"};
    SolidMesh result;
    result.problem =
        library->combine(made->steps, made->solids, count_long_work, result.polyhedron);
    return result;
}

Mesh surface_mesh(const ObjectHandle& object, int cells, const Polyhedra* library) {
    Mesh all;
    append_surface(object, {}, {cells, library}, all);
    return all;
}

}  // namespace candelabra
