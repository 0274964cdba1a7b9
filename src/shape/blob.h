// SPDX-License-Identifier: GPL-3.0-or-later
// The surface where the sum of some fields reaches a threshold: balls and rods that flow into each
// other. Rays ask the BuiltBlob.
#pragma once

#include "base/handle.h"
#include "base/ray.h"
#include "base/transform.h"
#include "shape/part_index.h"
#include "vocabulary/schema.h"

/// A field that falls from its strength in the centre to 0 at the radius.
struct BlobSphere {
    Vec3 centre = Vec3(0);
    double radius = 1;
    double strength = 1;
    Transform transform;
    int look = -1;

    static consteval auto vocabulary();
};

/// The same around a line, with round ends.
struct BlobCylinder {
    Vec3 base = Vec3(0);
    Vec3 cap = Vec3(0, 1, 0);
    double radius = 1;
    double strength = 1;
    Transform transform;
    int look = -1;

    static consteval auto vocabulary();
};

/// A sphere as old scenes write it.
struct BlobComponent {
    double strength = 1;
    double radius = 1;
    Vec3 centre = Vec3(0);

    static consteval auto vocabulary();
};

struct Blob {
    double threshold = 1;
    std::vector<BlobSphere> spheres;
    std::vector<BlobCylinder> cylinders;
    std::vector<BlobComponent> components;

    static consteval auto vocabulary();
};

consteval auto BlobSphere::vocabulary() {
    using F = Field<BlobSphere>;
    return schema<BlobSphere>(
        "sphere", "A field around a point.", F{"centre", &BlobSphere::centre, positional, "centre"},
        F{"radius", &BlobSphere::radius, positional, "how far the field reaches", above(0)},
        maybe(F{"strength", &BlobSphere::strength, positional, "field in the centre"}),
        F{"strength", &BlobSphere::strength, item, "the same, with its word"});
}

consteval auto BlobCylinder::vocabulary() {
    using F = Field<BlobCylinder>;
    return schema<BlobCylinder>(
        "cylinder", "A field around a line, with round ends.",
        F{"base", &BlobCylinder::base, positional, "one end of the line"},
        F{"cap", &BlobCylinder::cap, positional, "the other end"},
        F{"radius", &BlobCylinder::radius, positional, "how far the field reaches", above(0)},
        maybe(F{"strength", &BlobCylinder::strength, positional, "field on the line"}),
        F{"strength", &BlobCylinder::strength, item, "the same, with its word"});
}

consteval auto BlobComponent::vocabulary() {
    using F = Field<BlobComponent>;
    return schema<BlobComponent>(
        "component", "A field around a point, as old scenes write it.",
        F{"strength", &BlobComponent::strength, positional, "field in the centre"},
        F{"radius", &BlobComponent::radius, positional, "how far the field reaches", above(0)},
        F{"centre", &BlobComponent::centre, positional, "centre"});
}

consteval auto Blob::vocabulary() {
    using F = Field<Blob>;
    return schema<Blob>("blob", "Balls and rods that flow into each other.",
                        F{"threshold", &Blob::threshold, item, "field on the surface", above(0)},
                        parts<&Blob::spheres>("sphere", "a field around a point"),
                        parts<&Blob::cylinders>("cylinder", "a field around a line"),
                        loose_parts<&Blob::components>("component", "a sphere in the old form"));
}

struct BuiltBlob {
    enum class Kind : std::uint8_t { ball, hemisphere, rod };
    /// strength (1 - d^2 / radius^2)^2 where the distance d from the centre, or from the axis of a
    /// rod, is below the radius. Of a hemisphere only what is beyond the centre along the axis
    /// counts, of a rod what is from 0 to length along it.
    struct Source {
        Kind kind = Kind::ball;
        Vec3 centre = Vec3(0), axis = Vec3(0);
        double length = 0, radius2 = 1, strength = 1;
        Handle<Transform> transform;  ///< null: none
        int look = -1;
    };
    double threshold = 1;
    std::vector<Source> sources;
    PartIndex index;
};

BuiltBlob build(const Blob&);
/// What is wrong beyond the ranges of single fields (no component), as a sentence; empty when
/// nothing is.
std::string problem(const Blob&);

Box bounds(const BuiltBlob&);
void crossings(const BuiltBlob&, const Ray&, Crossings&);
bool inside(const BuiltBlob&, const Vec3&);

/// What the field of one source is at a point.
double strength_at(const BuiltBlob::Source&, const Vec3&);
