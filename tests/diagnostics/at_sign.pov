// SPDX-License-Identifier: GPL-3.0-or-later
// An @
#version 3.7;
#declare A = @2;
