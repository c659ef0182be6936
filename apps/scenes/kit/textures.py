"""Pictures as PNG bytes: drifting dust, the grain of stone and boards, and slides for lamps to project."""

import struct
import zlib

import numpy


def png(pixels):
    """8-bit RGB. Rows are stored as differences to the row above, which compresses smooth pictures well."""
    height, width, _ = pixels.shape
    rows = pixels.reshape(height, width * 3).astype(numpy.uint8)
    up = rows.copy()
    up[1:] -= rows[:-1]
    raw = b"".join(b"\x02" + row.tobytes() for row in up)

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b""))


def gradient_noise(size, cells, random):
    """Ken Perlin, "Improving Noise" (2002), on a lattice that wraps round after `cells`."""
    angles = random.random_sample((cells, cells)) * 2 * numpy.pi
    gradients = numpy.stack([numpy.cos(angles), numpy.sin(angles)], axis=-1)
    at = (numpy.arange(size) + 0.5) * cells / size
    cell = at.astype(int)
    part = at - cell
    fade = part ** 3 * (part * (part * 6 - 15) + 10)

    def corner(dy, dx):
        g = gradients[numpy.ix_((cell + dy) % cells, (cell + dx) % cells)]
        return g[..., 0] * (part - dx)[None, :] + g[..., 1] * (part - dy)[:, None]

    fx, fy = fade[None, :], fade[:, None]
    top = corner(0, 0) * (1 - fx) + corner(0, 1) * fx
    bottom = corner(1, 0) * (1 - fx) + corner(1, 1) * fx
    return top * (1 - fy) + bottom * fy


def billows(size, first_cells, octaves, seed):
    """Fractal sum of gradient noise with half the strength at twice the frequency; mean 0, deviation 1."""
    random = numpy.random.RandomState(seed)
    total = sum(gradient_noise(size, first_cells << i, random) * 0.5 ** i for i in range(octaves))
    total -= total.mean()
    return total / total.std()


def dust(size=256, contrast=0.28):
    """Two tileable maps in red and green. Each has mean sqrt(0.3): drifting over each other their product
    has mean 0.3, so that a gain of 1/0.3 keeps the brightness of the air."""
    pixels = numpy.zeros((size, size, 3))
    for channel, (cells, seed) in enumerate(((3, 11), (4, 29))):
        field = numpy.clip(numpy.sqrt(0.3) + contrast * billows(size, cells, 4, seed), 0.03, 1.0)
        for _ in range(8):  # clipping changes the mean
            field = numpy.clip(field + numpy.sqrt(0.3) - field.mean(), 0.03, 1.0)
        pixels[..., channel] = field
    return png(numpy.rint(pixels * 255))


def stone_grain(size=256):
    """Grey, tileable, a little darker than white: multiplies a stone's colour."""
    field = 0.86 + 0.05 * billows(size, 4, 3, 5) + 0.035 * billows(size, 24, 3, 17)
    steps = numpy.rint(srgb(numpy.clip(field, 0.4, 1.0)) * 63) * (255 / 63)  # 64 greys are enough and compress well
    return png(numpy.repeat(numpy.rint(steps)[..., None], 3, axis=2))


def boards(size=256, planks=8):
    """Grey planks that run up the picture, tileable: multiplies the colour of wood."""
    random = numpy.random.RandomState(31)
    at = numpy.arange(size) * planks / size
    tone = 0.82 + 0.12 * random.random_sample(planks)[at.astype(int)]
    fibre = 0.03 * random.standard_normal(size)
    gap = numpy.where(at % 1.0 < 2.2 * planks / size, 0.45, 1.0)
    row = numpy.rint(srgb(numpy.clip((tone + fibre) * gap, 0.0, 1.0)) * 63) * (255 / 63)
    return png(numpy.repeat(numpy.repeat(row[None, :, None], size, axis=0), 3, axis=2))


def srgb(linear):
    """IEC 61966-2-1."""
    bright = 1.055 * numpy.maximum(linear, 0.0031308) ** (1 / 2.4) - 0.055
    return numpy.where(linear <= 0.0031308, linear * 12.92, bright)


def soften(picture, sigma):
    """Gaussian blur by `sigma` rows and columns; edges repeat."""
    radius = int(numpy.ceil(3 * sigma))
    kernel = numpy.exp(-0.5 * (numpy.arange(-radius, radius + 1) / sigma) ** 2)
    kernel /= kernel.sum()
    for axis in (0, 1):
        size = picture.shape[axis]
        at = numpy.clip(numpy.arange(-radius, size + radius), 0, size - 1)
        wide = picture.take(at, axis=axis)
        picture = sum(k * wide.take(numpy.arange(i, i + size), axis=axis) for i, k in enumerate(kernel))
    return picture


def slide(size, fov, colour_of, blur, samples=4):
    """The slide that a lamp must project so that `colour_of(x, y)` arrives on the plane one metre before it.

    `fov`: full angles in radians; x to the lamp's right and y up, arrays; linear RGB out. Each texel is the mean
    of `samples` squared points, then the slide is blurred by `blur` texels. Row 0 is the top: the picture is
    as seen by an eye at the lamp.
    """
    fine = (numpy.arange(size * samples) + 0.5) / (size * samples) * 2 - 1
    x = fine[None, :] * numpy.tan(fov[0] / 2) * numpy.ones((size * samples, 1))
    y = -fine[:, None] * numpy.tan(fov[1] / 2) * numpy.ones((1, size * samples))
    linear = colour_of(x, y).reshape(size, samples, size, samples, 3).mean(axis=(1, 3))
    return png(numpy.rint(srgb(numpy.clip(soften(linear, blur), 0, 1)) * 255))
