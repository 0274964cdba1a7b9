// SPDX-License-Identifier: GPL-3.0-or-later
// The surface where the sum of several fields reaches a threshold: balls and rods that flow into
// each other. Rays are tested against the BuiltBlob.
#pragma once

#include "base/handle.h"
#include "base/ray.h"
#include "base/transform.h"
#include "shape/part_index.h"
#include "vocabulary/item_info.h"

namespace candelabra {

/// A field that falls from its strength in the centre to 0 at the radius.
struct BlobSphere {
    Vec3 centre = Vec3(0);
    double radius = 1;
    double strength = 1;
    Transform transform;
    int look = -1;

    static const ItemInfo vocabulary;
};

/// The same field around a line segment, with round ends.
struct BlobCylinder {
    Vec3 base = Vec3(0);
    Vec3 cap = Vec3(0, 1, 0);
    double radius = 1;
    double strength = 1;
    Transform transform;
    int look = -1;

    static const ItemInfo vocabulary;
};

/// A sphere in the syntax of old scenes.
struct BlobComponent {
    double strength = 1;
    double radius = 1;
    Vec3 centre = Vec3(0);

    static const ItemInfo vocabulary;
};

struct Blob {
    double threshold = 1;
    std::vector<BlobSphere> spheres;
    std::vector<BlobCylinder> cylinders;
    std::vector<BlobComponent> components;

    static const ItemInfo vocabulary;
};

struct BuiltBlob {
    enum class Kind : std::uint8_t { ball, hemisphere, rod };
    /// strength (1 - d^2 / radius^2)^2 where the distance d from the centre, or from the axis of a
    /// rod, is below the radius. A hemisphere has a field only beyond the centre along the axis, a
    /// rod only from 0 to length along it.
    struct Source {
        Kind kind = Kind::ball;
        Vec3 centre = Vec3(0), axis = Vec3(0);
        double length = 0, radius2 = 1, strength = 1;
        Handle<Transform> transform;  ///< null: identity
        int look = -1;
    };
    double threshold = 1;
    std::vector<Source> sources;
    PartIndex index;
};

BuiltBlob build(const Blob&, const RayIndex& = {});
/// Error that the ranges of single fields do not exclude (no component), as a sentence; empty when
/// there is none.
std::string problem(const Blob&);
/// See shape.h.
std::string vanishes(const Blob&);

Box bounds(const BuiltBlob&);
void crossings(const BuiltBlob&, const Ray&, Crossings&);
void crossings_between(const BuiltBlob&, const Ray&, const Interval& range, Crossings&);
void nearest_crossings(const BuiltBlob&, const Ray&, const Interval& range, Crossings&);
bool inside(const BuiltBlob&, const Vec3&);

/// Value of the field of one source at a point.
double strength_at(const BuiltBlob::Source&, const Vec3&);

}  // namespace candelabra
