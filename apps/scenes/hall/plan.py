"""Layout of the hall. Metres; x from the windows across the nave, y away from the camera, z up."""

from kit.geometry import arch

# Windows pierce the wall at WINDOW_WALL; the arcade divides the aisle behind it from the nave.
WINDOW_WALL = -5.0
WALL_THICKNESS = 0.7
ARCADE = -1.7
NAVE_WALL = 5.5
FRONT, BACK = -5.0, 17.0
HEIGHT = 9.0

WINDOWS = (3.0, 6.5, 10.0)  # centres along y
WINDOW_HALF, SILL, WINDOW_SPRING = 0.85, 1.9, 5.3
WINDOW_ARCH = arch(WINDOW_HALF, 0.5, 10)
TRACERY = WINDOW_WALL - 0.4
PANE_HEIGHT = 0.85

COLUMNS = tuple(-1.45 + 3.5 * i for i in range(-1, 5))
COLUMN_TOP = 4.4
BAY_HALF = 1.4

PORTAL = 1.7  # centre along x, in the back wall
LANTERN = (PORTAL, 14.8, 4.3)
CENSER = (0.5, 4.9, 1.8)
CENSER_HOOK = HEIGHT - 0.45  # under a beam of the ceiling
