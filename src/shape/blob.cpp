// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/blob.h"

#include "base/order.h"
#include "vocabulary/parts.h"
#include "vocabulary/schema.h"

#include "base/roots.h"
#include "base/short_list.h"
#include "base/work_watch.h"

#include <algorithm>
#include <array>
#include <utility>

namespace candelabra {

const ItemInfo BlobSphere::vocabulary = described<BlobSphere>([] {
    using F = Field<BlobSphere>;
    return schema<BlobSphere>(
        "sphere", "A field around a point.", F{"centre", &BlobSphere::centre, positional, "centre"},
        F{"radius", &BlobSphere::radius, positional, "how far the field reaches", any_sign()},
        maybe(F{"strength", &BlobSphere::strength, positional, "field in the centre"}),
        F{"strength", &BlobSphere::strength, item, "the same, with its word"});
});

const ItemInfo BlobCylinder::vocabulary = described<BlobCylinder>([] {
    using F = Field<BlobCylinder>;
    return schema<BlobCylinder>(
        "cylinder", "A field around a line, with round ends.",
        F{"base", &BlobCylinder::base, positional, "one end of the line"},
        F{"cap", &BlobCylinder::cap, positional, "the other end"},
        F{"radius", &BlobCylinder::radius, positional, "how far the field reaches", any_sign()},
        maybe(F{"strength", &BlobCylinder::strength, positional, "field on the line"}),
        F{"strength", &BlobCylinder::strength, item, "the same, with its word"});
});

const ItemInfo BlobComponent::vocabulary = described<BlobComponent>([] {
    using F = Field<BlobComponent>;
    return schema<BlobComponent>(
        "component", "A field around a point, as old scenes write it.",
        F{"strength", &BlobComponent::strength, positional, "field in the centre"},
        F{"radius", &BlobComponent::radius, positional, "how far the field reaches", any_sign()},
        F{"centre", &BlobComponent::centre, positional, "centre"});
});

const ItemInfo Blob::vocabulary = described<Blob>([] {
    using F = Field<Blob>;
    return schema<Blob>(
        "blob",
        {"Balls and rods that flow into each other.",
         "blob { threshold 0.5 sphere { <-0.6, 0.8, 0>, 1, 1 } sphere { <0.6, 0.8, 0>, 1, 1 } "
         "cylinder { <0, 0.8, 0>, <0, 1.9, 0>, 0.5, 1 } }",
         "blob { threshold 0.5 component 1, 1, <-0.6, 0.8, 0> component 1, 1, <0.6, 0.8, 0> }"},
        F{"threshold", &Blob::threshold, item, "field on the surface", above(0)},
        parts<&Blob::spheres>("sphere", "a field around a point"),
        parts<&Blob::cylinders>("cylinder", "a field around a line"),
        loose_parts<&Blob::components>("component", "a sphere in the old form"));
});

namespace {

using Source = BuiltBlob::Source;
using Kind = BuiltBlob::Kind;

Handle<Transform> handle(const Transform& transform) {
    return transform == Transform() ? Handle<Transform>() : make_handle<Transform>(transform);
}

Box bounds(const Source& f) {
    const Vec3 r(std::sqrt(f.radius2));
    Box box{f.centre - r, f.centre + r};
    if (f.kind == Kind::rod) {
        const Vec3 far = f.centre + f.length * f.axis;
        box = join(box, {far - r, far + r});
    }
    return f.transform ? f.transform->box(box) : box;
}

/// a + b s + c s^2.
struct Quadratic {
    double a, b, c;

