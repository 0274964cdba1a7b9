difference { box { 0, 1 } mesh { triangle { 0, x, y } } }
intersection { triangle { 0, x, y } box { 0, 1 } }
difference { triangle { 0, x, y } box { 0, 1 } }
