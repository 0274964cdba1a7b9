// SPDX-License-Identifier: GPL-3.0-or-later
// A number is wanted
#version 3.7;
#declare A = sqrt(<1, 2, 3>);