    /// The same polynomial as a function of s - place.
    Quadratic from(double place) const {
        return {a + place * (b + place * c), b + 2 * place * c, c};
    }
};

/// 1 - d^2 / radius^2 along the ray.
Quadratic nearness(const Source& f, const Ray& ray) {
    Vec3 o = ray.origin - f.centre, d = ray.direction;
    if (f.kind == Kind::rod) {
        o -= dot(o, f.axis) * f.axis;
        d -= dot(d, f.axis) * f.axis;
    }
    return {1 - dot(o, o) / f.radius2, -2 * dot(o, d) / f.radius2, -dot(d, d) / f.radius2};
}

/// The part of the range in which low <= (p - centre) . axis <= high.
Interval between(const Source& f, const Ray& ray, double low, double high, Interval range) {
    const double at = dot(ray.origin - f.centre, f.axis), rise = dot(ray.direction, f.axis);
    if (rise == 0) return at >= low && at < high ? range : Interval{1, 0};
    double first = (low - at) / rise, last = (high - at) / rise;
    if (rise < 0) std::swap(first, last);
    return {std::fmax(range.min, first), std::fmin(range.max, last)};
}

/// The interval of the ray in which the field is not 0.
Interval reach(const Source& f, const Ray& ray, const Quadratic& q) {
    Interval range = whole_line;
    if (q.c < 0) {
        const double square = q.b * q.b - 4 * q.a * q.c;
        if (!(square > 0)) return {1, 0};
        const double sum = -0.5 * (q.b + std::copysign(std::sqrt(square), q.b));
        const double one = sum / q.c, other = q.a / sum;
        range = {std::min(one, other), std::max(one, other)};
    } else if (!(q.a > 0)) {
        return {1, 0};
    }
    if (f.kind == Kind::hemisphere)
        return between(f, ray, 0, std::numeric_limits<double>::infinity(), range);
    if (f.kind == Kind::rod) return between(f, ray, 0, f.length, range);
    return range;
}

using FieldQuartic = std::array<double, 5>;

/// A stretch of the ray on which a field is a polynomial: strength times the square of `nearness`,
/// whose origin is a place near the middle of the field.
struct FieldStretch {
    Interval range;
    double place;
    Quadratic nearness;  ///< of s - place
    double strength;
    double greatest;          ///< maximum contribution of the field
    FieldQuartic field = {};  ///< of s - Passage::origin()

    void tell_from(double origin) {
        const auto [a, b, c] = nearness.from(origin - place);
        const double s = strength;
        field = {s * a * a, 2 * s * a * b, s * (b * b + 2 * a * c), 2 * s * b * c, s * c * c};
    }
};

std::optional<FieldStretch> stretch(const Source& f, const Ray& ray) {
    Ray local = f.transform ? f.transform->inverse_ray(ray) : ray;
    const Vec3 middle = f.centre + 0.5 * f.length * f.axis;
    const double place =
        dot(middle - local.origin, local.direction) / dot(local.direction, local.direction);
    local.origin = local.at(place);
    const Quadratic q = nearness(f, local);
    const Interval range = reach(f, local, q);
    if (!(range.min < range.max) || !std::isfinite(range.min) || !std::isfinite(range.max))
        return std::nullopt;
    const double nearest = q.c < 0 ? q.a - q.b * q.b / (4 * q.c) : q.a;
    return FieldStretch{{range.min + place, range.max + place},
                        place,
                        q,
                        f.strength,
                        std::fmax(0, f.strength * nearest * nearest)};
}

/// A point relative to a source: its offset from the centre or axis, and 1 - d^2 / radius^2. Points
/// outside of the field have none.
struct Seen {
    Vec3 off;
    double nearness;
};

std::optional<Seen> seen(const Source& f, const Vec3& point) {
    const Vec3 p = f.transform ? f.transform->inverse_point(point) : point;
    Vec3 off = p - f.centre;
    const double along = dot(off, f.axis);
    if (f.kind == Kind::rod && !(along >= 0 && along < f.length)) return std::nullopt;
    if (f.kind == Kind::hemisphere && along < 0) return std::nullopt;
    if (f.kind == Kind::rod) off -= along * f.axis;
    const double nearness = 1 - dot(off, off) / f.radius2;
    return nearness > 0 ? std::optional(Seen{off, nearness}) : std::nullopt;
}

/// Gradient of the sum of all fields.
Vec3 gradient(const BuiltBlob& blob, const Vec3& point) {
    Vec3 sum(0);
    blob.index.around(point, [&](std::uint32_t i) {
        const Source& f = blob.sources[i];
        const auto met = seen(f, point);
        if (!met) return;
        const Vec3 slope = -4 * f.strength * met->nearness / f.radius2 * met->off;
        sum += f.transform ? f.transform->normal(slope) : slope;
    });
    return sum;
}

/// The fields that a ray passes, and those of them that cover a place which moves along it.
class Passage {
public:
    void add(const FieldStretch& stretch) { stretches_.push_back(stretch); }

