"""Layout of the theatre. Metres; x across the stage, y from the stalls to the backdrop, z up."""

# The stage: its floor is at z = 0, the opening towards the stalls in the plane y = 0.
OPENING_HALF, OPENING_HEIGHT = 7.0, 6.6
WALL_THICKNESS = 0.6
STAGE_HALF, STAGE_FRONT, STAGE_BACK = 11.0, -1.6, 11.6
BACKDROP = 11.0
CEILING = 10.0

# The house: lower than the stage, with the same width.
STALLS_FLOOR, STALLS_BACK = -1.1, -24.0
SEAT_ROWS = (-4.4, -5.8, -7.2, -8.6)

# Trusses hang across the stage; lamps hang below them.
TRUSSES = (1.6, 5.4, 9.2)
TRUSS_HEIGHT, TRUSS_HALF, TRUSS_SIDE = 7.3, 8.0, 0.4
LAMP_HEIGHT = TRUSS_HEIGHT - 0.55

STAIR = (0.0, 8.2)
FIGURES = ((0.0, 7.9, 0.6, 0.0), (-2.7, 4.7, 0.0, 0.7), (3.1, 4.3, 0.0, -0.6), (1.3, 2.6, 0.0, 2.6))  # x, y, z, turn
GATE = (-4.6, 7.2)
TREE = (5.0, 7.0)
