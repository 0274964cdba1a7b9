// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/laws.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra::proof {

namespace {

/// Cameras whose angles of view depend on the lengths of `right` and `up`, as in POV-Ray: another
/// size of them is another view.
constexpr auto of_lengths = std::to_array<std::string_view>(
    {"fisheye", "ultra_wide_angle", "omnimax", "panoramic", "spherical", "cylinder"});

/// Whether a triangle stands by itself, and not in a mesh.
bool has_lone_triangle(const std::vector<Element>& elements) {
    return std::ranges::any_of(elements, [](const Element& each) {
        return each.head.ends_with("triangle") ||
               (each.head != "camera" && each.head != "mesh" && has_lone_triangle(each.inner));
    });
}

/// The script at another size, and the same view of it.
Script at_size(Script script, double factor) {
    const std::string size = text_of(factor);
    Element& camera = element_of(script, "camera");
    const std::string lens = camera.values.substr(0, camera.values.find(' '));
    const bool moves = std::ranges::count(of_lengths, lens) > 0;
    if (moves) camera = replaced(camera, "(location|look_at) (<[^>]*>)", "$1 " + size + "*$2");
    const Element moved = camera;
    script = transformed(std::move(script), "scale " + size);
    if (moves) element_of(script, "camera") = moved;
    return script;
}

}  // namespace

Claims more_light(const Script& script, Dice& dice) {
    const double factor = dice.pick<double>({1e6, 1000, 3, 1e-3, 1e-6});
    return {same_mean("light times " + text_of(factor), picture(script),
                      picture(script, {.light = factor}, 1 / factor))};
}

Claims motion(const Script& script, Dice& dice) {
    std::vector<std::string> ways = {"translate <1000, -300, 200>"};
    // As in POV-Ray, the outside of a triangle by itself is towards -x, +y or -z; and that of a
    // patch follows from its control points: a mirror changes sides.
    const bool sided = mentions(script, "interior_texture"),
               has_triangle = sided && has_lone_triangle(script.elements);
    if (!has_triangle) ways.push_back("matrix <0, 1, 0, 0, 0, 1, 1, 0, 0, 5, -3, 2>");
    // As in POV-Ray, a ray that starts in an inverse solid notices it within an upright box only.
    if (!has_triangle && !mentions(script, "inverse")) ways.push_back("rotate <30, 70, -20>");
    if (!has_triangle && (!sided || !mentions(script, "bicubic_patch")))
        ways.insert(ways.end(), {"scale <-1, 1, 1>", "scale <1, 1, -1> rotate 90*y"});
    const std::string way = dice.pick(ways);
    return {same_mean(way, picture(script), picture(transformed(script, way)))};
}

Claims other_size(const Script& script, Dice& dice) {
    // As in POV-Ray, light of sources passes clear surfaces that are within 0.001 of each other as
    // if they were one: in a smaller scene these are more.
    const bool joins = mentions(script, "light_source") &&
                       (mentions(script, "transmit") || mentions(script, "filter"));
    const double factor = joins ? dice.pick<double>({2, 1024, 1e3, 1e6})
                                : dice.pick<double>({2, 1024, 1.0 / 128, 1e3, 1e6, 0.1});
    return {
        same_mean("scale " + text_of(factor), picture(script), picture(at_size(script, factor)))};
}

}  // namespace candelabra::proof
