#!/usr/bin/env python3
"""A ray tracer in plain Python, as a student would write it: what dioptre's speed is measured against.

    plain_tracer.py SCENE.toml WIDTH HEIGHT STRIDE [-o PICTURE.ppm]

Traces every STRIDE-th pixel of a WIDTH x HEIGHT picture in each direction, one sample in the pixel's middle, and prints
{"pixels", "seconds", "scaled_seconds"}: how many pixels, the time they took, and the time that all of the picture would
take at that pace. -o writes the traced pixels alone, sRGB-encoded. Needs Python 3.11 and nothing else.

It knows all shapes of a scene file, colours, checkers (on planes; elsewhere their mean), diffuse and ambient light,
shadows (tinted by what is transparent), mirrors, and bodies in air with refraction, Fresnel's equations and absorption.
It does less than dioptre: no highlights, no cones of spots, no media in media, no pictures. A picture is replaced by a
checker of half its size on a plane and by an even colour elsewhere, a pictured sky by a gradient; any other key is
passed over.
"""

import argparse
import json
import math
import sys
import time
import tomllib

BOUNCES = 5
LEAST_WEIGHT = 1 / 512  # a ray that counts for less is not traced
EPSILON = 1e-6  # metres: a ray does not meet what it leaves
PAPER, INK = (0.50, 0.45, 0.36), (0.20, 0.19, 0.18)  # stand for a picture
PICTURED_SKY = [(0.35, 0.32, 0.30), (0.75, 0.78, 0.82), (0.22, 0.36, 0.62)]  # nadir, horizon, zenith
BLACK, WHITE = (0.0, 0.0, 0.0), (1.0, 1.0, 1.0)

# Vectors and colours are tuples of three.
def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])
def subtract(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])
def scale(a, s):
    return (a[0] * s, a[1] * s, a[2] * s)
def multiply(a, b):
    return (a[0] * b[0], a[1] * b[1], a[2] * b[2])
def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
def length(a):
    return math.sqrt(dot(a, a))
def unit(a):
    return scale(a, 1 / length(a))

# Shapes. meet(): how far along a unit direction a ray meets one first, and the outward normal there; or nothing.

class Sphere:
    def __init__(self, table):
        self.centre, self.radius = tuple(table["centre"]), table["radius"]

    def meet(self, origin, direction):
        offset = subtract(origin, self.centre)
        b = dot(offset, direction)
        discriminant = b * b - dot(offset, offset) + self.radius * self.radius
        if discriminant >= 0:
            root = math.sqrt(discriminant)
            for t in (-b - root, -b + root):
                if t > EPSILON:
                    return t, scale(add(offset, scale(direction, t)), 1 / self.radius)

class Cylinder:
    def __init__(self, table):
        self.base, self.radius, self.capped = tuple(table["base"]), table["radius"], table.get("capped", False)
        self.height = length(table["axis"])
        self.axis = unit(table["axis"])

    def meet(self, origin, direction):
        offset = subtract(origin, self.base)
        start, climb = dot(offset, self.axis), dot(direction, self.axis)
        across, sideways = subtract(offset, scale(self.axis, start)), subtract(direction, scale(self.axis, climb))
        a, b = dot(sideways, sideways), dot(across, sideways)
        hits = []
        discriminant = b * b - a * (dot(across, across) - self.radius * self.radius)
        if a > 0 and discriminant >= 0:
            root = math.sqrt(discriminant)
            for t in ((-b - root) / a, (-b + root) / a):
                if t > EPSILON and 0 <= start + t * climb <= self.height:
                    hits.append((t, scale(add(across, scale(sideways, t)), 1 / self.radius)))
        if self.capped and climb != 0:
            for level, normal in ((0.0, scale(self.axis, -1)), (self.height, self.axis)):
                t = (level - start) / climb
                if t > EPSILON and length(add(across, scale(sideways, t))) <= self.radius:
                    hits.append((t, normal))
        return min(hits, default=None)

