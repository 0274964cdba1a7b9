// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/shrink.h"

#include "proof/changes.h"

#include <algorithm>
#include <array>
#include <regex>

namespace candelabra::proof {

namespace {

using Broken = std::function<bool(const Script&)>;
/// A list of elements: those of the script, or the inner ones of an element, reached by numbers.
using Path = std::vector<std::size_t>;

Element& at(Script& script, const Path& path) {
    Element* element = &script.elements[path.front()];
    for (std::size_t i = 1; i < path.size(); ++i) element = &element->inner[path[i]];
    return *element;
}

std::vector<Element>& around(Script& script, const Path& path) {
    if (path.size() == 1) return script.elements;
    return at(script, Path(path.begin(), path.end() - 1)).inner;
}

void paths_below(const std::vector<Element>& elements, const Path& before, std::vector<Path>& all) {
    for (std::size_t i = 0; i < elements.size(); ++i) {
        Path path = before;
        path.push_back(i);
        all.push_back(path);
        paths_below(elements[i].inner, path, all);
    }
}

/// Larger elements first, and the last of them first, so that paths stay valid.
std::vector<Path> paths_of(const Script& script) {
    std::vector<Path> all;
    paths_below(script.elements, {}, all);
    std::ranges::reverse(all);
    std::ranges::stable_sort(all, {}, [](const Path& path) { return path.size(); });
    return all;
}

/// Simpler values, each of which is tried in the place of what an expression finds.
struct Simpler {
    const char* expression;
    const char* by;
};
constexpr auto simpler_values = std::to_array<Simpler>({
    {R"(rgb <[^>]*> (filter|transmit) [0-9.]+)", "rgb 1 $1 0.5"},
    {R"(rgb <[^>]*>)", "rgb 1"},
    {R"( (translate|rotate|scale) (<[^>]*>|[0-9.-]+(\*[xyz])?))", ""},
    {R"( clipped_by \{ [^{}]*(\{[^{}]*\})?[^{}]*\})", ""},
    {R"( (phong|specular|roughness|reflection|absorption) [0-9.]+)", ""},
});

class Shrinker {
public:
    Shrinker(Script script, const Broken& broken) : script_(std::move(script)), broken_(broken) {}

    Script shrink() {
        drop_options();
        while (pass()) {
        }
        return script_;
    }

private:
    bool keep(const Script& smaller) {
        if (smaller == script_ || !broken_(smaller)) return false;
        script_ = smaller;
        return true;
    }

    void drop_options() {
        for (std::size_t i = script_.options.size(); i-- > 0;) {
            Script smaller = script_;
            smaller.options.erase(smaller.options.begin() + static_cast<std::ptrdiff_t>(i));
            keep(smaller);
        }
    }

    bool pass() {
        bool changed = false;
        for (const Path& path : paths_of(script_)) changed |= leave_out(path);
        for (const Path& path : paths_of(script_))
            if (there(path)) changed |= lift(path) || simplify(path);
        return changed;
    }

    /// Whether earlier steps have left the element in its place.
    bool there(const Path& path) const {
        const std::vector<Element>* list = &script_.elements;
        for (const std::size_t i : path) {
            if (i >= list->size()) return false;
            list = &(*list)[i].inner;
        }
        return true;
    }

    bool leave_out(const Path& path) {
        if (!there(path)) return false;
        Script smaller = script_;
        if (at(smaller, path).needed) return false;
        auto& list = around(smaller, path);
        list.erase(list.begin() + static_cast<std::ptrdiff_t>(path.back()));
        return keep(smaller);
    }

    /// Puts an object in the place of the combination around it.
    bool lift(const Path& path) {
        Script smaller = script_;
        Element& whole = at(smaller, path);
        if (!is_object(whole)) return false;
        const auto part = std::ranges::find_if(whole.inner, is_object);
        if (part == whole.inner.end()) return false;
        Element alone = *part;
        whole.inner.erase(part);
        for (Element& each : whole.inner)
            if (!is_object(each)) alone.inner.push_back(std::move(each));
        if (whole.light >= 0) alone.light = whole.light;
        alone.needed = whole.needed;
        whole = alone;
        return keep(smaller);
    }

    bool simplify(const Path& path) {
        bool changed = false;
        for (const Simpler& each : simpler_values) {
            Script smaller = script_;
            Element& element = at(smaller, path);
            element.values =
                std::regex_replace(element.values, std::regex(each.expression), each.by);
            changed |= keep(smaller);
        }
        Script smaller = script_;
        Element& element = at(smaller, path);
        if (path.size() == 1 && is_object(element) && element.values != "0, 0.7" &&
            element.head != "plane" && element.head != "light_source" &&
            element.values.find("pigment") == std::string::npos) {
            element.head = "sphere";
            element.values = "0, 0.7";
            changed |= keep(smaller);
        }
        if (element.head == "pigment") {
            Script plain = script_;
            at(plain, path) = block("pigment", "rgb 1");
            changed |= keep(plain);
        }
        return changed;
    }

    Script script_;
    const Broken& broken_;
};

}  // namespace

Script shrunk(Script script, const Broken& broken) {
    return Shrinker(std::move(script), broken).shrink();
}

}  // namespace candelabra::proof
