// SPDX-License-Identifier: GPL-3.0-or-later
// A colour whose file is not included
#version 3.7;
sphere { 0, 1 pigment { color Red } }
