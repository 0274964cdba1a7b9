// SPDX-License-Identifier: GPL-3.0-or-later
// Both ends at the same place
#version 3.7;
cylinder { y, y, 1 }
