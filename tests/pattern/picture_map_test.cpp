// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/picture_map.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// A picture of 5 by 3 pixels.
Handle<Texels> picture() {
    constexpr auto bytes =
        std::array{121, 66,  189, 242, 33,  6,   240, 132, 119, 98,  240, 243, 203, 77,  118,
                   77,  199, 7,   32,  81,  21,  154, 15,  137, 242, 198, 218, 202, 227, 68,
                   187, 49,  18,  69,  253, 111, 132, 223, 154, 215, 197, 179, 208, 118, 172};
    Texels texels{5, 3, 3, {}, {}, {}, {}};
    for (const int byte : bytes) texels.values.push_back(static_cast<float>(byte) / 255);
    texels.measure();
    return make_handle<Texels>(std::move(texels));
}

/// Returns a picture of two indexed colours.
Handle<Texels> numbered() {
    Texels texels{2, 1, 3, {}, {}, {0, 1}, {{Rgb(0.2), 0, 0}, {Rgb(0.8), 0, 0}}};
    return make_handle<Texels>(std::move(texels));
}

template <class T>
T with(Handle<Texels> texels, int map_type = 0, int interpolate = 0) {
    T map;
    map.texels = std::move(texels);
    map.map_type = map_type;
    map.interpolate = interpolate;
    return map;
}

}  // namespace

TEST_CASE("colours of pictures agree with POV-Ray's", "[pattern]") {
    constexpr auto points =
        std::array{Vec3(.1, .2, 0), Vec3(.5, .5, 0), Vec3(.999, .001, 0), Vec3(1.37, -2.61, .4)};
    struct Case {
        ImageMap map;
        std::array<Rgb, 4> colours;
    };
    const auto image = [](int map_type, int interpolate) {
        return with<ImageMap>(picture(), map_type, interpolate);
    };
    ImageMap once = image(0, 0), repeated = image(0, 2), moved = image(0, 2);
    once.once = true;
    repeated.repeat = Vec2(2, 3);
    moved.offset = Vec2(.3, .2);
    const Case cases[] = {
        {image(0, 0),
         {Rgb{0.733333, 0.192157, 0.070588}, Rgb{0.603922, 0.058824, 0.537255},
          Rgb{0.815686, 0.462745, 0.674510}, Rgb{0.125490, 0.317647, 0.082353}}},
        {image(0, 2),
         {Rgb{0.690196, 0.250980, 0.066275}, Rgb{0.603922, 0.058824, 0.537255},
          Rgb{0.706326, 0.304850, 0.487394}, Rgb{0.314100, 0.465953, 0.324975}}},
        {image(0, 3),
         {Rgb{0.715431, 0.229451, 0.037457}, Rgb{0.603922, 0.058824, 0.537255},
          Rgb{0.739470, 0.177061, 0.528626}, Rgb{0.183456, 0.445249, 0.328177}}},
        {image(0, 4),
         {Rgb{0.720426, 0.207604, 0.073647}, Rgb{0.603922, 0.058824, 0.537255},
          Rgb{0.706322, 0.304854, 0.487407}, Rgb{0.301766, 0.464052, 0.310049}}},
        {once,
         {Rgb{0.733333, 0.192157, 0.070588}, Rgb{0.603922, 0.058824, 0.537255},
          Rgb{0.815686, 0.462745, 0.674510}, Rgb{-1}}},
        {image(1, 2),
         {Rgb{0.643264, 0.283086, 0.588827}, Rgb{0.613235, 0.419118, 0.488235},
          Rgb{0.547143, 0.834764, 0.147494}, Rgb{0.751611, 0.266379, 0.245529}}},
        {image(2, 2),
         {Rgb{0.751765, 0.378235, 0.350000}, Rgb{0.547059, 0.835294, 0.147059},
          Rgb{0.705320, 0.304063, 0.486567}, Rgb{0.541729, 0.630889, 0.140187}}},
        {image(5, 2),
         {Rgb{0.690367, 0.299008, 0.511207}, Rgb{0.652696, 0.286275, 0.573284},
          Rgb{0.652696, 0.286275, 0.573284}, Rgb{0.651220, 0.444484, 0.189185}}},
        {repeated,
         {Rgb{0.363137, 0.442549, 0.153137}, Rgb{0.547059, 0.835294, 0.147059},
          Rgb{0.708153, 0.305934, 0.486897}, Rgb{0.838447, 0.711475, 0.696878}}},
        {moved,
         {Rgb{0.709804, 0.619608, 0.698039}, Rgb{0.386667, 0.574902, 0.173725},
          Rgb{0.441437, 0.922940, 0.941082}, Rgb{0.719773, 0.272233, 0.154327}}},
    };
    for (const Case& each : cases)
        for (std::size_t i = 0; i < points.size(); ++i) {
            INFO("case " << &each - cases << " point " << i);
            const std::optional<Colour> found = colour_at(each.map, points[i]);
            REQUIRE(found.has_value() == (each.colours[i] != Rgb(-1)));
            if (found) CHECK(max_abs_component(found->rgb - each.colours[i]) < 1e-6);
        }
}

