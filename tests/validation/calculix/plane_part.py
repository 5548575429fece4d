"""Parts of several heights as plane bodies in CalculiX: pads on springs under them, with friction, pads that press on them.

Shares nothing with fem but the mesh of 8-node quadrilaterals, whose elements are as even as ends and heights of the pieces
allow. Needs numpy and `ccx` (2.20). `python plane_part.py` prints how far the top sinks (um), what the supports carry and how hard
they hold it along (N), against which `fem validate` holds its own. Friction is followed while the loads rise in 50 steps.
"""

import math
import subprocess
import tempfile
from pathlib import Path

import numpy as np

YOUNG, NU, WIDTH = 110e9, 0.26, 0.06
# CalculiX makes bricks of plane elements, whose faces at the front bend where the strain across changes from place to place. Of a thin
# plate this takes no energy, so that the part is computed thin, under forces and on springs of that share.
THIN = 1e-4
SHARE = THIN / WIDTH


def divided(stops, size):
    borders = [stops[0]]
    for low, high in zip(stops, stops[1:]):
        count = math.ceil((high - low) / size - 1e-9)
        borders += [low + (high - low) * i / count for i in range(1, count)] + [high]
    return borders


class Part:
    """Nodes by their place in half steps, elements counter-clockwise. Lengths in mm."""

    kind = "CPS8"

    def __init__(self, segments, size):
        ends = np.concatenate([[0], np.cumsum([length for length, _ in segments])]).tolist()
        levels = sorted({0, *(height for _, height in segments)})
        self.x, self.y = divided(ends, size), divided(levels, size)
        self.nodes, self.elements, self.top = {}, [], []
        for i in range(len(self.x) - 1):
            middle = (self.x[i] + self.x[i + 1]) / 2
            height = next(h for (_, h), end in zip(segments, ends[1:]) if middle < end)
            rows = sum(y < height - 1e-9 for y in self.y)
            for j in range(rows):
                a, b = 2 * i, 2 * j
                around = [(0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1)]
                self.elements.append([self.node(a + p, b + q) for p, q in around])
            self.top.append(rows)

    def node(self, i, j):
        return self.nodes.setdefault((i, j), len(self.nodes) + 1)

    def place(self, i, j):
        half = lambda borders, k: (borders[k // 2] + borders[(k + 1) // 2]) / 2
        return half(self.x, i), half(self.y, j)

    def ends(self):
        return self.node(0, 0), self.node(2 * len(self.x) - 2, 0)

    def pad(self, at, width, on_top):
        """Shares of the nodes under a pad: shape functions integrated by Gauss over what it covers of each side."""
        shares = {}
        points, weights = np.polynomial.legendre.leggauss(4)
        for i, (low, high) in enumerate(zip(self.x, self.x[1:])):
            a, b = max(low, at - width / 2), min(high, at + width / 2)
            if b <= a:
                continue
            row = 2 * self.top[i] if on_top else 0
            for point, weight in zip(points, weights):
                x = (a + b) / 2 + (b - a) / 2 * point
                t = (2 * x - low - high) / (high - low)
                shapes = [t * (t - 1) / 2, 1 - t * t, t * (t + 1) / 2]
                for k, shape in enumerate(shapes):
                    node = self.node(2 * i + k, row)
                    shares[node] = shares.get(node, 0) + weight * (b - a) / 2 * shape / width
        return shares

    def top_node(self, at):
        i = self.x.index(at)
        return self.node(2 * i, 2 * max(self.top[max(i - 1, 0)], self.top[min(i, len(self.top) - 1)]))


def solve(part, supports, loads, seen):
    """Supports (mm, mm, N/um), loads (mm, mm, N) on the top, places seen (mm): sinkings there in um, reactions in N."""
    lines = ["*NODE, NSET=ALL"]
    for (i, j), number in part.nodes.items():
        x, y = part.place(i, j)
        lines.append(f"{number}, {x / 1e3:.15g}, {y / 1e3:.15g}, 0")
    first = len(part.nodes) + 1
    for k in range(len(supports)):
        lines.append(f"{first + k}, 0, {-1 - k}, 0")
    lines.append(f"*ELEMENT, TYPE={part.kind}, ELSET=PART")
    lines += [f"{k + 1}, " + ", ".join(map(str, own)) for k, own in enumerate(part.elements)]
    lines += ["*MATERIAL, NAME=IRON", "*ELASTIC", f"{YOUNG}, {NU}", "*SOLID SECTION, ELSET=PART, MATERIAL=IRON", f"{THIN}"]
    for k, (at, width, stiffness) in enumerate(supports):
        element = len(part.elements) + 1 + k
        lines += [f"*ELEMENT, TYPE=SPRING1, ELSET=S{k}", f"{element}, {first + k}", f"*SPRING, ELSET=S{k}", "2", f"{stiffness * 1e6 * SHARE:.10e}"]
        shares = part.pad(at, width, False)
        terms = [(node, 2, share) for node, share in shares.items() if abs(share) > 1e-15] + [(first + k, 2, -1.0)]
        lines += ["*EQUATION", f"{len(terms)}"] + [f"{node}, {axis}, {share:.15g}" for node, axis, share in terms]
    lines += ["*BOUNDARY", f"{part.ends()[0]}, 1, 1"]
    for k in range(len(supports)):
        lines += [f"{first + k}, 1, 1", f"{first + k}, 3, 3"]
    lines += ["*STEP", "*STATIC", "*CLOAD"]
    for at, width, force in loads:
        lines += [f"{node}, 2, {-force * SHARE * share:.12e}" for node, share in part.pad(at, width, True).items()]
    lines += [f"*NSET, NSET=SUPPORTS", ", ".join(str(first + k) for k in range(len(supports)))]
    watched = [part.top_node(at) for at in seen]
    lines += ["*NSET, NSET=SEEN", ", ".join(map(str, watched))]
    lines += ["*NODE PRINT, NSET=SEEN", "U", "*NODE PRINT, NSET=SUPPORTS", "U", "*END STEP", ""]
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "part.inp").write_text("\n".join(lines))
        run = subprocess.run(["ccx", "part"], cwd=folder, capture_output=True, text=True)
        if run.returncode:
            raise SystemExit(run.stdout)
        moved = {}
        for line in Path(folder, "part.dat").read_text().splitlines():
            cells = line.split()
            if len(cells) == 4 and cells[0].isdigit():
                moved[int(cells[0])] = float(cells[2])
    sunk = [-1e6 * moved[node] for node in watched]
    return sunk, [-moved[first + k] * 1e6 * own[2] for k, own in enumerate(supports)]


def motions(part, pushes, watched):
    """Downward and lengthwise motions of every node of the part pinned at the ends of its underside under each push (shares, axis)
    of one newton, weighed as each of `watched` (shares, axis): the matrix of both, m/N."""
    lines = ["*NODE, NSET=ALL"]
    for (i, j), number in part.nodes.items():
        x, y = part.place(i, j)
        lines.append(f"{number}, {x / 1e3:.15g}, {y / 1e3:.15g}, 0")
    lines.append(f"*ELEMENT, TYPE={part.kind}, ELSET=PART")
    lines += [f"{k + 1}, " + ", ".join(map(str, own)) for k, own in enumerate(part.elements)]
    lines += ["*MATERIAL, NAME=IRON", "*ELASTIC", f"{YOUNG}, {NU}", "*SOLID SECTION, ELSET=PART, MATERIAL=IRON", f"{THIN}"]
    lines += ["*BOUNDARY", f"{part.ends()[0]}, 1, 2", f"{part.ends()[1]}, 2, 2"]
    for shares, axis in pushes:
        sign = -1 if axis == 2 else 1
        lines += ["*STEP", "*STATIC", "*CLOAD, OP=NEW"]
        lines += [f"{node}, {axis}, {sign * SHARE * share:.12e}" for node, share in shares.items()]
        lines += ["*NODE PRINT, NSET=ALL", "U", "*END STEP"]
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "part.inp").write_text("\n".join([*lines, ""]))
        run = subprocess.run(["ccx", "part"], cwd=folder, capture_output=True, text=True)
        if run.returncode:
            raise SystemExit(run.stdout)
        blocks = []
        for line in Path(folder, "part.dat").read_text().splitlines():
            cells = line.split()
            if "displacements" in line:
                blocks.append({})
            elif len(cells) == 4 and cells[0].isdigit():
                blocks[-1][int(cells[0])] = [float(cells[1]), -float(cells[2])]
    weigh = lambda moved, shares, axis: sum(share * moved[node][axis - 1] for node, share in shares.items())
    return np.array([[weigh(moved, *own) for moved in blocks] for own in watched])


