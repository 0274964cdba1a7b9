// SPDX-License-Identifier: GPL-3.0-or-later
// A scene from the days when declarations had no end
#declare Radius = 2
#declare Height = 3
#declare Paint = rgb 1
cylinder { 0, Height*y, Radius pigment { Paint } }
