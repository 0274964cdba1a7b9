// SPDX-License-Identifier: GPL-3.0-or-later
// A hyphen in a name
#version 3.7;
#declare Lamp-Height = 2;