def rub(part, supports, friction, loads, seen, steps=50):
    """As `solve`, with Coulomb friction under the pads: sinkings, reactions and friction on the part, once the loads have risen."""
    down = [(part.pad(at, width, False), 2) for at, width, _ in supports]
    along = [(shares, 1) for shares, _ in down]
    pressed = [(part.pad(at, width, True), 2) for at, width, _ in loads]
    read = [({part.top_node(at): 1.0}, 2) for at in seen]
    matrix = motions(part, down + along + pressed, down + along + read)
    n, places = len(supports), np.array([at for at, *_ in supports]) / 1e3
    give = np.array([1e-6 / stiffness for *_, stiffness in supports])
    force, at = np.array([f for *_, f in loads]), np.array([x for x, *_ in loads]) / 1e3
    vertical, lengthwise = matrix[:n], matrix[n : 2 * n]
    ways, anchor, unknown = [0] * n, np.zeros(n), None
    for step in range(1, steps + 1):
        load = force * step / steps
        for _ in range(100):
            # Unknowns: Q, T, a, b and how far it goes as a whole.
            a, right = np.zeros((2 * n + 3, 2 * n + 3)), np.zeros(2 * n + 3)
            for i in range(n):
                a[i, :n], a[i, n : 2 * n] = vertical[i, :n], -vertical[i, n : 2 * n]
                a[i, i] += give[i]
                a[i, 2 * n : 2 * n + 2] = -1, -places[i]
                right[i] = vertical[i, 2 * n :] @ load
                if ways[i]:
                    a[n + i, n + i], a[n + i, i] = 1e-9, -1e-9 * ways[i] * friction[i]
                else:
                    a[n + i, :n], a[n + i, n : 2 * n], a[n + i, -1] = -lengthwise[i, :n], lengthwise[i, n : 2 * n], 1
                    right[n + i] = anchor[i] - lengthwise[i, 2 * n :] @ load
            a[2 * n, :n], right[2 * n] = 1e-9, 1e-9 * load.sum()
            a[2 * n + 1, :n], right[2 * n + 1] = 1e-9 * places, 1e-9 * load @ at
            a[2 * n + 2, n : 2 * n] = 1e-9
            unknown = np.linalg.solve(a, right)
            q, t, whole = unknown[:n], unknown[n : 2 * n], unknown[-1]
            goes = lengthwise[:, :n] @ -q + lengthwise[:, n : 2 * n] @ t + lengthwise[:, 2 * n :] @ load + whole
            wrong = [(abs(t[i]) / (friction[i] * q[i]) - 1) if not ways[i] else (goes[i] - anchor[i]) * ways[i] * 1e9 for i in range(n)]
            worst = int(np.argmax(wrong))
            if wrong[worst] <= 1e-7:
                break
            ways[worst] = 0 if ways[worst] else int(np.sign(t[worst]))
        anchor = goes
    sunk = matrix[2 * n :, :n] @ -q + matrix[2 * n :, n : 2 * n] @ t + matrix[2 * n :, 2 * n :] @ force
    sunk += unknown[2 * n] + unknown[2 * n + 1] * np.array(seen) / 1e3
    return 1e6 * sunk, q, t


