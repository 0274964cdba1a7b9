// SPDX-License-Identifier: GPL-3.0-or-later
// #undef of nothing
#version 3.7;
#undef Nothing
