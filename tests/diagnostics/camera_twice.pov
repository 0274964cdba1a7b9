// SPDX-License-Identifier: GPL-3.0-or-later
// Two cameras
#version 3.7;
camera { location y }
camera { location z }
