"""One strong spot with a gobo, three things in its beam, four cameras: the scene for measuring a
single beam. Usage: python3 make_one_lamp.py ../one_lamp.glb"""

import sys

from write_gltf import GltfScene, Shape, along

LAMP = [-4.0, 5.2, 0.5]
TARGET = [3.2, 0.4, -1.6]

scene = GltfScene("make_one_lamp.py")
grey = scene.material("floor", (0.18, 0.18, 0.19))
wall = scene.material("wall", (0.30, 0.28, 0.26))
red = scene.material("ball", (0.55, 0.10, 0.08), 0.4)
wood = scene.material("box", (0.45, 0.30, 0.16))
steel = scene.material("bars", (0.50, 0.50, 0.52), 0.3)

scene.shape("floor", Shape().quad([0, 0, 0], [9, 0, 0], [0, 0, -9]), grey)
scene.shape("back_wall", Shape().quad([0, 4, -5], [9, 0, 0], [0, 4, 0]), wall)
x, y, z = along(LAMP, TARGET, 0.40)
scene.shape("ball", Shape().sphere([x, y + 0.45, z - 0.15], 0.28), red)
x, y, z = along(LAMP, TARGET, 0.58)
scene.shape("box", Shape().box([x + 0.1, y - 0.75, z + 0.2], [0.3, 0.25, 0.3]), wood)
x, y, z = along(LAMP, TARGET, 0.70)
bars = Shape()
for i in range(5):
    bars.box([x, y + 0.5, z - 0.9 + 0.45 * i], [0.05, 1.1, 0.05])
scene.shape("bars", bars, steel)

scene.spot("spot", LAMP, TARGET, 20000.0, 18.0, 15.0, light_map="gobo_star.png")

scene.camera("side", [-0.3, 2.6, 10.0], [-0.3, 2.7, 0.0])
# Inside the beam, looking past the lamp: the beam is all around, its axis to the left.
x, y, z = along(LAMP, TARGET, 0.55)
scene.camera("in_beam", [x + 0.1, y + 0.1, z + 0.3], [-4.0, 4.5, 0.0], 70.0)
eye = [LAMP[0] - 0.10, LAMP[1] + 0.22, LAMP[2] + 0.30]
scene.camera("near_apex", eye, along(LAMP, TARGET, 0.3), 60.0)
scene.camera("three_quarter", [6.2, 4.4, 6.4], [-0.5, 2.3, -0.6], 48.0)
scene.save(sys.argv[1])
