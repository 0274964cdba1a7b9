sphere { 0, 1 halo { emitting } hollow }
atmosphere { type 1 }