class Flat:
    """A plane, or the part of one that holds() says; the normal is on its outer side."""
    def __init__(self, anchor, normal):
        self.anchor, self.normal = tuple(anchor), unit(normal)

    def holds(self, offset):
        return True

    def meet(self, origin, direction):
        slope = dot(direction, self.normal)
        if slope != 0:
            t = dot(subtract(self.anchor, origin), self.normal) / slope
            if t > EPSILON and self.holds(subtract(add(origin, scale(direction, t)), self.anchor)):
                return t, self.normal

class Plane(Flat):
    def __init__(self, table):
        Flat.__init__(self, table["point"], table["normal"])
        level = abs(self.normal[1]) > 0.999
        self.u = unit(cross((0.0, 0.0, -1.0) if level else (0.0, 1.0, 0.0), self.normal))
        self.v = cross(self.normal, self.u)

    def coordinates(self, point):
        offset = subtract(point, self.anchor)
        return dot(offset, self.u), dot(offset, self.v)

class Disk(Flat):
    def __init__(self, table):
        Flat.__init__(self, table["centre"], table["normal"])
        self.radius = table["radius"]

    def holds(self, offset):
        return dot(offset, offset) <= self.radius * self.radius

class Rectangle(Flat):
    def __init__(self, table):
        self.span(table["corner"], table["edge_u"], table["edge_v"])

    def span(self, corner, edge_u, edge_v):
        across = cross(edge_u, edge_v)
        Flat.__init__(self, corner, across)
        self.to_u = scale(cross(edge_v, across), 1 / dot(across, across))
        self.to_v = scale(cross(across, edge_u), 1 / dot(across, across))

    def holds(self, offset):
        return 0 <= dot(offset, self.to_u) <= 1 and 0 <= dot(offset, self.to_v) <= 1

class Triangle(Rectangle):
    def __init__(self, table):
        self.span(table["a"], subtract(table["b"], table["a"]), subtract(table["c"], table["a"]))

    def holds(self, offset):
        u, v = dot(offset, self.to_u), dot(offset, self.to_v)
        return u >= 0 and v >= 0 and u + v <= 1

SHAPES = dict(sphere=Sphere, cylinder=Cylinder, plane=Plane, disk=Disk, rectangle=Rectangle, triangle=Triangle)

def colour_of(value):
    """Linear: three numbers, or "#rrggbb" in sRGB."""
    if not isinstance(value, str):
        return tuple(value)
    encoded = [int(value[i:i + 2], 16) / 255 for i in (1, 3, 5)]
    return tuple(v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4 for v in encoded)

class Material:
    def __init__(self, table):
        self.colour = colour_of(table.get("colour", WHITE))
        self.fields = None  # of a checker: two colours and their size
        if "pattern" in table:
            first, second = (multiply(self.colour, colour_of(c)) for c in table["colours"])
            self.colour = scale(add(first, second), 0.5)
            self.fields = (first, second, table.get("size", 1.0))
        elif "image" in table:
            self.colour = multiply(self.colour, PAPER)
            self.fields = (PAPER, INK, table.get("size", 1.0) / 2)
        self.mirror, self.mirror_colour = table.get("mirror", 0.0), colour_of(table.get("mirror_colour", WHITE))
        self.transmit, self.ior = table.get("transmit", 0.0), table.get("ior", 1.0)
        self.absorption = tuple(table.get("absorption", BLACK))
        self.emission, self.light = colour_of(table.get("emission", BLACK)), table.get("light", False)

    def colour_at(self, shape, point):
        if self.fields is None or not isinstance(shape, Plane):
            return self.colour
        first, second, size = self.fields
        u, v = shape.coordinates(point)
        return first if (math.floor(u / size) + math.floor(v / size)) % 2 == 0 else second

    def kept(self, distance):
        """What is left of light after a stretch within."""
        return tuple(math.exp(-a * distance) for a in self.absorption)

