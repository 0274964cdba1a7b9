// SPDX-License-Identifier: GPL-3.0-or-later
// An angle that does not exist
#version 3.7;
camera { angle 180 }
