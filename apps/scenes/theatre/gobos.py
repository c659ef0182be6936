"""Gobos: steel and glass discs with patterns cut or etched into them, as PNG bytes by name.

Each is drawn over x, y in -1 to 1, with y up, and is dark outside the disc.
"""

import math

import numpy

from kit import textures

SIZE = 256
BLUR = 2.0  # texels: a lamp's lens is never quite in focus, and detail finer than a slice would show as hatching
DISC = 0.96


def gobo(pattern):
    """`pattern(x, y)`: transmission of the disc, a number or a colour for each point."""
    def colour_of(x, y):
        through = numpy.asarray(pattern(x, y), dtype=float)
        if through.ndim == 2:
            through = numpy.repeat(through[..., None], 3, axis=2)
        return through * (numpy.hypot(x, y) < DISC)[..., None]

    right_angle = math.pi / 2  # the plane one metre away is then two metres wide
    return textures.slide(SIZE, (right_angle, right_angle), colour_of, BLUR)


def stars(x, y):
    random = numpy.random.RandomState(7)
    sky = numpy.zeros_like(x)
    places = [(0.0, 0.05, 0.36)] + [(0.72 * math.cos(a), 0.72 * math.sin(a), 0.12 + 0.08 * random.random_sample())
                                    for a in 2 * math.pi * (numpy.arange(9) + 0.3 * random.random_sample(9)) / 9]
    for cx, cy, size in places:
        fold = math.pi / 5
        angle = numpy.arctan2(y - cy, x - cx) + math.pi / 2
        angle = numpy.abs((angle + fold) % (2 * fold) - fold)
        # A point of the star is a straight edge from its tip, at radius 1, to the notch at 0.42.
        tip, notch = numpy.array([1.0, 0.0]), 0.42 * numpy.array([math.cos(fold), math.sin(fold)])
        nx, ny = notch[1] - tip[1], tip[0] - notch[0]
        edge_radius = (nx * tip[0] + ny * tip[1]) / (nx * numpy.cos(angle) + ny * numpy.sin(angle))
        sky[numpy.hypot(x - cx, y - cy) < size * edge_radius] = 1.0
    return sky


def breakup(x, _):
    return textures.billows(x.shape[0], 5, 2, 41) > 0.25


def bars(x, _):
    return numpy.abs((x * 2.6) % 1.0 - 0.5) < 0.24


def leaves(x, y):
    random = numpy.random.RandomState(23)
    light = numpy.ones_like(x)
    for _ in range(46):
        radius, around, turn = math.sqrt(random.random_sample()), *(2 * math.pi * random.random_sample(2))
        length = 0.16 + 0.1 * random.random_sample()
        dx, dy = x - radius * math.cos(around), y - radius * math.sin(around)
        along, across = dx * math.cos(turn) + dy * math.sin(turn), dy * math.cos(turn) - dx * math.sin(turn)
        # The lens between two circles whose centres lie `shift` to either side.
        shift = 0.75 * length
        light[numpy.hypot(along, numpy.abs(across) + shift) < math.hypot(length, shift)] = 0.0
    return light


def rings(x, y):
    radius = numpy.hypot(x, y)
    spokes = numpy.cos(6 * numpy.arctan2(y, x)) > -0.75
    return (radius < 0.14) | ((numpy.abs(radius * 3.4 % 1.0 - 0.5) < 0.26) & (radius > 0.2) & spokes)


def shards(x, y):
    """Pieces of coloured glass between dark leads."""
    random = numpy.random.RandomState(3)
    seeds = random.uniform(-1, 1, (17, 2))
    glass = numpy.array([(1.0, 0.25, 0.12), (0.12, 0.35, 1.0), (1.0, 0.75, 0.2), (0.25, 0.9, 0.5), (0.8, 0.2, 0.9)])
    away = numpy.hypot(x[..., None] - seeds[:, 0], y[..., None] - seeds[:, 1])
    nearest = numpy.sort(away, axis=-1)
    return glass[away.argmin(axis=-1) % len(glass)] * (nearest[..., 1] - nearest[..., 0] > 0.06)[..., None]


def all_gobos():
    patterns = {"Stars": stars, "Breakup": breakup, "Bars": bars, "Leaves": leaves, "Rings": rings, "Shards": shards}
    return {name: gobo(pattern) for name, pattern in patterns.items()}