TEST_CASE("an angular probe has equal angles to z as equal lengths", "[pattern]") {
    const ImageMap flat = with<ImageMap>(picture(), 0), probe = with<ImageMap>(picture(), 7);
    const auto same = [&](const Vec3& towards, double u, double v) {
        CHECK(colour_at(probe, 3.0 * towards)->rgb == colour_at(flat, Vec3(u, v, 0))->rgb);
    };
    same(Vec3(0, 0, 1), 0.5, 0.5);
    same(Vec3(1, 0, 0), 0.75, 0.5);
    same(Vec3(0, -1, 0), 0.5, 0.25);
    same(Vec3(0.6, 0, -0.8), 0.5 + 0.5 * std::acos(-0.8) / 3.14159265358979, 0.5);
}

TEST_CASE("a picture without texels shows nothing, and no point breaks one", "[pattern]") {
    CHECK_FALSE(colour_at(ImageMap{}, Vec3(0)));
    CHECK(evaluate(ImagePattern{}, Vec3(0)) == 0);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const int map_type : {0, 1, 2, 5, 7})
        for (const int interpolate : {0, 2, 3, 4})
            for (const Vec3& point : {Vec3(0), Vec3(0, 1, 0), Vec3(-1e17), Vec3(1, 0, 0),
                                      Vec3(1e17, 1, 1e-17), Vec3(infinity), Vec3(NAN)})
                if (const auto colour =
                        colour_at(with<ImageMap>(picture(), map_type, interpolate), point))
                    CHECK(std::abs(colour->rgb.r) < 2);
}

TEST_CASE("filter and transmit are added to texels, or set in the table", "[pattern]") {
    ImageMap image = with<ImageMap>(picture());
    image.adjustments = {{true, -1, 0.25}, {false, -1, 0.5}, {false, 1, 0.75}};
    ImageMap table = image;
    table.texels = numbered();
    image.adjust();
    table.adjust();
    CHECK(colour_at(image, Vec3(0.5))->filter == 0.25);
    CHECK(colour_at(image, Vec3(0.5))->transmit == 0.5);
    CHECK(colour_at(table, Vec3(0.2))->transmit == 0.5);
    CHECK(colour_at(table, Vec3(0.7))->transmit == 0.75);
    CHECK(colour_at(table, Vec3(0.7))->filter == 0.25);
}

TEST_CASE("values are brightness or transparency", "[pattern]") {
    ImagePattern pattern = with<ImagePattern>(picture());
    const Vec3 point(0.5);
    CHECK(evaluate(pattern, point) ==
          Approx(0.297 * 154 / 255 + 0.589 * 15 / 255 + 0.114 * 137 / 255));
    pattern.use_alpha = true;
    CHECK(evaluate(pattern, point) == Approx(154 / 255.0));
    pattern.texels.edit().alpha.assign(15, 0.75F);
    CHECK(evaluate(pattern, point) == 0.25);
}

TEST_CASE("a material map counts its textures", "[pattern]") {
    MaterialMap map = with<MaterialMap>(picture());
    const auto texture_of = [&](int textures) {
        map.textures = textures;
        return evaluate(map, Vec3(0.5));
    };
    CHECK(texture_of(200) == 154);
    CHECK(texture_of(154) == 153);
    CHECK(texture_of(100) == 54);
    map.once = true;
    CHECK(evaluate(map, Vec3(5)) == 0);
    map.texels = numbered();
    CHECK(texture_of(2) == 1);
}

TEST_CASE("a material map mixes numbers of colours as POV-Ray does", "[pattern]") {
    MaterialMap map = with<MaterialMap>(
        make_handle<Texels>(Texels{2, 1, 3, {}, {}, {0, 3}, std::vector<Colour>(4)}));
    map.textures = 9;
    CHECK(evaluate(map, Vec3(0.4, 0.5, 0)) == 0);
    map.interpolate = 2;
    CHECK(evaluate(map, Vec3(0.26, 0.5, 0)) == 0);
    CHECK(evaluate(map, Vec3(0.5, 0.5, 0)) == 1);
    CHECK(evaluate(map, Vec3(0.74, 0.5, 0)) == 2);
}

TEST_CASE("bumps point away from where a picture gets brighter", "[pattern]") {
    Texels ramp{4, 4, 1, {}, {}, {}, {}};
    for (int i = 0; i < 16; ++i) ramp.values.push_back(static_cast<float>(i % 4) / 4);
    BumpMap map = with<BumpMap>(make_handle<Texels>(std::move(ramp)));
    const auto bump = bump_at(map, Vec3(0.3, 0.5, 0), 2);
    REQUIRE(bump);
    CHECK(std::abs(bump->x) > 0.1);
    CHECK(bump->y > 0.5);
    CHECK(length(*bump) == Approx(1));
    map.once = true;
    CHECK_FALSE(bump_at(map, Vec3(2), 1));
}

}  // namespace candelabra
