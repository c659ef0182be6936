"""Layout of the town. Metres; the street runs along y, x to its right, z up; all ground is at z = 0."""

# Across the street: carriageway, pavements, houses, gardens, and a lane behind them on either side.
KERB, FRONTS, HOUSE_DEPTH = 4.0, 7.0, 10.0
BACKS = FRONTS + HOUSE_DEPTH
LANE_INNER, LANE_OUTER = 25.0, 31.0
EDGE = 76.0

# Along it: eight houses a side, a cross street, eight more, a square with the town hall at its end.
START, END = -44.0, 262.0
HOUSE_WIDTH = 14.0
HOUSES = tuple(-33.0 + HOUSE_WIDTH * i for i in range(8)) + tuple(89.0 + HOUSE_WIDTH * i for i in range(8))
CROSSING = (72.0, 82.0)
SQUARE = (196.0, 246.0)
TOWN_HALL = 250.0

# Cars and trees under the street's lamps: (side, y). Most lamps have nothing below them.
CARS = ((-1, -20.0), (-1, 13.5), (1, 22.0), (1, 36.5), (-1, 45.0), (-1, 61.0), (1, 54.0), (1, 100.0), (-1, 124.0),
        (1, 148.0))
TREES = ((-1, 12.0), (1, 4.0), (1, 36.0), (-1, 60.0), (-1, 92.0), (1, 116.0), (1, 164.0))
CAR_LINE, TREE_LINE = 3.0, 5.2

POST_HEIGHT, POST_ARM = 5.6, 1.7  # height of a lamp's head, and its distance from the post
DOOR_LAMP = (0.35, -2.0, 2.7)  # distance from a house's front, along it, up
BACK_LAMP = (0.35, 2.5, 2.7)
SIGN = (0.75, 3.0, 3.3)  # the lower end of a sign, with its lamp
