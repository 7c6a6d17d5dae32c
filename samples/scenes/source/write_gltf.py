"""Small glTF scenes written out plainly: shapes, spots and cameras into one .glb. The same calls
give the same bytes on every machine; needs nothing but Python itself. Not an exporter: what the
measuring scenes beside it use, and no more."""

import json
import math
import struct

FLOAT = 5126
UINT = 5125


def subtract(a, b):
    return [p - q for p, q in zip(a, b)]


def along(a, b, share):
    """The point that lies `share` of the way from a to b."""
    return [p + share * (q - p) for p, q in zip(a, b)]


def cross(a, b):
    return [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]


def unit(a):
    length = math.sqrt(sum(p * p for p in a))
    return [p / length for p in a]


def look_at(position, target, up=(0.0, 1.0, 0.0)):
    """The matrix, column by column, of what stands at `position` and looks at `target` along -Z."""
    back = unit(subtract(position, target))
    right = unit(cross(up, back))
    above = cross(back, right)
    # Rounded so that the last digit of a platform's square root does not show.
    columns = [*right, 0.0, *above, 0.0, *back, 0.0, *position, 1.0]
    return [round(value, 9) + 0.0 for value in columns]


class Shape:
    def __init__(self):
        self.positions, self.normals, self.indices = [], [], []

    def quad(self, centre, u, v):
        """Half sides u and v; cross(u, v) is the side it faces."""
        first = len(self.positions)
        for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            self.positions.append([c + s * p + t * q for c, p, q in zip(centre, u, v)])
            self.normals.append(unit(cross(u, v)))
        self.indices += [first + i for i in (0, 1, 2, 0, 2, 3)]
        return self

    def box(self, centre, half):
        for axis in range(3):
            for side in (-1.0, 1.0):
                normal, u = [0.0] * 3, [0.0] * 3
                normal[axis], u[(axis + 1) % 3] = side, 1.0
                v = cross(normal, u)
                self.quad(
                    [c + n * h for c, n, h in zip(centre, normal, half)],
                    [p * h for p, h in zip(u, half)],
                    [p * h for p, h in zip(v, half)],
                )
        return self

    def sphere(self, centre, radius, segments=48):
        first = len(self.positions)
        rings = segments // 2
        for ring in range(rings + 1):
            polar = math.pi * ring / rings
            for s in range(segments + 1):
                around = 2.0 * math.pi * s / segments
                normal = [
                    math.sin(polar) * math.cos(around),
                    math.cos(polar),
                    -math.sin(polar) * math.sin(around),
                ]
                normal = [round(value, 9) for value in normal]
                self.normals.append(normal)
                self.positions.append([c + radius * n for c, n in zip(centre, normal)])
        for ring in range(rings):
            for s in range(segments):
                a = first + ring * (segments + 1) + s
                b = a + segments + 1
                self.indices += [a, b, b + 1, a, b + 1, a + 1]
        return self


class GltfScene:
    def __init__(self, generator):
        self.binary = bytearray()
        self.json = {
            "asset": {"version": "2.0", "generator": generator},
            "scene": 0,
            "scenes": [{"nodes": []}],
            "nodes": [],
        }

    def _append(self, kind, value):
        self.json.setdefault(kind, []).append(value)
        return len(self.json[kind]) - 1

    def _node(self, node):
        self.json["scenes"][0]["nodes"].append(self._append("nodes", node))

    def _view(self, data):
        self.binary += b"\0" * (-len(self.binary) % 4)
        view = {"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data)}
        self.binary += data
        return self._append("bufferViews", view)

    def _accessor(self, component, kind, values, **more):
        letter = "f" if component == FLOAT else "I"
        flat = [x for value in values for x in (value if isinstance(value, list) else [value])]
        view = self._view(struct.pack(f"<{len(flat)}{letter}", *flat))
        accessor = {"bufferView": view, "componentType": component, "type": kind}
        return self._append("accessors", accessor | {"count": len(values)} | more)

    def material(self, name, color, roughness=0.8):
        pbr = {"baseColorFactor": [*color, 1.0], "metallicFactor": 0.0, "roughnessFactor": roughness}
        return self._append("materials", {"name": name, "pbrMetallicRoughness": pbr})

    def shape(self, name, shape, material):
        single = [[struct.unpack("<f", struct.pack("<f", x))[0] for x in p] for p in shape.positions]
        low = [min(p[i] for p in single) for i in range(3)]
        high = [max(p[i] for p in single) for i in range(3)]
        primitive = {
            "attributes": {
                "POSITION": self._accessor(FLOAT, "VEC3", single, min=low, max=high),
                "NORMAL": self._accessor(FLOAT, "VEC3", shape.normals),
            },
            "indices": self._accessor(UINT, "SCALAR", shape.indices),
            "material": material,
        }
        mesh = self._append("meshes", {"name": name, "primitives": [primitive]})
        self._node({"name": name, "mesh": mesh})

    def image(self, name, png):
        """A PNG's bytes, put into the file; the index of a texture that shows them."""
        image = {"name": name, "mimeType": "image/png", "bufferView": self._view(png)}
        return self._append("textures", {"source": self._append("images", image)})

    def spot(self, name, position, target, candela, half_angle, inner=0.0, color=(1, 1, 1), **extras):
        """Angles in degrees; extras as the README has them (light_map, beam_shape ...)."""
        light = {
            "name": name,
            "type": "spot",
            "color": list(color),
            "intensity": candela,
            "spot": {
                "innerConeAngle": math.radians(inner),
                "outerConeAngle": math.radians(half_angle),
            },
        }
        punctual = self.json.setdefault("extensions", {}).setdefault(
            "KHR_lights_punctual", {"lights": []}
        )
        self.json["extensionsUsed"] = ["KHR_lights_punctual"]
        punctual["lights"].append(light)
        node = {
            "name": name,
            "matrix": look_at(position, target),
            "extensions": {"KHR_lights_punctual": {"light": len(punctual["lights"]) - 1}},
        }
        self._node(node | ({"extras": extras} if extras else {}))

    def camera(self, name, position, target, vertical_fov=45.0, near=0.05, far=None):
        lens = {"yfov": math.radians(vertical_fov), "znear": near}
        if far is not None:
            lens["zfar"] = far
        camera = self._append("cameras", {"name": name, "type": "perspective", "perspective": lens})
        self._node({"name": name, "camera": camera, "matrix": look_at(position, target)})

    def save(self, path):
        self.binary += b"\0" * (-len(self.binary) % 4)
        if self.binary:
            self.json["buffers"] = [{"byteLength": len(self.binary)}]
        text = json.dumps(self.json, separators=(",", ":"), sort_keys=True).encode()
        text += b" " * (-len(text) % 4)
        chunks = struct.pack("<I4s", len(text), b"JSON") + text
        if self.binary:
            chunks += struct.pack("<I4s", len(self.binary), b"BIN\0") + self.binary
        with open(path, "wb") as file:
            file.write(struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks)
