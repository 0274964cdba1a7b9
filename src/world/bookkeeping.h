// SPDX-License-Identifier: GPL-3.0-or-later
// What flattening writes down beside the primitives: which statement made each light, and which
// object each primitive belongs to.
#pragma once

#include "world/world.h"

#include <array>
#include <map>
#include <utility>

/// Primitives are numbered by kind: all spheres, all triangles, all other shapes, all leaves of
/// composites.
enum class PrimitiveKind { sphere, triangle, shape, leaf };

/// A primitive by its number among those of its kind, when all of the others are known, too.
inline PrimitiveIndex primitive(const World& world, PrimitiveKind kind, std::uint32_t index) {
    const auto triangles = static_cast<PrimitiveIndex>(world.geometry.spheres.size());
    const auto shapes = static_cast<PrimitiveIndex>(triangles + world.geometry.triangles.size());
    return std::array{0u, triangles, shapes,
                      world.geometry.leaves_begin()}[static_cast<std::size_t>(kind)] +
           index;
}

/// Numbers of the statements that make lights, in the order in which they do.
class LightStatements {
public:
    explicit LightStatements(World& world) : all_(world.provenance.light_statements) {}

    void begin(Span statement) { now_ = statement; }

    /// Of the statement that is at work; they come one after the other, mostly.
    std::uint32_t number() {
        if (!all_.empty() && all_[last_] == now_) return last_;
        const std::pair<SourceId, std::uint64_t> place{now_.source,
                                                       std::uint64_t{now_.first} << 32 | now_.last};
        const auto [found, added] =
            numbers_.try_emplace(place, static_cast<std::uint32_t>(all_.size()));
        if (added) all_.push_back(now_);
        return last_ = found->second;
    }

private:
    std::vector<Span>& all_;
    Span now_;
    std::uint32_t last_ = 0;
    std::map<std::pair<SourceId, std::uint64_t>, std::uint32_t> numbers_;
};

/// Fills Provenance::object_of and Provenance::object_spans, if that is wanted.
class ObjectMemory {
public:
    ObjectMemory(World& world, bool wanted) : world_(world), wanted_(wanted) {}

    /// What is placed from now on belongs to another object.
    void begin(Span object) {
        if (wanted_) world_.provenance.object_spans.push_back(object);
    }
    void placed(PrimitiveKind kind) {
        if (wanted_)
            objects_[static_cast<std::size_t>(kind)].push_back(
                static_cast<std::uint32_t>(world_.provenance.object_spans.size() - 1));
    }
    void finish() {
        for (const auto& objects : objects_)
            world_.provenance.object_of.insert(world_.provenance.object_of.end(), objects.begin(),
                                               objects.end());
    }

private:
    World& world_;
    bool wanted_;
    std::array<std::vector<std::uint32_t>, 4> objects_;
};
