// SPDX-License-Identifier: GPL-3.0-or-later
// The origin of a world's parts in the scene's text: the statement that made each light, and the
// object that each primitive belongs to. Written by flatten().
#pragma once

#include "text/span.h"
#include "world/geometry.h"
#include "world/lamp.h"

#include <array>
#include <map>
#include <utility>
#include <vector>

namespace candelabra {

/// Spans of the scene's text, and the lights and primitives that they made.
struct Provenance {
    /// The statements of the scene that made luminaires and lights, and the index of the statement
    /// of each.
    std::vector<Span> light_statements;
    std::vector<std::uint32_t> statement_of_luminaire, statement_of_light;
    std::uint32_t statement_of_sky = 0;  ///< if the sky is a luminaire
    Span sky;                            ///< the statement that made it
    /// The index in object_spans of each primitive's object; objects are counted as the scene makes
    /// them. Both are empty unless compile() was told to remember objects.
    std::vector<std::uint32_t> object_of;
    std::vector<Span> object_spans;
    std::size_t object_count = 0;  ///< as the scene counts them

    /// Index in light_statements.
    std::uint32_t statement_of(Lamp lamp) const {
        if (lamp.is_sky()) return statement_of_sky;
        return (lamp.is_source() ? statement_of_light : statement_of_luminaire)[lamp.index()];
    }
};

/// Numbers the statements that make lights, in the order in which they do.
class LightStatements {
public:
    explicit LightStatements(Provenance& provenance) : all_(provenance.light_statements) {}

    void begin(Span statement) { now_ = statement; }

    /// Number of the current statement. Statements mostly come one after the other.
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

/// Fills Provenance::object_of and Provenance::object_spans, if wanted.
class ObjectMemory {
public:
    ObjectMemory(Provenance& provenance, bool wanted) : provenance_(provenance), wanted_(wanted) {}

    /// Primitives placed from now on belong to this object.
    void begin(Span object) {
        if (wanted_) provenance_.object_spans.push_back(object);
    }
    void placed(PrimitiveKind kind) {
        if (wanted_)
            objects_[static_cast<std::size_t>(kind)].push_back(
                static_cast<std::uint32_t>(provenance_.object_spans.size() - 1));
    }
    void finish() {
        for (const auto& objects : objects_)
            provenance_.object_of.insert(provenance_.object_of.end(), objects.begin(),
                                         objects.end());
    }

private:
    Provenance& provenance_;
    bool wanted_;
    std::array<std::vector<std::uint32_t>, 4> objects_;
};

}  // namespace candelabra
