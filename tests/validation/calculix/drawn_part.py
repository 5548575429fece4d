"""A drawn part with bores and an arch (`meshes/housing.msh`) in CalculiX, as `plane_part.py` has parts of several heights.

Shares nothing with fem but the mesh of 6-node triangles, which is read here by itself. Needs numpy and `ccx` (2.20). `python drawn_part.py`
prints how far the top sinks (um), what the supports carry and how hard they hold it along (N), which `tests/cli/mesh_file.rs` asks of fem.
"""

from pathlib import Path

import numpy as np

from plane_part import rub, solve

MESH = Path(__file__).parents[3] / "meshes/housing.msh"


def section(text, name):
    return text.split(f"${name}\n")[1].split(f"\n$End{name}")[0].splitlines()


class Drawn:
    """A mesh in the format 4.1 whose physical curves are `underside` and `top`. Lengths in mm."""

    kind = "CPS6"

    def __init__(self, path):
        text = path.read_text()
        names = {int(line.split()[1]): line.split('"')[1] for line in section(text, "PhysicalNames")[1:] if line[0] == "1"}
        entities = section(text, "Entities")
        points, curves, *_ = map(int, entities[0].split())
        self.faces = {name: [] for name in names.values()}
        group = {}
        for line in entities[1 + points : 1 + points + curves]:
            cells = line.split()
            if int(cells[7]):
                group[int(cells[0])] = names[int(cells[8])]
        places = {}
        lines = iter(section(text, "Nodes")[1:])
        for head in lines:
            count = int(head.split()[3])
            tags = [int(next(lines)) for _ in range(count)]
            for tag in tags:
                places[tag] = tuple(map(float, next(lines).split()[:2]))
        elements = []
        lines = iter(section(text, "Elements")[1:])
        for head in lines:
            dimension, entity, kind, count = map(int, head.split())
            for _ in range(count):
                nodes = list(map(int, next(lines).split()[1:]))
                if kind == 9:
                    elements.append(nodes)
                elif kind == 8 and entity in group:
                    begin, end, middle = nodes
                    side = (begin, middle, end) if places[begin][0] < places[end][0] else (end, middle, begin)
                    self.faces[group[entity]].append(side)
        used = sorted({node for own in elements for node in own})
        number = {tag: k + 1 for k, tag in enumerate(used)}
        self.nodes = {places[tag]: number[tag] for tag in used}
        self.elements = [[number[tag] for tag in own] for own in elements]
        self.faces = {
            name: [(places[a][0], places[c][0], [number[a], number[b], number[c]], places[a][1]) for a, b, c in sides]
            for name, sides in self.faces.items()
        }

    def place(self, x, y):
        return x, y

    def ends(self):
        sides = sorted(self.faces["underside"])
        return sides[0][2][0], sides[-1][2][2]

    def pad(self, at, width, on_top):
        shares = {}
        points, weights = np.polynomial.legendre.leggauss(4)
        for low, high, nodes, _ in self.faces["top" if on_top else "underside"]:
            a, b = max(low, at - width / 2), min(high, at + width / 2)
            for point, weight in zip(points, weights):
                if b <= a:
                    break
                t = (a + b + (b - a) * point - low - high) / (high - low)
                for node, shape in zip(nodes, [t * (t - 1) / 2, 1 - t * t, t * (t + 1) / 2]):
                    shares[node] = shares.get(node, 0) + weight * (b - a) / 2 * shape / width
        return shares

    def top_node(self, at):
        return next(nodes[k] for low, high, nodes, _ in self.faces["top"] for k, x in ((0, low), (2, high)) if abs(x - at) < 1e-9)


SUPPORTS = [(20, 16, 200), (215, 20, 150)]
LOADS = [(115, 16, 4000), (220, 12, 1500)]
SEEN = [0, 60, 180, 240]

if __name__ == "__main__":
    part = Drawn(MESH)
    sunk, carried = solve(part, SUPPORTS, LOADS, SEEN)
    print("sinks", ", ".join(f"{at}: {value:.6f}" for at, value in zip(SEEN, sunk)), "um")
    print("carry", ", ".join(f"{value:.4f}" for value in carried), "N")
    sunk, carried, held = rub(part, SUPPORTS, [0.15] * len(SUPPORTS), LOADS, SEEN)
    print("friction 0.15")
    print("  sinks", ", ".join(f"{at}: {value:.6f}" for at, value in zip(SEEN, sunk)), "um")
    print("  carry", ", ".join(f"{value:.4f}" for value in carried), "N")
    print("  hold", ", ".join(f"{value:.4f}" for value in held), "N")
