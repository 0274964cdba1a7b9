// SPDX-License-Identifier: GPL-3.0-or-later
// A `;` between the items of a block
#version 3.7;
sphere { 0, 1;
    pigment { rgb 1 };
}