class Light:
    """At a position, fading by its attenuation, or from a direction; `body` is the shape that glows, if any."""
    def __init__(self, colour, position, direction, attenuation, body=None):
        self.colour, self.position, self.direction = colour, position, direction
        self.attenuation, self.body = attenuation, body

    def seen_from(self, point):
        """Unit vector to the light, its distance, its strength there."""
        if self.position is None:
            return scale(unit(self.direction), -1), math.inf, 1.0
        offset = subtract(self.position, point)
        distance = length(offset)
        towards = scale(offset, 1 / distance)
        constant, linear, quadratic = self.attenuation
        return towards, distance, 1 / (constant + distance * (linear + distance * quadratic))

class Scene:
    def __init__(self, document):
        self.objects, self.lights, self.ambient = [], [], BLACK
        for kind, shape_class in SHAPES.items():
            for table in document.get(kind, []):
                shape = shape_class(table)
                material = Material(document.get("material", {}).get(table.get("material"), {}))
                self.objects.append((shape, material))
                if material.light:
                    fading = (0.0, 0.0, 1 / shape.radius ** 2)
                    self.lights.append(Light(material.emission, shape.centre, None, fading, shape))
        for table in document.get("light", []):
            self.ambient = add(self.ambient, colour_of(table.get("ambient", BLACK)))
            if table["kind"] != "ambient":
                self.lights.append(Light(colour_of(table.get("diffuse", WHITE)), table.get("position"),
                                         table.get("direction"), table.get("attenuation", (1.0, 0.0, 0.0))))
        sky = document.get("sky", {"colour": BLACK})
        self.sky = PICTURED_SKY if "image" in sky else sky.get("gradient", [sky.get("colour")] * 3)
        self.sky = [colour_of(colour) for colour in self.sky]

    def sky_colour(self, direction):
        share = abs(direction[1])
        return add(scale(self.sky[1], 1 - share), scale(self.sky[2] if direction[1] > 0 else self.sky[0], share))

    def light_through(self, point, towards, distance, body):
        """The share of light that arrives: dark behind what is opaque, tinted behind what is not."""
        share = WHITE
        for shape, material in self.objects:
            hit = shape.meet(point, towards) if shape is not body else None
            if hit and hit[0] < distance:
                if material.transmit == 0:
                    return BLACK
                chord = hit
                if dot(towards, hit[1]) < 0:  # from outside
                    chord = shape.meet(add(point, scale(towards, hit[0])), towards) or (0.0,)
                share = multiply(share, scale(multiply(material.colour, material.kept(chord[0])), material.transmit))
        return share

    def local_light(self, point, normal, colour):
        """What a dull surface sends back of the lights' light."""
        light_sum = self.ambient
        for light in self.lights:
            towards, distance, strength = light.seen_from(point)
            cosine = dot(normal, towards)
            if cosine > 0:
                arriving = self.light_through(point, towards, distance, light.body)
                light_sum = add(light_sum, scale(multiply(arriving, light.colour), strength * cosine))
        return multiply(colour, light_sum)

    def nearest(self, origin, direction):
        found = [(shape.meet(origin, direction), shape, material) for shape, material in self.objects]
        hits = [(*hit, shape, material) for hit, shape, material in found if hit]
        return min(hits, key=lambda hit: hit[0]) if hits else None

    def trace(self, origin, direction, bounces=BOUNCES, weight=1.0):
        """The radiance that comes back along a ray."""
        if bounces < 0 or weight < LEAST_WEIGHT:
            return BLACK
        hit = self.nearest(origin, direction)
        if hit is None:
            return self.sky_colour(direction)
        distance, normal, shape, material = hit
        point = add(origin, scale(direction, distance))
        inside = dot(direction, normal) > 0
        normal = scale(normal, -1) if inside else normal
        radiance = material.emission
        opaque = (1 - material.mirror) * (1 - material.transmit)
        if opaque > 0:
            colour = material.colour_at(shape, point)
            radiance = add(radiance, scale(self.local_light(point, normal, colour), opaque))
        cosine = -dot(direction, normal)
        mirrored = add(direction, scale(normal, 2 * cosine))
        if material.mirror > 0:
            seen = self.trace(point, mirrored, bounces - 1, weight * material.mirror)
            radiance = add(radiance, scale(multiply(seen, material.mirror_colour), material.mirror))
        passing = (1 - material.mirror) * material.transmit
        if passing > 0:
            n1, n2 = (material.ior, 1.0) if inside else (1.0, material.ior)
            share, refracted = split(direction, normal, cosine, n1, n2)
            seen = scale(self.trace(point, mirrored, bounces - 1, weight * passing * share), share)
            if refracted:
                beyond = self.trace(point, refracted, bounces - 1, weight * passing * (1 - share))
                seen = add(seen, scale(beyond, 1 - share))
            radiance = add(radiance, scale(seen, passing))
            if inside:
                radiance = multiply(radiance, material.kept(distance))
        return radiance

