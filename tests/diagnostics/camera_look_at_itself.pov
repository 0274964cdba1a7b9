// SPDX-License-Identifier: GPL-3.0-or-later
// A camera that looks at itself
#version 3.7;
camera { location y look_at y }