CASES = {
    "block, three supports": (
        ([(300, 60)], 5),
        [(50, 10, 200), (150, 12, 150), (250, 10, 200)],
        [(100, 20, 8000), (210, 15, 5000)],
        [0, 100, 150, 300],
    ),
    "stepped, four supports": (
        ([(50, 45), (120, 20), (60, 45), (170, 15), (40, 45)], 5),
        [(20, 8, 120), (150, 8, 120), (200, 8, 120), (430, 8, 120)],
        [(90, 10, 900), (210, 10, 1500), (320, 10, 400)],
        [0, 35, 215, 440],
    ),
}

if __name__ == "__main__":
    for name, (drawing, supports, loads, seen) in CASES.items():
        sunk, carried = solve(Part(*drawing), supports, loads, seen)
        print(name)
        print("  sinks", ", ".join(f"{at}: {value:.6f}" for at, value in zip(seen, sunk)), "um")
        print("  carry", ", ".join(f"{value:.4f}" for value in carried), "N")
        for friction in [0.05, 0.15]:
            sunk, carried, held = rub(Part(*drawing), supports, [friction] * len(supports), loads, seen)
            print("  friction", friction)
            print("    sinks", ", ".join(f"{at}: {value:.6f}" for at, value in zip(seen, sunk)), "um")
            print("    carry", ", ".join(f"{value:.4f}" for value in carried), "N")
            print("    hold", ", ".join(f"{value:.4f}" for value in held), "N")
