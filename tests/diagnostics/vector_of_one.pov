// SPDX-License-Identifier: GPL-3.0-or-later
// One component
#version 3.7;
#declare V = <1>;