def split(direction, normal, cosine, n1, n2):
    """Fresnel's reflected share and Snell's refracted direction, None where all is reflected."""
    ratio = n1 / n2
    sine_squared = ratio * ratio * (1 - cosine * cosine)
    if sine_squared >= 1:
        return 1.0, None
    beyond = math.sqrt(1 - sine_squared)
    across = (n1 * cosine - n2 * beyond) / (n1 * cosine + n2 * beyond)
    along = (n1 * beyond - n2 * cosine) / (n1 * beyond + n2 * cosine)
    refracted = add(scale(direction, ratio), scale(normal, ratio * cosine - beyond))
    return (across * across + along * along) / 2, unit(refracted)

def render(scene, camera, width, height, stride):
    """Rows of colours, the top one first."""
    eye = tuple(camera.get("eye", (0.0, 1.6, 5.0)))
    forward = unit(subtract(camera.get("target", BLACK), eye))
    right = unit(cross(forward, (0.0, 1.0, 0.0)))
    up = cross(right, forward)
    half = math.tan(math.radians(camera.get("fov_y_deg", 42.0)) / 2)
    rows = []
    for y in range(stride // 2, height, stride):
        row = []
        for x in range(stride // 2, width, stride):
            across = half * (2 * (x + 0.5) - width) / height
            upwards = half * (height - 2 * (y + 0.5)) / height
            direction = unit(add(forward, add(scale(right, across), scale(up, upwards))))
            row.append(scene.trace(eye, direction))
        rows.append(row)
    return rows

def encoded(linear):
    linear = min(max(linear, 0.0), 1.0)
    return round(255 * (12.92 * linear if linear <= 0.0031308 else 1.055 * linear ** (1 / 2.4) - 0.055))

def write_ppm(path, rows):
    with open(path, "wb") as file:
        file.write(f"P6\n{len(rows[0])} {len(rows)}\n255\n".encode())
        for row in rows:
            file.write(bytes(encoded(channel) for colour in row for channel in colour))

def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene")
    for name in ("width", "height", "stride"):
        parser.add_argument(name, type=int)
    parser.add_argument("-o", dest="picture")
    options = parser.parse_args()
    if options.stride < 1 or options.stride // 2 >= min(options.width, options.height):
        parser.error("this size and stride leave no pixel")
    try:
        with open(options.scene, "rb") as file:
            document = tomllib.load(file)
        scene = Scene(document)
        start = time.perf_counter()
        rows = render(scene, document.get("camera", {}), options.width, options.height, options.stride)
        seconds = time.perf_counter() - start
        if options.picture:
            write_ppm(options.picture, rows)
    except (OSError, ValueError, KeyError) as error:
        sys.exit(f"plain_tracer.py: {options.scene}: {type(error).__name__}: {error}")
    pixels = len(rows) * len(rows[0])
    scaled_seconds = seconds * options.width * options.height / pixels
    print(json.dumps({"pixels": pixels, "seconds": seconds, "scaled_seconds": scaled_seconds}))

if __name__ == "__main__":
    main()
