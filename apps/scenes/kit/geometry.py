"""Functions that add faces to a Part, and a Part that becomes a Blender object.

Lengths in metres, Blender's axes (Z up). Everything is computed in a fixed order, so that the exported
file has the same bytes every time.
"""

import math

import bpy
from mathutils import Vector


class Part:
    """Vertices and faces of a mesh; every face has the index of its material."""

    def __init__(self, *materials):
        self.materials = materials
        self.vertices = []
        self.faces = []
        self.slots = []

    def face(self, points, slot=0):
        start, points = len(self.vertices), list(points)
        self.vertices.extend(tuple(p) for p in points)
        self.faces.append(tuple(range(start, start + len(points))))
        self.slots.append(slot)

    def grid(self, rows, slot=0, closed=False):
        """Quads between successive rows of points, sharing vertices so that they can shade smoothly."""
        start, width = len(self.vertices), len(rows[0])
        for row in rows:
            self.vertices.extend(tuple(p) for p in row)
        for r in range(len(rows) - 1):
            for c in range(width if closed else width - 1):
                a, b = start + r * width + c, start + r * width + (c + 1) % width
                self.faces.append((a, b, b + width, a + width))
                self.slots.append(slot)

    def mesh(self, name, smooth_below=None, grain=None, turned=False):
        """`smooth_below`: degrees between faces up to which an edge shades smoothly; None: flat.
        `grain`: metres that one repeat of the material's texture covers; None: no texture coordinates.
        `turned`: the grain runs round the vertical axis instead of straight at each face.
        """
        mesh = bpy.data.meshes.new(name)
        mesh.from_pydata(self.vertices, [], self.faces)
        for material in self.materials:
            mesh.materials.append(material)
        mesh.polygons.foreach_set("material_index", self.slots)
        if smooth_below is not None:
            mesh.polygons.foreach_set("use_smooth", [True] * len(self.faces))
            mesh.use_auto_smooth = True
            mesh.auto_smooth_angle = math.radians(smooth_below)
        mesh.update()
        if grain is not None:
            layer = mesh.uv_layers.new(name="Grain")
            for polygon in mesh.polygons:
                corners = [mesh.vertices[v].co for v in polygon.vertices]
                lift = around if turned and abs(polygon.normal.z) < 0.9 else straight
                for loop, (u, v) in zip(polygon.loop_indices, lift(corners, polygon.normal)):
                    layer.data[loop].uv = (u / grain, v / grain)
        return mesh

    def place(self, name, smooth_below=None, grain=None):
        return place(name, self.mesh(name, smooth_below, grain))


def straight(corners, normal):
    """Metres across and up a face, seen along the axis that it faces most."""
    axis = max(range(3), key=lambda i: abs(normal[i]))
    a, b = ((1, 2), (0, 2), (0, 1))[axis]
    return [(c[a], c[b]) for c in corners]


def around(corners, _):
    """Metres round a column 0.4 m thick, and up it."""
    angles = [math.atan2(c.y, c.x) for c in corners]
    if max(angles) - min(angles) > math.pi:  # the face lies across the seam
        angles = [a + 2 * math.pi if a < 0 else a for a in angles]
    return [(0.4 * a, c.z) for a, c in zip(angles, corners)]


def place(name, data, location=(0, 0, 0), rotation=(0, 0, 0)):
    item = bpy.data.objects.new(name, data)
    item.location = location
    item.rotation_euler = rotation
    bpy.context.scene.collection.objects.link(item)
    return item


def box(part, low, high, slot=0):
    (x0, y0, z0), (x1, y1, z1) = low, high
    for face in (((x0, y0, z0), (x0, y1, z0), (x1, y1, z0), (x1, y0, z0)),
                 ((x0, y0, z1), (x1, y0, z1), (x1, y1, z1), (x0, y1, z1)),
                 ((x0, y0, z0), (x1, y0, z0), (x1, y0, z1), (x0, y0, z1)),
                 ((x0, y1, z0), (x0, y1, z1), (x1, y1, z1), (x1, y1, z0)),
                 ((x0, y0, z0), (x0, y0, z1), (x0, y1, z1), (x0, y1, z0)),
                 ((x1, y0, z0), (x1, y1, z0), (x1, y1, z1), (x1, y0, z1))):
        part.face(face, slot)


