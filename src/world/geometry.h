// SPDX-License-Identifier: GPL-3.0-or-later
// The surfaces of a world, and their numbers.
//
// Primitives are the surfaces that rays meet. They are numbered by kind: all spheres, all
// triangles, all other shapes, all leaves of composites, and those of instances. Items are the
// elements of the tree, against which rays are tested: spheres, triangles and shapes with the same
// numbers, followed by the composites and the instances. A number from leaves_begin() on is that of
// a primitive or of an item; each function below says which of the two it takes.
#pragma once

#include "index/wide_tree.h"
#include "shape/composite.h"
#include "shape/part_index.h"
#include "shape/shape.h"

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace candelabra {

using PrimitiveIndex = std::uint32_t;
inline constexpr PrimitiveIndex no_primitive = ~PrimitiveIndex{0};

struct SpherePrimitive {
    Vec3 centre;
    double radius;
};

struct TrianglePrimitive {
    Vec3 corner1, corner2, corner3;
};

/// Normals of a smooth triangle's corners.
struct CornerNormals {
    Vec3 normal1, normal2, normal3;
};

/// A primitive of any other shape, under any affine map.
struct PlacedShape {
    BuiltShape shape;
    Handle<Transform> transform;  ///< null: none
    Box box;                      ///< bounding box; infinite for unbounded shapes like planes
};

/// A plane in world space, which every ray is tested against.
struct InfinitePlane {
    Vec3 normal;  ///< unit
    double distance;
    PrimitiveIndex primitive;

    /// Returns the ray parameter of the intersection; NaN if there is never one.
    double intersect(const Ray& ray) const {
        const double approach = dot(ray.direction, normal);
        return approach == 0 ? std::numeric_limits<double>::quiet_NaN()
                             : (distance - dot(ray.origin, normal)) / approach;
    }
};

/// Several shapes as one solid. Its leaves are primitives with consecutive numbers.
struct PlacedComposite {
    Handle<Composite> composite;
    PrimitiveIndex first_leaf = 0;
    bool transparent = false;  ///< whether any leaf is
    Box around;                ///< see bounds_of_inside
};

struct Prototype;

/// A set of surfaces in a place. Others have the same surfaces in other places: these are stored
/// once, as a Prototype. Its primitives have consecutive numbers, in the order of the prototype's.
struct Instance {
    Handle<Transform> place;  ///< never null
    std::uint32_t prototype = 0;
    PrimitiveIndex first = 0;           ///< of its primitives
    std::uint32_t first_luminaire = 0;  ///< of its luminaires, if it has any
};

/// Solids with an index, so that rays that begin anywhere can find those that contain their origin.
struct ClearSolids {
    std::vector<std::uint32_t> infinite;
    std::vector<std::uint32_t> finite;  ///< in the order of the index's parts
    PartIndex index;
};

/// Unbounded items, which rays are tested against apart from the tree.
struct InfiniteItems {
    std::vector<std::uint32_t> all;     ///< ascending
    std::vector<InfinitePlane> planes;  ///< planes without a transform
    std::vector<std::uint32_t> others;
};

enum class PrimitiveKind { sphere, triangle, shape, leaf };

struct Geometry {
    PrimitiveIndex triangles_begin() const { return static_cast<PrimitiveIndex>(spheres.size()); }
    PrimitiveIndex shapes_begin() const {
        return triangles_begin() + static_cast<PrimitiveIndex>(triangles.size());
    }
    PrimitiveIndex leaves_begin() const {
        return shapes_begin() + static_cast<PrimitiveIndex>(shapes.size());
    }
    std::uint32_t item_count() const {
        return instances_begin() + static_cast<std::uint32_t>(instances.size());
    }
    /// The first item that is an instance.
    std::uint32_t instances_begin() const {
        return leaves_begin() + static_cast<std::uint32_t>(composites.size());
    }
    /// The first primitive that belongs to an instance.
    PrimitiveIndex instanced_begin() const {
        return leaves_begin() + static_cast<PrimitiveIndex>(composite_of.size());
    }
    /// Number of primitives, with those of instances.
    std::size_t primitive_count() const;

    /// Returns the primitive with that index among those of its kind.
    PrimitiveIndex primitive(PrimitiveKind, std::uint32_t index) const;

    bool is_triangle(std::uint32_t number) const {
        return number >= triangles_begin() && number < shapes_begin();
    }
    bool is_leaf(PrimitiveIndex primitive) const {
        return primitive >= leaves_begin() && primitive < instanced_begin();
    }
    bool is_composite(std::uint32_t item) const {
        return item >= leaves_begin() && item < instances_begin();
    }
    /// Whether the primitive belongs to an instance.
    bool is_instanced(PrimitiveIndex primitive) const { return primitive >= instanced_begin(); }

    /// Precondition: the number is that of a triangle.
    const TrianglePrimitive& triangle(std::uint32_t number) const {
        return triangles[number - triangles_begin()];
    }
    /// Null for items of other kinds.
    const PlacedShape* shape(std::uint32_t item) const {
        const bool is = item >= shapes_begin() && item < leaves_begin();
        return is ? &shapes[item - shapes_begin()] : nullptr;
    }
    /// Null for items of other kinds.
    const PlacedComposite* composite(std::uint32_t item) const {
        return is_composite(item) ? &composites[item - leaves_begin()] : nullptr;
    }
    /// Null for items of other kinds.
    const Instance* instance(std::uint32_t item) const {
        return item >= instances_begin() ? &instances[item - instances_begin()] : nullptr;
    }
    /// The instance that a primitive belongs to. Precondition: is_instanced().
    const Instance& instance_of(PrimitiveIndex primitive) const;
    const Prototype& prototype_of(const Instance& instance) const {
        return *prototypes[instance.prototype];
    }
    /// Returns the primitive itself, the composite of a leaf, or the instance that it belongs to.
    std::uint32_t item_of(PrimitiveIndex primitive) const {
        if (is_instanced(primitive))
            return instances_begin() +
                   static_cast<std::uint32_t>(&instance_of(primitive) - instances.data());
        return is_leaf(primitive) ? leaves_begin() + composite_of[primitive - leaves_begin()]
                                  : primitive;
    }
    /// Null if the triangle is flat.
    const CornerNormals* normals_of_triangle(PrimitiveIndex primitive) const {
        if (normals_of.empty()) return nullptr;
        const std::uint32_t index = normals_of[primitive - triangles_begin()];
        return index == no_primitive ? nullptr : &normals[index];
    }
    /// Null if u and v of its corners are not known.
    const std::array<Vec2, 3>* uvs_of_triangle(PrimitiveIndex primitive) const {
        const std::size_t triangle = primitive - triangles_begin();
        const bool known = triangle < uvs_of.size() && uvs_of[triangle] != no_primitive;
        return known ? &uvs[uvs_of[triangle]] : nullptr;
    }

    /// Calls the one function that takes the item's type: SpherePrimitive, TrianglePrimitive,
    /// PlacedShape or PlacedComposite. Precondition: it is no instance.
    template <class OnSphere, class OnTriangle, class OnShape, class OnComposite>
    auto visit(std::uint32_t item, OnSphere on_sphere, OnTriangle on_triangle, OnShape on_shape,
               OnComposite on_composite) const {
        if (item < triangles_begin()) return on_sphere(spheres[item]);
        if (item < shapes_begin()) return on_triangle(triangles[item - triangles_begin()]);
        if (item < leaves_begin()) return on_shape(shapes[item - shapes_begin()]);
        return on_composite(composites[item - leaves_begin()]);
    }

    /// The same for a primitive; for a leaf, calls on_leaf(PlacedComposite, number of the leaf in
    /// it). Precondition: it belongs to no instance.
    template <class OnSphere, class OnTriangle, class OnShape, class OnLeaf>
    auto visit_primitive(PrimitiveIndex primitive, OnSphere on_sphere, OnTriangle on_triangle,
                         OnShape on_shape, OnLeaf on_leaf) const {
        return visit(item_of(primitive), on_sphere, on_triangle, on_shape,
                     [&](const PlacedComposite& placed) {
                         return on_leaf(placed, primitive - placed.first_leaf);
                     });
    }

    /// Bounding box of an item.
    Box bounds(std::uint32_t item) const;
    /// The same; empty for infinite items.
    Box finite_bounds(std::uint32_t item) const;
    /// Bounding box of all points inside of an item that is neither a triangle nor an instance.
    Box inside_bounds(std::uint32_t item) const;
    /// Where rays that begin inside of an item other than a triangle notice it. As in POV-Ray, that
    /// is only in its bounding box if it has one, although the inside of a disc is half of space.
    /// That of an instance is where they may be inside of one of its surfaces.
    Box noticed_in(std::uint32_t item) const;

    std::vector<SpherePrimitive> spheres;
    std::vector<TrianglePrimitive> triangles;
    std::vector<PlacedShape> shapes;  ///< all but triangles and spheres without a transform
    std::vector<PlacedComposite> composites;
    std::vector<std::uint32_t> composite_of;  ///< for each leaf
    std::vector<Instance> instances;          ///< in the order of their primitives
    std::vector<std::shared_ptr<Prototype>> prototypes;
    std::vector<CornerNormals> normals;       ///< of the smooth triangles
    /// Per triangle: index in normals, or no_primitive; empty when none is smooth.
    std::vector<std::uint32_t> normals_of;
    std::vector<std::array<Vec2, 3>> uvs;  ///< of the corners of some triangles
    /// Per triangle: index in uvs, or no_primitive; shorter if the last ones have none.
    std::vector<std::uint32_t> uvs_of;
    InfiniteItems infinite;
    WideTree tree;             ///< of the bounded items
    ClearSolids clear_solids;  ///< empty unless WorldFacts::indexes_solids
};

}  // namespace candelabra