    /// Ends of the stretches, in order. Ends that differ by at most `same` differ only by rounding,
    /// such as the end of a rod and of the ball there.
    ShortList<double, 64> ends(double same) const {
        ShortList<double, 64> ends;
        for (const FieldStretch& each : stretches_)
            ends.insert(ends.end(), {each.range.min, each.range.max});
        std::sort(ends.begin(), ends.end());
        ends.erase(std::unique(ends.begin(), ends.end(),
                               [&](double a, double b) { return b - a <= same; }),
                   ends.end());
        return ends;
    }

    /// Called before the place moves.
    void begin() {
        sort_stably(stretches_, {}, [](const FieldStretch& s) { return s.range.min; });
    }

    /// Moves the place forwards, never back. The origin of the polynomials is kept while it is
    /// near: fourth powers of distant places would leave no digits.
    void move_to(double place) {
        const auto passed = [&](std::uint32_t i) { return stretches_[i].range.max < place; };
        here_.erase(std::remove_if(here_.begin(), here_.end(), passed), here_.end());
        std::size_t known = here_.size();
        for (; next_ < stretches_.size() && stretches_[next_].range.min <= place; ++next_)
            if (stretches_[next_].range.max >= place) here_.push_back(next_);
        double steepest = 0;
        for (const std::uint32_t i : here_)
            steepest = std::max(steepest, -stretches_[i].nearness.c);
        constexpr double radii = 8;
        if (const double away = place - origin_; !(away * away * steepest <= radii * radii)) {
            origin_ = place;
            known = 0;
        }
        for (std::size_t i = known; i < here_.size(); ++i) stretches_[here_[i]].tell_from(origin_);
    }
    double origin() const { return origin_; }
    /// Number of fields that cover the place.
    std::uint32_t size() const { return static_cast<std::uint32_t>(here_.size()); }

    /// Upper bound of the sum of the fields at the place.
    double greatest() const {
        double sum = 0;
        for (const std::uint32_t i : here_) sum += stretches_[i].greatest;
        return sum;
    }

    /// The sum of the fields at the place minus the threshold, as a function of s - origin().
    FieldQuartic sum(double threshold) const {
        FieldQuartic sum{-threshold, 0, 0, 0, 0};
        for (const std::uint32_t each : here_)
            for (std::size_t i = 0; i < 5; ++i) sum[i] += stretches_[each].field[i];
        return sum;
    }

private:
    ShortList<FieldStretch, 32> stretches_;
    ShortList<std::uint32_t, 32> here_;
    std::uint32_t next_ = 0;  ///< the first stretch that the place has not reached
    double origin_ = 0;
};

enum class ComponentsWanted { all, nearest };

/// Finds the crossings in the range, or the nearest of them, and possibly others.
void search(const BuiltBlob& blob, const Ray& ray, const Interval& wanted, ComponentsWanted how,
            Crossings& found) {
    const double speed = length(ray.direction);
    if (!(speed > 0) || blob.sources.empty()) return;
    // Computed from the point nearest to the middle, so that a distant origin loses no digits.
    const Vec3 u = ray.direction / speed;
    const double start = dot(blob.index.bounds().centre() - ray.origin, u);
    const Ray near{ray.origin + start * u, u};
    const auto parameter = [&](double s) { return (start + s) / speed; };
    Passage passage;
    blob.index.along(near, {wanted.min * speed - start, whole_line.max}, [&](std::uint32_t i) {
        if (const auto met = stretch(blob.sources[i], near)) passage.add(*met);
    });
    passage.begin();
    const auto ends = passage.ends(1e-12 * length(blob.index.bounds().size()));
    // The sum is continuous: its value at the end of a stretch is that at the start of the next
    // one.
    std::optional<double> before;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const Interval range{ends[i], ends[i + 1]};
        if (parameter(range.min) >= wanted.max) return;
        const std::optional<double> known = std::exchange(before, std::nullopt);
        if (parameter(range.max) <= wanted.min) continue;
        passage.move_to(0.5 * (range.min + range.max));
        count_work(passage.size());
        if (passage.greatest() <= blob.threshold) continue;
        const FieldQuartic sum = passage.sum(blob.threshold);
        const double origin = passage.origin();
        const Interval around{range.min - origin, range.max - origin};
        const double at_start = known ? *known : polynomial(sum, around.min);
        before = i + 2 == ends.size() ? -blob.threshold : polynomial(sum, around.max);
        bool met = false;
        for (const double s : sign_changes(sum, around, at_start, *before)) {
            const double t = parameter(origin + s);
            if (!wanted.contains(t)) continue;
            const Vec3 normal = unit(-gradient(blob, near.at(origin + s)));
            if (normal == Vec3(0)) continue;
            found.add({t, normal, dot(u, normal) < 0});
            met = true;
        }
        if (met && how == ComponentsWanted::nearest) return;
    }
}

}  // namespace