def tile(part, origin, across, up, size, bevel, slot=0):
    """A stone that projects by `bevel`: a face and four chamfers. `across` x `up` points outwards."""
    origin, across, up = Vector(origin), Vector(across), Vector(up)
    out = across.cross(up)
    w, h = size
    low = [origin + across * x + up * y for x, y in ((0, 0), (w, 0), (w, h), (0, h))]
    high = [origin + across * x + up * y + out * bevel
            for x, y in ((bevel, bevel), (w - bevel, bevel), (w - bevel, h - bevel), (bevel, h - bevel))]
    part.face(high, slot)
    for i in range(4):
        j = (i + 1) % 4
        part.face((low[i], low[j], high[j], high[i]), slot)


def lathe(part, profile, segments, centre=(0, 0), slot=0):
    """Turns (radius, height) pairs, listed from the bottom up, about the vertical through `centre`."""
    cx, cy = centre
    rows = []
    for radius, z in profile:
        angles = [2 * math.pi * i / segments for i in range(segments)]
        rows.append([(cx + radius * math.cos(a), cy + radius * math.sin(a), z) for a in angles])
    part.grid(rows, slot, closed=True)


def rod(part, a, b, radius_a, radius_b, sides, slot=0):
    """A straight rod or taper from `a` to `b`, open at its ends."""
    a, b = Vector(a), Vector(b)
    axis = (b - a).normalized()
    side = axis.orthogonal().normalized()
    up = axis.cross(side)
    turn = [(math.cos(2 * math.pi * i / sides), math.sin(2 * math.pi * i / sides)) for i in range(sides)]
    part.grid([[p + (side * c + up * s) * r for c, s in turn] for p, r in ((a, radius_a), (b, radius_b))], slot,
              closed=True)


def arch(half_width, offset, steps):
    """Points (u, rise) of an arch over [-half_width, half_width], struck from two centres `offset` beyond the
    middle: 0 is round, half_width is the equilateral pointed arch."""
    radius = half_width + offset
    points = []
    for i in range(2 * steps + 1):
        u = -half_width * math.cos(math.pi * i / (2 * steps))  # closer together where the arch is steep
        points.append((u, math.sqrt(max(0.0, radius * radius - (abs(u) + offset) ** 2))))
    return points


def pierced_wall(part, x_range, y_range, z_range, openings, slot=0, reveal_slot=0):
    """A wall in the plane of y and z with arched openings: (centre, sill, spring, arch points)."""
    (x0, x1), (y0, y1), (z0, z1) = x_range, y_range, z_range

    def panel(ya, yb, za, zb, zc, zd):
        """Both faces of the quad (ya, za) (yb, zb) (yb, zc) (ya, zd)."""
        part.face(((x1, ya, za), (x1, yb, zb), (x1, yb, zc), (x1, ya, zd)), slot)
        part.face(((x0, yb, zb), (x0, ya, za), (x0, ya, zd), (x0, yb, zc)), slot)

    at = y0
    for centre, sill, spring, points in openings:
        left, right = centre + points[0][0], centre + points[-1][0]
        panel(at, left, z0, z0, z1, z1)
        at = right
        if sill > z0:
            panel(left, right, z0, z0, sill, sill)
            part.face(((x1, left, sill), (x1, right, sill), (x0, right, sill), (x0, left, sill)), reveal_slot)
        if spring > sill:
            part.face(((x1, left, sill), (x0, left, sill), (x0, left, spring), (x1, left, spring)), reveal_slot)
            part.face(((x0, right, sill), (x1, right, sill), (x1, right, spring), (x0, right, spring)), reveal_slot)
        rows = []
        for (ua, ra), (ub, rb) in zip(points, points[1:]):
            panel(centre + ua, centre + ub, spring + ra, spring + rb, z1, z1)
        for u, r in points:
            rows.append([(x1, centre + u, spring + r), (x0, centre + u, spring + r)])
        part.grid(rows, reveal_slot)
    panel(at, y1, z0, z0, z1, z1)


def bar(part, path, width, depth, x, chamfer, closed=False, slot=0):
    """A chamfered bar along `path`, points (y, z) in the plane `x`: window tracery."""
    w, d, c = width / 2, depth / 2, chamfer
    section = [(-w, -d + c), (-w, d - c), (-w + c, d), (w - c, d), (w, d - c), (w, -d + c), (w - c, -d), (-w + c, -d)]
    count = len(path)
    rows = []
    for i, (y, z) in enumerate(path):
        before = path[i - 1] if i > 0 or closed else path[i]
        after = path[(i + 1) % count] if i < count - 1 or closed else path[i]
        dy, dz = after[0] - before[0], after[1] - before[1]
        length = math.hypot(dy, dz)
        ny, nz = dz / length, -dy / length
        rows.append([(x + sx, y + ny * sn, z + nz * sn) for sn, sx in section])
    if closed:
        rows.append(rows[0])
    part.grid(rows, slot, closed=True)
