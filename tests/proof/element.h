// SPDX-License-Identifier: GPL-3.0-or-later
// A scene as a tree of blocks and words. Laws change it, the shrinker leaves parts of it out, and
// written() makes its text. Two kinds of places in the text differ from writing to writing:
// `@3@` is an amount of light, which is multiplied by the factor of the light that it belongs to
// (`@3#1@`: of light 1, wherever it stands); `$no_luminaire$` and `$luminaire$` are words that say
// how a lamp is found.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra::proof {

struct Element {
    std::string head;                 ///< word before the braces; empty: there are no braces
    std::string values;               ///< what comes first in the braces, or all of it
    std::vector<Element> inner = {};  ///< further parts, in the braces
    int light = -1;                   ///< number of the light that its amounts belong to; -1: outer
    bool needed = false;              ///< what is around it has no meaning without it

    friend bool operator==(const Element&, const Element&) = default;
};

inline Element block(std::string head, std::string values, std::vector<Element> inner = {}) {
    return {std::move(head), std::move(values), std::move(inner)};
}
inline Element words(std::string text) { return {"", std::move(text)}; }
inline Element needed(Element element) {
    element.needed = true;
    return element;
}
inline Element of_light(int number, Element element) {
    element.light = number;
    return element;
}

/// A setting of the run, by its place in the vocabulary of RenderSettings.
struct RunOption {
    std::size_t field;
    double value;

    friend bool operator==(const RunOption&, const RunOption&) = default;
};

/// The elements of a scene in their order, and how many lights they have.
struct Script {
    std::vector<Element> elements;
    std::vector<RunOption> options = {};
    int lights = 0;

    friend bool operator==(const Script&, const Script&) = default;
};

/// How lamps are found by paths.
enum class Found { sampled, by_chance };

struct Writing {
    double light = 1;  ///< factor of all amounts of light
    int only = -1;     ///< the only light that is on; -1: all of them
    Found found = Found::sampled;
    /// Marks amounts and words by comments, so that script_of() makes the same elements of the text.
    bool marked = false;
};

std::string written(const Element&, const Writing& = {});
std::string written(const Script&, const Writing& = {});

/// The elements of a text; the number of its lights from the marks of its amounts.
Script script_of(std::string_view text);
/// What is wrong with the braces and strings of such a text, as a sentence; empty: nothing.
std::string trouble_with_braces(std::string_view text);

/// Whether the text of a scene, or of a part of it, contains the word.
bool mentions(const Element&, std::string_view word);
bool mentions(const Script&, std::string_view word);

/// The first element of the script with that head, which is added at the front if there is none.
Element& element_of(Script&, std::string_view head);

/// Replaces the part of an element that has this head, or adds it.
void replace_part(Element&, Element part);

/// The number with all digits that it needs.
std::string text_of(double);

}  // namespace candelabra::proof
