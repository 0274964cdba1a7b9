// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers that POV-Ray 3.7 prints for its noise, and the tables behind them.
#include "base/noise.h"

#include <catch2/catch.hpp>

#include <array>
#include <limits>

namespace candelabra {

namespace {

struct Scalar {
    Vec3 point;
    std::array<double, 3> expected;  ///< of generators 1, 2, 3
};

const std::vector<Scalar> scalars = {
    {Vec3(0, 0, 0), {0.056580500000, 0.298322439308, 0.511354305373}},
    {Vec3(0.5, 0.5, 0.5), {0.413460471250, 0.473142170266, 0.672103843553}},
    {Vec3(0.25, 0.75, 0.1), {0.278029130572, 0.406800339824, 0.501120900252}},
    {Vec3(1.3, 2.7, 3.9), {0.491745692225, 0.511490641381, 0.350162878004}},
    {Vec3(-0.3, -1.7, -2.2), {0.884209318454, 0.703741232827, 0.414354698818}},
    {Vec3(-10.5, 3.25, 0.001), {0.398091149520, 0.465613418567, 0.314580243277}},
    {Vec3(100.123, -250.456, 77.789), {0.819475896810, 0.672031189487, 0.121479067278}},
    {Vec3(5000.5, 4999.25, -5000.75), {0.163761527808, 0.350825689573, 0.249356632318}},
    {Vec3(-12345.678, 23456.789, -34567.891), {0.729937255620, 0.628170164985, 0.635193870128}},
    {Vec3(100000.3, -100000.3, 123456.7), {0.761619606522, 0.643689948965, 0.400592050680}},
    {Vec3(0.999999, 0.999999, 0.999999), {0.514321049823, 0.522549311689, 0.467183645696}},
    {Vec3(-1, -2, -3), {0.773007000000, 0.649268129935, 0.503377530506}},
    {Vec3(3, 4, 5), {0.173113500000, 0.355406807580, 0.485435055113}},
    {Vec3(-1e-07, 0.5, 0.5), {0.359933624365, 0.446921732793, 0.573330466052}},
    {Vec3(7.77, -8.88, 9.99), {0.527474894117, 0.528992798871, 0.332230363098}},
    {Vec3(1000000.25, 2000000.5, -3000000.75), {0.944160681213, 0.733108756792, 0.717537177079}},
    {Vec3(4095.5, 4096.5, -4096.5), {0.417755781250, 0.475246252868, 0.523007220751}},
    {Vec3(2.5, 0, 0), {0.494094750000, 0.512641341003, 0.566960921831}},
    {Vec3(0, 2.5, 0), {0.588952250000, 0.559107839449, 0.316623469486}},
    {Vec3(0, 0, 2.5), {0.580735500000, 0.555082816640, 0.358800023330}},
};

struct Vectors {
    Vec3 point, noise, turbulence;  ///< turbulence with lambda 2.5, omega 0.6, 4 octaves
};

const std::vector<Vectors> vectors = {
    {Vec3(0, 0, 0), Vec3(-0.443419500000, 0.361005500000, -0.459716000000),
     Vec3(-0.964880866676, 0.785547996231, -1.000342051950)},
    {Vec3(0.5, 0.5, 0.5), Vec3(-0.086539528750, -0.199517493750, 0.073615243750),
     Vec3(-0.006984221768, -0.399271537099, -0.003965105284)},
    {Vec3(0.25, 0.75, 0.1), Vec3(-0.221970869428, -0.170970374354, -0.159860571365),
     Vec3(-0.069338202914, -0.098727596111, -0.153901599434)},
    {Vec3(1.3, 2.7, 3.9), Vec3(-0.008254307775, -0.181362397166, -0.490241813996),
     Vec3(0.090522480441, -0.279831190705, -0.835298681978)},
    {Vec3(-0.3, -1.7, -2.2), Vec3(0.384209318454, -0.167066826119, -0.239655441684),
     Vec3(0.421361215112, -0.180507565446, -0.299605932827)},
    {Vec3(-10.5, 3.25, 0.001), Vec3(-0.101908850480, -0.011956961871, 0.314601338536),
     Vec3(0.083029053157, -0.241918326556, 0.268511199171)},
    {Vec3(100.123, -250.456, 77.789), Vec3(0.319475896810, 0.201120536897, 0.201278491913),
     Vec3(0.250107906768, -0.120805820276, 0.022813709966)},
    {Vec3(5000.5, 4999.25, -5000.75), Vec3(-0.336238472192, -0.163848076233, -0.114791291382),
     Vec3(-0.667734014847, -0.085345478364, -0.295814369953)},
    {Vec3(-12345.678, 23456.789, -34567.891), Vec3(0.229937255620, -0.139928465705, 0.113035931023),
     Vec3(0.475026691859, -0.250313737011, -0.150859491962)},
    {Vec3(100000.3, -100000.3, 123456.7), Vec3(0.261619606522, 0.232404593183, -0.056415863593),
     Vec3(0.507478316581, -0.359772990355, -0.309276087284)},
    {Vec3(0.999999, 0.999999, 0.999999), Vec3(0.014321049823, -0.152046968681, 0.326018186566),
     Vec3(0.275283719338, -0.035237837099, 0.269134024542)},
    {Vec3(-1, -2, -3), Vec3(0.273007000000, 0.065362000000, -0.314603000000),
     Vec3(0.488448723561, 0.105746835329, -0.737358329759)},
    {Vec3(3, 4, 5), Vec3(-0.326886500000, 0.447265000000, 0.465438500000),
     Vec3(-0.142256933987, 0.417345161585, 0.477200556642)},
};

void check_near(const Vec3& found, const Vec3& expected) {
    for (int axis = 0; axis < 3; ++axis)
        CHECK(found[axis] == Approx(expected[axis]).margin(1.1e-12).epsilon(0));
}

}  // namespace

TEST_CASE("noise is POV-Ray's for each generator", "[noise]") {
    for (const Scalar& s : scalars) {
        INFO(s.point.x << ' ' << s.point.y << ' ' << s.point.z);
        for (std::size_t i = 0; i < 3; ++i)
            CHECK(noise(s.point, noise_generator(static_cast<double>(i + 1))) ==
                  Approx(s.expected[i]).margin(1.1e-12).epsilon(0));
    }
}

TEST_CASE("vector noise and turbulence are POV-Ray's", "[noise]") {
    for (const Vectors& v : vectors) {
        INFO(v.point.x << ' ' << v.point.y << ' ' << v.point.z);
        check_near(vector_noise(v.point), v.noise);
        check_near(turbulence(v.point, {1, 0.6f, 2.5f}), v.noise);
        check_near(turbulence(v.point, {4, 0.6f, 2.5f}), v.turbulence);
    }
}

TEST_CASE("turbulence has 1 to 10 octaves", "[noise]") {
    const Vec3 p(1, 2, 3);
    CHECK(turbulence(p, {99}) == turbulence(p, {10}));
    CHECK(turbulence(p, {-1}) == turbulence(p, {1}));
    CHECK(turbulence(p, {10}) != turbulence(p, {9}));
}

TEST_CASE("scalar turbulence stretches the generators of full range", "[noise]") {
    const Vec3 p(0.3, 0.7, -0.2);
    const auto old = NoiseGenerator::original, now = NoiseGenerator::full_range;
    CHECK(scalar_turbulence(p, {1}, old) == noise(p, old));
    CHECK(scalar_turbulence(p, {1}, now) == 2 * noise(p, now) - 0.5);
    CHECK(scalar_turbulence(p, {2, 0.25f, 3}, old) == noise(p, old) + 0.25 * noise(3.0 * p, old));
    CHECK(scalar_turbulence(p, {2, 0.25f, 3}, now) ==
          2 * noise(p, now) - 0.5 + 0.25 * (2 * noise(3.0 * p, now) - 0.5));
}

TEST_CASE("noises at many frequencies are those at each", "[noise]") {
    const std::array frequencies{1.0, 2.0, 3.7, -1.0, 1e18};
    for (const Vec3& point : {Vec3(0.3, -1.7, 2.2), Vec3(1e3, 0.25, -7)})
        for (const auto generator :
             {NoiseGenerator::original, NoiseGenerator::full_range, NoiseGenerator::perlin}) {
            std::array<double, frequencies.size()> values{};
            noises(point, frequencies, generator, values.data());
            for (std::size_t i = 0; i < frequencies.size(); ++i)
                CHECK(values[i] == noise(frequencies[i] * point, generator));
        }
}

TEST_CASE("noise is between 0 and 1 and has no jumps", "[noise]") {
    for (const double number : {1.0, 2.0, 3.0})
        for (int i = 0; i < 2000; ++i) {
            const Vec3 p(i * 0.37 - 300, i * -0.21, i * 0.011);
            const double here = noise(p, noise_generator(number));
            CHECK((here >= 0 && here <= 1));
            CHECK(std::abs(noise(p + Vec3(1e-6), noise_generator(number)) - here) < 2e-5);
        }
}

TEST_CASE("points that are no points count as the origin", "[noise]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    for (const Vec3& p : {Vec3(nan, 0, 0), Vec3(0, infinite, 0), Vec3(0, 0, -1e300)}) {
        CHECK(vector_noise(p) == vector_noise(Vec3(0)));
        for (const double number : {1.0, 2.0, 3.0})
            CHECK(noise(p, noise_generator(number)) == noise(Vec3(0), noise_generator(number)));
    }
}

TEST_CASE("the number of a generator is its two lowest bits", "[noise]") {
    CHECK(noise_generator(0) == NoiseGenerator::original);
    CHECK(noise_generator(6.9) == NoiseGenerator::full_range);
    CHECK(noise_generator(-1) == NoiseGenerator::perlin);
    CHECK(noise_generator(std::numeric_limits<double>::quiet_NaN()) == NoiseGenerator::original);
}

TEST_CASE("cells have POV-Ray's hashes and random numbers", "[noise]") {
    CHECK(cell_hash(0, 0, 0) == 3687);
    CHECK(cell_hash(1, 2, 3) == 560);
    CHECK(cell_hash(-1, -2, -3) == 1676);
    CHECK(cell_hash(5000, 0, 0) == 3454);
    const auto table = random_table();
    REQUIRE(table.size() == 32768);
    const std::array<double, 4> first = {0.81472369, 0.13547700, 0.90579193, 0.83500859};
    for (std::size_t i = 0; i < first.size(); ++i) CHECK(table[i] == Approx(first[i]).margin(1e-8));
}

}  // namespace candelabra
