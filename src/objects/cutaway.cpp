// SPDX-License-Identifier: GPL-3.0-or-later
#include "objects/cutaway.h"

#include "appearance/patterns.h"
#include "surface/texture_map.h"

#include <algorithm>
#include <span>

namespace candelabra {

namespace {

/// A texture and the object inside which it is visible; null: everywhere.
struct Source {
    Handle<Texture> texture;
    ObjectHandle where;
};
using Sources = std::vector<Source>;

/// Collects the textures that objects show inside.
class Collector {
public:
    Collector(const Handle<Texture>& usual, Sources& found) : usual_(usual), found_(found) {}

    /// `outside` is the transformation of the unions around the object; null: none. `where` is null
    /// if the point is known to be in the object.
    void collect(const Object& object, const Handle<Transform>& outside,
                 const ObjectHandle& where) {
        if (left_ == 0) return;
        --left_;
        if (object.texture) return add(object.texture, outside, where);
        const auto* parts = std::get_if<Union>(&object.form);
        if (!parts && where) found_.push_back({usual_, where});
        if (!parts) return;
        Handle<Transform> around = outside;
        if (object.transform)
            around = outside ? make_handle<Transform>(object.transform->then(*outside))
                             : object.transform;
        for (const ObjectHandle& part : parts->children) {
            collect(*part, around,
                    cuts(*parts) ? where
                    : around     ? candelabra::transformed(part, *around)
                                 : part);
            if (parts->csg == Csg::difference) return;
        }
    }

private:
    void add(const Handle<Texture>& texture, const Handle<Transform>& outside,
             const ObjectHandle& where) {
        found_.push_back(
            {outside ? make_handle<Texture>(transformed(*texture, *outside)) : texture, where});
    }

    const Handle<Texture>& usual_;
    Sources& found_;
    /// Objects that may still be visited: each may be tested at every visible point.
    int left_ = 64;
};

Handle<Texture> patterned(Pattern pattern, TextureMap map) {
    PatternUse use;
    use.pattern = std::move(pattern);
    Texture result = *map.front().texture;
    result.below = nullptr;
    result.choice = make_handle<PatternedTexture>(std::move(use), Transform(), std::move(map));
    return make_handle<Texture>(std::move(result));
}

/// The average of the textures; null if there are none.
Handle<Texture> mean(const std::vector<Handle<Texture>>& textures) {
    if (textures.size() < 2) return textures.empty() ? nullptr : textures.front();
    TextureMap map;
    for (const Handle<Texture>& texture : textures) map.push_back({1, texture});
    return patterned(Average{}, std::move(map));
}

/// The mean of `here` and of the textures of those sources that contain a point.
Handle<Texture> mixed(std::span<const Source> sources, std::vector<Handle<Texture>> here) {
    constexpr std::size_t max_together = 4;
    if (sources.empty()) return mean(here);
    const Source& first = sources.front();
    std::vector<Handle<Texture>> with = here;
    with.push_back(first.texture);
    if (!first.where) return mixed(sources.subspan(1), std::move(with));
    Handle<Texture> outside = mixed(sources.subspan(1), std::move(here));
    Handle<Texture> inside =
        sources.size() > max_together ? mean(with) : mixed(sources.subspan(1), std::move(with));
    if (!outside) return inside;
    return patterned(object_pattern(*first.where), {{0, outside}, {1, inside}});
}

/// Bounds the recursion, because each level copies its objects.
constexpr std::uint32_t max_nested = 8;

/// Cuts away within a part that has no texture. Unions and merges pass on what the cuts in them
/// leave open.
void cut_within(ObjectHandle& part, const Handle<Texture>& usual) {
    const auto* parts = std::get_if<Union>(&part->form);
    if (!parts || part->texture || part->depth >= max_nested) return;
    Union& own = std::get<Union>(part.edit().form);
    if (cuts(own)) return cut_away(own, usual);
    for (ObjectHandle& each : own.children) cut_within(each, usual);
}

}  // namespace

void cut_away(Union& whole, const Handle<Texture>& usual) {
    std::vector<Handle<Texture>> shown(whole.children.size());
    for (std::size_t i = 0; i < shown.size(); ++i) {
        if (whole.children[i]->texture) continue;
        cut_within(whole.children[i], usual);
        Sources sources;
        Collector collector(usual, sources);
        for (std::size_t j = 0; j < shown.size(); ++j) {
            const bool counts = whole.csg == Csg::difference ? j == 0 : true;
            if (counts && j != i) collector.collect(*whole.children[j], nullptr, nullptr);
        }
        // Sources that are always visible come first, which leaves fewer tests.
        std::stable_partition(sources.begin(), sources.end(),
                              [](const Source& each) { return !each.where; });
        shown[i] = mixed(sources, {});
    }
    for (std::size_t i = 0; i < shown.size(); ++i)
        if (shown[i]) whole.children[i].edit().texture = shown[i];
}

}  // namespace candelabra
