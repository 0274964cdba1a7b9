// SPDX-License-Identifier: GPL-3.0-or-later
#include "objects/imported_looks.h"

#include "support/gltf.h"
#include "support/rgb.h"
#include "support/script.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <vector>

namespace candelabra {

namespace {

/// A picture of 2 by 1 pixels: linear 1, 0, 0 and 0, 0, 1.
const std::string red_and_blue = "P6 2 1 255\n" + std::string("\xff\0\0\0\0\xff", 6);

/// A picture of the tests; alpha.png has 8 by 1 pixels.
std::string content_of(const std::string& name) {
    std::ifstream file(CANDELABRA_SOURCE_DIR "/tests/conformance/pictures/" + name,
                       std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// The look of the triangle of a model with this material.
struct Looked {
    Script done;
    Texture texture;
    Handle<Interior> interior;
};

Looked look_of(const std::string& material, const std::string& more = "") {
    Looked made{run("#version 3.7; global_settings { assumed_gamma 1 } model { file \"a.gltf\" }",
                    {{"a.gltf", gltf("{\"materials\": [" + material + "]" + more + "}")},
                     {"a.ppm", red_and_blue},
                     {"alpha.png", content_of("alpha.png")}}),
                {},
                {}};
    INFO(made.done.text);
    REQUIRE(made.done.scene.objects.size() == 1);
    const Object* object = made.done.scene.objects[0].get();
    while (const auto* all = std::get_if<Union>(&object->form)) object = all->children.at(0).get();
    made.texture = *object->texture;
    made.interior = object->interior;
    return made;
}

const std::string one_picture = R"(, "textures": [{"source": 0}], "images": [{"uri": "a.ppm"}])";

}  // namespace

TEST_CASE("facets, colours and opacity of a material become a texture", "[objects]") {
    const Looked paint = look_of(R"({"alphaMode": "BLEND", "pbrMetallicRoughness": {
        "baseColorFactor": [0.5, 0.25, 0.125, 0.75], "metallicFactor": 0.5, "roughnessFactor": 0.25}})");
    CHECK(paint.done.said.empty());
    CHECK(paint.texture.pigment.colour.rgb == Rgb(0.5, 0.25, 0.125));
    CHECK(paint.texture.pigment.colour.transmit == 0.25);
    CHECK(paint.texture.finish.ambient == Rgb(0));
    CHECK(paint.texture.finish.microfacet.on);
    CHECK(paint.texture.finish.microfacet.roughness == 0.25);
    CHECK(paint.texture.finish.microfacet.metallic == 0.5);
    CHECK_FALSE(paint.interior);
}

TEST_CASE("materials that let light through have an interior", "[objects]") {
    const Looked glass = look_of(R"({"pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 0.25, 1]},
        "extensions": {"KHR_materials_transmission": {"transmissionFactor": 1}}})",
                                 R"(, "extensionsUsed": ["KHR_materials_transmission"])");
    CHECK(glass.texture.pigment.colour.filter == 1);
    REQUIRE(glass.interior);
    CHECK(glass.interior->ior == 1.5);
}

TEST_CASE("the light of a surface is its emission, whatever its colour", "[objects]") {
    const auto light = [](const std::string& colour) {
        const Looked lamp = look_of(
            R"({"emissiveFactor": [1, 0.5, 0], "pbrMetallicRoughness": {"baseColorFactor": [)" +
                colour + R"(, 1]}, "extensions": {"KHR_materials_emissive_strength": {
            "emissiveStrength": 8}}})",
            R"(, "extensionsUsed": ["KHR_materials_emissive_strength"])");
        return greatest_emission(lamp.texture);
    };
    for (const char* colour : {"1, 1, 1", "0, 0, 0", "0.5, 0, 0.25"}) {
        INFO(colour);
        CHECK(length(light(colour) - Rgb(8, 4, 0)) < 1e-12);
    }
}

