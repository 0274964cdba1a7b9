def Ball(R):
    sphere { 0, R }
Ball(3)