BuiltBlob build(const Blob& blob, const RayIndex& index) {
    BuiltBlob result;
    result.threshold = blob.threshold;
    const auto add = [&](const Source& field) {
        if (field.strength != 0 && field.radius2 != 0) result.sources.push_back(field);
    };
    for (const BlobSphere& s : blob.spheres)
        add({Kind::ball, s.centre, Vec3(0), 0, s.radius * s.radius, s.strength, handle(s.transform),
             s.look});
    for (const BlobComponent& c : blob.components)
        add({Kind::ball, c.centre, Vec3(0), 0, c.radius * c.radius, c.strength, {}, -1});
    for (const BlobCylinder& c : blob.cylinders) {
        const double length = candelabra::length(c.cap - c.base), radius2 = c.radius * c.radius;
        const Vec3 axis = unit(c.cap - c.base);
        const Handle<Transform> place = handle(c.transform);
        if (!(length > 0)) {
            add({Kind::ball, c.base, Vec3(0), 0, radius2, c.strength, place, c.look});
            continue;
        }
        add({Kind::rod, c.base, axis, length, radius2, c.strength, place, c.look});
        add({Kind::hemisphere, c.base, -axis, 0, radius2, c.strength, place, c.look});
        add({Kind::hemisphere, c.cap, axis, 0, radius2, c.strength, place, c.look});
    }
    std::vector<Box> boxes;
    for (const Source& field : result.sources) boxes.push_back(bounds(field));
    result.index = PartIndex(std::move(boxes), index);
    return result;
}

std::string problem(const Blob& blob) {
    return blob.spheres.empty() && blob.cylinders.empty() && blob.components.empty()
               ? "a `blob` needs a component"
               : "";
}

std::string vanishes(const Blob& blob) {
    const auto seen = [](const auto& each) { return each.strength > 0 && each.radius > 0; };
    return std::ranges::any_of(blob.spheres, seen) || std::ranges::any_of(blob.cylinders, seen) ||
                   std::ranges::any_of(blob.components, seen)
               ? ""
               : "no component has a radius and a strength above 0";
}

Box bounds(const BuiltBlob& blob) { return blob.index.bounds(); }

void crossings(const BuiltBlob& blob, const Ray& ray, Crossings& found) {
    search(blob, ray, whole_line, ComponentsWanted::all, found);
}

void crossings_between(const BuiltBlob& blob, const Ray& ray, const Interval& range,
                       Crossings& found) {
    search(blob, ray, range, ComponentsWanted::all, found);
}

void nearest_crossings(const BuiltBlob& blob, const Ray& ray, const Interval& range,
                       Crossings& found) {
    search(blob, ray, range, ComponentsWanted::nearest, found);
}

double strength_at(const Source& source, const Vec3& point) {
    const auto met = seen(source, point);
    return met ? source.strength * met->nearness * met->nearness : 0;
}

bool inside(const BuiltBlob& blob, const Vec3& point) {
    double sum = 0;
    blob.index.around(point, [&](std::uint32_t i) {
        count_work(1);
        sum += strength_at(blob.sources[i], point);
    });
    return sum > blob.threshold;
}

}  // namespace candelabra
