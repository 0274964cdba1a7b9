// SPDX-License-Identifier: GPL-3.0-or-later
// Takes the place of the part of GCC's library that tells a program, before it starts, which
// instructions the machine has: no more than CANDELABRA_MACHINE names are found. What is compiled
// for several instruction sets then runs as it does on an older machine; see run.sh.
#include <cpuid.h>

namespace candelabra {

namespace {

// The level of machines that came with AVX2, x86-64-v3: bits of the third word of GCC's further
// features (gcc/common/config/i386/i386-cpuinfo.h), and of CPUID leaf 7, EBX.
constexpr unsigned level2 = 1u << 0, level3 = 1u << 1, avx2_there = 1u << 5;

unsigned found() {
    unsigned a = 0, b = 0, c = 0, d = 0;
    if (!__get_cpuid_count(7, 0, &a, &b, &c, &d)) return 0;
    return (b & avx2_there) != 0 ? level2 | level3 : 0;
}

}  // namespace

extern "C" {
struct {
    unsigned vendor, type, subtype, features;
} __cpu_model;
unsigned __cpu_features2[8];

int __cpu_indicator_init() {
    __cpu_model.vendor = 1;
    __cpu_features2[2] = found() & CANDELABRA_MACHINE;
    return 0;
}
}

}  // namespace candelabra
