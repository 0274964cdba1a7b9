// SPDX-License-Identifier: GPL-3.0-or-later
// The origin of a world's parts in the scene's text: the statement that made each light, and the
// object that each primitive belongs to. Written by flatten().
#pragma once

#include "base/handle.h"
#include "lighting/pick.h"
#include "text/span.h"
#include "world/geometry.h"
#include "world/lamp.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace candelabra {

/// Spans of the scene's text, and the lights and primitives that they made.
struct Provenance {
    /// The statements of the scene that made luminaires and lights, and the index of the statement
    /// of each.
    std::vector<Span> light_statements;
    /// The names that the scene gives to the light of each; empty: none.
    std::vector<std::string> light_names;
    std::vector<std::uint32_t> statement_of_luminaire, statement_of_light;
    /// Those of the luminaires of instances, in ascending order. They follow the other luminaires,
    /// and boxes of media follow them.
    struct PlacedLights {
        LightIndex first;
        std::uint32_t count, statement;
    };
    std::vector<PlacedLights> statement_of_placed;
    std::uint32_t statement_of_sky = 0;  ///< if the sky is a luminaire
    Span sky;                            ///< the statement that made it
    /// The index in object_spans of each primitive's object; objects are counted as the scene makes
    /// them. Both are empty unless compile() was told to remember objects.
    std::vector<std::uint32_t> object_of;
    std::vector<Span> object_spans;
    std::size_t object_count = 0;  ///< as the scene counts them

    void add_light_statement(Span statement, std::string name = {}) {
        light_statements.push_back(statement);
        light_names.push_back(std::move(name));
    }

    /// Index in light_statements.
    std::uint32_t statement_of(Lamp lamp) const {
        if (lamp.is_sky()) return statement_of_sky;
        if (lamp.is_source()) return statement_of_light[lamp.index()];
        return luminaire_statement(lamp.index());
    }
    /// The same of a luminaire.
    std::uint32_t luminaire_statement(LightIndex light) const {
        if (statement_of_placed.empty() || light < statement_of_placed.front().first)
            return statement_of_luminaire[light];
        const PlacedLights &first = statement_of_placed.front(), &last = statement_of_placed.back();
        if (light >= last.first + last.count)
            return statement_of_luminaire[light - (last.first + last.count - first.first)];
        const auto after =
            std::ranges::upper_bound(statement_of_placed, light, {}, &PlacedLights::first);
        return (after - 1)->statement;
    }
    /// The number of luminaires, with boxes of media, of each statement.
    std::vector<std::size_t> luminaires_of_statements() const {
        std::vector<std::size_t> counts(light_statements.size());
        for (const std::uint32_t statement : statement_of_luminaire) ++counts[statement];
        for (const PlacedLights& placed : statement_of_placed)
            counts[placed.statement] += placed.count;
        return counts;
    }
    /// The number of luminaires and light sources of each statement.
    std::vector<std::size_t> lights_of_statements() const {
        std::vector<std::size_t> counts = luminaires_of_statements();
        for (const std::uint32_t statement : statement_of_light) ++counts[statement];
        return counts;
    }
};

/// Numbers the statements that make lights, in the order in which they do. Light with a name has
/// one number, whichever statements make it.
class LightStatements {
public:
    /// A statement, and the name of its light; null: it has none.
    struct Statement {
        Span span;
        Handle<std::string> name;
    };

    explicit LightStatements(Provenance& provenance) : provenance_(provenance) {}

    /// Makes this the current statement; returns the one before.
    Statement begin(Span span, Handle<std::string> name = {}) {
        numbered_ = numbered_ && span == now_.span && name == now_.name;
        return std::exchange(now_, {span, std::move(name)});
    }

    const Statement& current() const { return now_; }

    /// Number of the current statement.
    std::uint32_t number() {
        if (numbered_) return last_;
        const std::uint64_t range = std::uint64_t{now_.span.first} << 32 | now_.span.last;
        const std::string name = now_.name ? *now_.name : std::string();
        const auto [found, added] = numbers_.try_emplace(
            now_.name ? Place(name, {}, 0) : Place(name, now_.span.source, range),
            static_cast<std::uint32_t>(numbers_.size()));
        if (added) provenance_.add_light_statement(now_.span, name);
        numbered_ = true;
        return last_ = found->second;
    }

private:
    using Place = std::tuple<std::string, SourceId, std::uint64_t>;

    Provenance& provenance_;
    Statement now_;
    bool numbered_ = false;
    std::uint32_t last_ = 0;
    std::map<Place, std::uint32_t> numbers_;
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
