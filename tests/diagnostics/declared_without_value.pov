// SPDX-License-Identifier: GPL-3.0-or-later
// A declaration without a value
#version 3.7;
#declare A;
