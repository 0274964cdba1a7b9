// SPDX-License-Identifier: GPL-3.0-or-later
// A declaration without a name
#version 3.7;
#local = 3;
