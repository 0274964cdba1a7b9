// SPDX-License-Identifier: GPL-3.0-or-later
#include "console/interrupt.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("what one rendering is asked, all of them are asked", "[console]") {
    Interrupt asked = Interrupt::none;
    bool listening = false;
    SharedInterrupts shared(
        {[&] { return std::exchange(asked, Interrupt::none); }, [&](bool on) { listening = on; }});
    const Interrupts a = shared.for_one(), b = shared.for_one();
    CHECK(a.take() == Interrupt::none);

    asked = Interrupt::save;
    CHECK(b.take() == Interrupt::save);
    CHECK(a.take() == Interrupt::save);
    CHECK(a.take() == Interrupt::none);
    CHECK(b.take() == Interrupt::none);
    const Interrupts late = shared.for_one();
    CHECK(late.take() == Interrupt::none);

    asked = Interrupt::stop;
    CHECK(a.take() == Interrupt::stop);
    CHECK(b.take() == Interrupt::stop);
    CHECK(shared.for_one().take() == Interrupt::stop);

    a.listening(true);
    b.listening(true);
    a.listening(false);
    CHECK(listening);
    b.listening(false);
    CHECK_FALSE(listening);
}

TEST_CASE("where nobody can ask, nobody is asked", "[console]") {
    SharedInterrupts shared({});
    CHECK_FALSE(shared.for_one().take);
    CHECK_FALSE(shared.for_one().listening);
}

}  // namespace candelabra