TEST_CASE("pictures beside a model are multiplied with its colours", "[objects]") {
    const Looked painted = look_of(R"({"pbrMetallicRoughness": {
        "baseColorFactor": [0.5, 1, 0.25, 1], "baseColorTexture": {"index": 0}}})",
                                   one_picture);
    CHECK(painted.done.text.empty());
    REQUIRE(painted.texture.pigment.pattern);
    CHECK(painted.texture.pigment.uv);
    PatternScene place;
    CHECK(brightest(painted.texture.pigment) == Rgb(0.5, 0, 0.25));
    place.uv = {0.25, 0.5};
    const Rgb left = evaluate(painted.texture.pigment, Vec3(0), place).rgb;
    place.uv = {0.75, 0.5};
    const Rgb right = evaluate(painted.texture.pigment, Vec3(0), place).rgb;
    CHECK(left.r > right.r);
    CHECK(left.b < right.b);
}

TEST_CASE("materials that are cut out are there or not", "[objects]") {
    const auto transmit = [](const std::string& alpha) {
        return look_of(
                   "{\"alphaMode\": \"MASK\", \"alphaCutoff\": 0.4, \"pbrMetallicRoughness\": "
                   "{\"baseColorFactor\": [1, 1, 1, " +
                   alpha + "]}}")
            .texture.pigment.colour.transmit;
    };
    CHECK(transmit("0.39") == 1);
    CHECK(transmit("0.41") == 0);
}

TEST_CASE("pictures of materials that are cut out are there or not at each texel", "[objects]") {
    const auto transmits = [](const std::string& mode) {
        const Looked cut =
            look_of("{" + mode + R"("pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}})",
                    R"(, "textures": [{"source": 0}], "images": [{"uri": "alpha.png"}])");
        std::vector<double> found;
        PatternScene place;
        for (int x = 0; x < 8; ++x) {
            place.uv = {(x + 0.5) / 8, 0.5};
            found.push_back(evaluate(cut.texture.pigment, Vec3(0), place).transmit);
        }
        return found;
    };
    const auto blended = transmits(R"("alphaMode": "BLEND",)");
    const auto cut = transmits(R"("alphaMode": "MASK",)");
    CHECK(std::ranges::count_if(blended, [](double x) { return x > 0.01 && x < 0.99; }) > 0);
    for (std::size_t i = 0; i < cut.size(); ++i)
        CHECK(cut[i] == Approx(blended[i] > 0.5 ? 1 : 0).margin(1e-9));
}

TEST_CASE("pictures of light glow", "[objects]") {
    const Looked screen = look_of(R"({"emissiveFactor": [1, 1, 1], "emissiveTexture": {"index": 0},
        "pbrMetallicRoughness": {"baseColorFactor": [0, 0, 0, 1]}})",
                                  one_picture);
    CHECK(screen.done.text.empty());
    CHECK(greatest_emission(screen.texture) == Rgb(1, 0, 1));
    CHECK(varied(screen.texture));
}

TEST_CASE("pictures that are missing or broken are left out with a warning", "[objects]") {
    const std::string painted =
        R"({"pbrMetallicRoughness": {"baseColorFactor": [0.5, 1, 0.25, 1],
        "baseColorTexture": {"index": 0}}})";
    const auto warning_of = [&](const std::string& picture) {
        const Looked made = look_of(
            painted, R"(, "textures": [{"source": 0}], "images": [{"uri": ")" + picture + "\"}]");
        CHECK(made.texture.pigment.colour.rgb == Rgb(0.5, 1, 0.25));
        REQUIRE(made.done.said.size() == 1);
        CHECK(made.done.said[0].severity == Severity::warning);
        return made.done.said[0].message;
    };
    CHECK(warning_of("b.png") ==
          "the picture `b.png` of the model is not beside it, so it is left out");
    CHECK(warning_of("../a.png").find("../a.png") != std::string::npos);
    CHECK(
        warning_of("data:image/png;base64,QUJD").starts_with("a picture of the model is left out"));
}

TEST_CASE("maps of roughness and metallic count by their means", "[objects]") {
    const Looked worn = look_of(R"({"pbrMetallicRoughness": {"metallicFactor": 1,
        "roughnessFactor": 1, "metallicRoughnessTexture": {"index": 0}}})",
                                one_picture);
    CHECK(worn.texture.finish.microfacet.roughness == 0);
    CHECK(worn.texture.finish.microfacet.metallic == 0.5);
    CHECK(worn.done.text.find("count by their means") != std::string::npos);
}

}  // namespace candelabra
