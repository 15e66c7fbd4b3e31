"""Measures shapes, distances and sizes against heads of known shape, and calibrates the correction of turned heads.

    python tests/reference/heads.py HEADS ROSTO [LENS]

HEADS is a folder of heads: NAME.ply (mm, y up, +z out of the face), NAME_lm68.json with 68 points on it (Multi-PIE
order), NAME/known.json with cameras, and the photos. ROSTO is the program. LENS is `exif` (the default), `unknown`
(EXIF is removed) or `distance` (the true one is given). Prints, next to the average face's:

- ICP: mean distance of the 468 landmarks to the surface after a similarity, in mm and relative to the average face,
- metric: the same after a rigid transform, in the millimetres of the model,
- landmarks: mean distance of ten of them from the points of the head, after a rigid transform of these,
- depth: mean difference from the surface along the camera's axis, where the landmarks are seen,

then distances and measures with the coverage of their intervals, and for each area of the face the outward correction
in mm at 30° on the near and the far side, the error that is left with its jackknife spread, and the ICP with the
correction learnt from the other heads. Only differences between photos of the same head are learnt, so that the mean shape of the heads is not.
"""

import json
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
from scipy.spatial import cKDTree

ROOT = Path(__file__).resolve().parents[2]
TABLES = ROOT / "crates" / "face" / "src"
# Multi-PIE points and the landmarks at the same places.
SAME = {30: 1, 33: 2, 36: 33, 39: 133, 42: 362, 45: 263, 48: 61, 54: 291, 27: 168, 8: 152}
PHOTOS = ("turn05", "turn08", "turn12", "turn17", "expr00", "view")
MIRROR = np.array([-1, 1, 1])
UNIT_DEG, MAX_TURN, RIDGE, FAIRING = 30, 1.3, 2.0, 60.0


def integers(text):
    return [int(number) for number in re.findall(r"-?\d+", text)]


def canonical():
    """Positions in mm, triangles, mirror partners and areas of the landmarks, from the tables of the face crate."""
    body = (TABLES / "tables" / "positions.rs").read_text().split("= [", 1)[1]
    stored = np.array(integers(body), dtype=float).reshape(-1, 3) * 1e-5
    topology = (TABLES / "tables" / "canonical.rs").read_text().split("= [", 1)[1]
    triangles = np.array(integers(topology)).reshape(-1, 3)
    midline = integers((TABLES / "symmetry.rs").read_text().split("MIDLINE: [u32; 28] =")[1].split(";")[0])
    right = [landmark for landmark in range(248) if landmark not in midline]
    partner = np.arange(468)
    partner[right], partner[248:] = np.arange(248, 468), right
    # Only the right side and the midline are stored.
    positions = stored[np.minimum(np.arange(468), partner)]
    positions[248:] *= MIRROR
    area = np.empty(468, dtype=object)
    for name, members in re.findall(r"Self::(\w+) => &\[([\d, \n]+)\]", (TABLES / "areas.rs").read_text()):
        area[integers(members)] = area[partner[integers(members)]] = name
    return positions, triangles, partner, area


AVERAGE, TRIANGLES, PARTNER, AREA = canonical()


def aligned(source, target, with_scale=True):
    """Similarity or rigid transform (scale, rotation, offset) of the source points to the target points."""
    a, b = source - source.mean(0), target - target.mean(0)
    u, d, v = np.linalg.svd(b.T @ a)
    flip = np.diag([1, 1, np.sign(np.linalg.det(u @ v))])
    rotation = u @ flip @ v
    scale = (d * np.diag(flip)).sum() / (a * a).sum() if with_scale else 1.0
    return scale, rotation, target.mean(0) - scale * source.mean(0) @ rotation.T


def moved(points, transform):
    scale, rotation, offset = transform
    return scale * points @ rotation.T + offset


def nearest_on_triangles(points, a, b, c):
    """Nearest points on triangles, and squared distances; points and corners broadcast."""
    best, least = a, ((points - a) ** 2).sum(-1)
    normal = np.cross(b - a, c - a)
    normal /= np.maximum(np.linalg.norm(normal, axis=-1, keepdims=True), 1e-12)
    foot = points - normal * ((points - a) * normal).sum(-1, keepdims=True)
    inside = np.ones(foot.shape[:-1], dtype=bool)
    for start, end in ((a, b), (b, c), (c, a)):
        along = end - start
        inside &= (np.cross(along, foot - start) * normal).sum(-1) >= 0
        share = ((points - start) * along).sum(-1) / np.maximum((along * along).sum(-1), 1e-12)
        near = start + along * np.clip(share, 0, 1)[..., None]
        distance = ((points - near) ** 2).sum(-1)
        best, least = np.where((distance < least)[..., None], near, best), np.minimum(distance, least)
    distance = ((points - foot) ** 2).sum(-1)
    return np.where(inside[..., None], foot, best), np.where(inside, distance, least)


class Head:
    def __init__(self, folder, name):
        self.name = name
        stored = (folder / f"{name}.ply").read_bytes()
        header, body = stored.split(b"end_header\n", 1)
        counts = [int(count) for count in re.findall(rb"element \w+ (\d+)", header)]
        self.vertices = np.frombuffer(body, [("at", "<f4", 3), ("c", "u1", 4)], counts[0])["at"].astype(float)
        self.faces = np.frombuffer(body, [("n", "u1"), ("at", "<i4", 3)], counts[1], counts[0] * 16)["at"]
        self.corners = self.vertices[self.faces].transpose(1, 0, 2)
        self.tree = cKDTree(self.corners.mean(0))
        points = np.array(json.loads((folder / f"{name}_lm68.json").read_text())["multipie68"])
        self.marks = points[list(SAME)]
        known = json.loads((folder / name / "known.json").read_text())
        self.looked_at = np.array(known["look_at_mm"])
        self.side_px = known["size_px"]
        views = known.get("views") or known["turning"] + known["expressions"][:1]
        self.views = [view for view in views if view["file"].startswith(PHOTOS)]
        self.folder = folder / name
        self.average = self.icp(AVERAGE)[0]

    def nearest(self, points):
        _, near = self.tree.query(points, k=8)
        found, distance = nearest_on_triangles(points[:, None], *self.corners[:, near])
        best, rows = distance.argmin(1), np.arange(len(points))
        return found[rows, best], np.sqrt(distance[rows, best])

    def icp(self, shape, with_scale=True):
        """Mean distance to the surface in mm, the transform, and the nearest points."""
        fit = lambda source, target: aligned(source, target, with_scale)
        transform = fit(shape[list(SAME.values())], self.marks)
        for _ in range(40):
            near, distance = self.nearest(moved(shape, transform))
            kept = distance <= np.percentile(distance, 97)
            before, transform = moved(shape, transform), fit(shape[kept], near[kept])
            if np.abs(moved(shape, transform) - before).max() < 2e-3:
                break
        near, distance = self.nearest(moved(shape, transform))
        return distance.mean(), transform, near

    def seen(self, view, places):
        """Pixels and depths of places on the head in mm."""
        yaw, pitch = np.radians([view["yaw_deg"], view["pitch_deg"]])
        about_y = np.array([[np.cos(yaw), 0, np.sin(yaw)], [0, 1, 0], [-np.sin(yaw), 0, np.cos(yaw)]])
        about_x = np.array([[1, 0, 0], [0, np.cos(pitch), -np.sin(pitch)], [0, np.sin(pitch), np.cos(pitch)]])
        turned = (places - self.looked_at) @ (about_x @ about_y).T
        away = view["distance_mm"] - turned[:, 2]
        middle = self.side_px / 2
        return middle + turned[:, :2] * [1, -1] * view["focal_px"] / away[:, None], away

    def depths(self, view, pixels):
        """Distance along the camera's axis of the surface at these pixels, in mm; NaN off the head."""
        at, away = self.seen(view, self.vertices)
        corners, inverse = at[self.faces], 1 / away[self.faces]
        _, near = cKDTree(corners.mean(1)).query(pixels, k=60)
        a, b, c = np.moveaxis(corners[near], 2, 0)
        cross = lambda u, v: u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]
        area, point = cross(b - a, c - a), pixels[:, None]
        area = np.where(np.abs(area) < 1e-12, 1e-12, area)
        share = np.stack([cross(b - point, c - point), cross(c - point, a - point), cross(a - point, b - point)], -1)
        share /= area[..., None]
        hit = np.where((share >= -1e-6).all(-1), (share * inverse[near]).sum(-1), -np.inf).max(1)
        return np.where(hit > 0, 1 / np.where(hit > 0, hit, 1), np.nan)


def without_exif(path, folder):
    """A copy of a JPEG without its EXIF segment."""
    stored, position = path.read_bytes(), 2
    kept = stored[:2]
    while stored[position + 1] != 0xDA:
        length = 2 + int.from_bytes(stored[position + 2 : position + 4], "big")
        if stored[position + 1] != 0xE1:
            kept += stored[position : position + length]
        position += length
    copy = folder / f"{path.parent.name}-{path.name}"
    copy.write_bytes(kept + stored[position:])
    return copy


def mesh(rosto, lens, head, view):
    with tempfile.TemporaryDirectory() as folder:
        photo, output = head.folder / view["file"], Path(folder) / "mesh.json"
        if lens == "unknown":
            photo = without_exif(photo, Path(folder))
        given = ["--distance", str(view["distance_mm"] / 10)] if lens == "distance" else []
        command = [rosto, "mesh", photo, "-o", output, "--units", "mm", "--density", "0", *given]
        subprocess.run(command, check=True, capture_output=True)
        stored = json.loads(output.read_text())
        return np.array(stored["positions"])[:468], stored["about"]


def normals(shape):
    a, b, c = shape[TRIANGLES].transpose(1, 0, 2)
    total = np.zeros_like(shape)
    for corner in range(3):
        np.add.at(total, TRIANGLES[:, corner], np.cross(b - a, c - a))
    return total / np.linalg.norm(total, axis=1, keepdims=True)


REGIONS = {
    "forehead, brows": ("Forehead", "Glabella", "Brow", "Temple"),
    "eyes": ("UpperEyelid", "EyeCorner", "LowerEyelid", "UnderBrow", "UnderEye"),
    "nose": ("NoseBridge", "NoseSide", "NoseTip", "NoseWing", "Nostril"),
    "cheeks": ("Cheekbone", "Cheek", "SideOfFace", "SmileLine"),
    "mouth": ("Philtrum", "UpperLip", "MouthCorner", "LowerLip"),
    "chin, jaw": ("ChinCrease", "Chin", "Jaw"),
}


def by_region(head, shape):
    """Mean distance to the surface after a similarity, in mm, of the landmarks of each region."""
    _, transform, near = head.icp(shape)
    distance = np.linalg.norm(moved(shape, transform) - near, axis=1)
    return [distance[np.isin(AREA, areas)].mean() for areas in REGIONS.values()]


def four_numbers(head, view, shape):
    icp, metric = head.icp(shape)[0], head.icp(shape, with_scale=False)[0]
    marks = shape[list(SAME.values())]
    landmarks = np.linalg.norm(moved(marks, aligned(marks, head.marks, with_scale=False)) - head.marks, axis=1).mean()
    _, transform, _ = head.icp(shape)
    pixels, away = head.seen(view, moved(shape, transform))
    difference = away - head.depths(view, pixels)
    return icp, metric, landmarks, np.nanmean(np.abs(difference - np.nanmedian(difference)))


def fairing():
    adjacent = np.zeros((468, 468))
    for corner in range(3):
        pairs = TRIANGLES[:, corner], TRIANGLES[:, (corner + 1) % 3]
        adjacent[pairs] = adjacent[pairs[::-1]] = 1
    laplacian = np.eye(468) - adjacent / adjacent.sum(1, keepdims=True)
    return np.linalg.inv(np.eye(468) + FAIRING * laplacian.T @ laplacian)


def learnt(rows):
    """Correction in mm of each area on the near and the far side at 30°, from (head, turn, outward residuals)."""
    pairs = [(name, turn, outward) for name, turn, outward in rows]
    pairs += [(f"{name}, mirrored", -turn, outward[PARTNER]) for name, turn, outward in rows]
    turns = np.array([[turn, turn * turn] for _, turn, _ in pairs])
    values = np.array([outward for _, _, outward in pairs])
    for name in {name for name, _, _ in pairs}:
        own = [index for index, pair in enumerate(pairs) if pair[0] == name]
        turns[own] -= turns[own].mean(0)
        values[own] -= values[own].mean(0)
    solve = np.linalg.solve(turns.T @ turns + RIDGE * np.eye(2), turns.T)
    table = {}
    for area in sorted(set(AREA)):
        right = (AREA == area) & (AVERAGE[:, 0] < -1e-6)
        both = right | ((AREA == area) & (np.abs(AVERAGE[:, 0]) <= 1e-6))
        odd = (solve @ values[:, right].mean(1))[0] if right.any() else 0.0
        even = (solve @ values[:, both].mean(1))[1]
        table[area] = np.array([even + odd, even - odd])
    return table


def built_in():
    source = (TABLES / "model" / "turned.rs").read_text()
    found = re.findall(r"Area::(\w+) => \[(-?[\d.]+), (-?[\d.]+)\]", source)
    return {area: np.array([float(near), float(far)]) for area, near, far in found}


def outward(table, turn, smooth):
    side = -np.sign(np.where(np.abs(AVERAGE[:, 0]) < 1e-6, 0, AVERAGE[:, 0]))
    near, far = np.array([table[area] for area in AREA]).T
    return smooth @ (side * turn * (near - far) + turn * turn * (near + far)) / 2


def main():
    folder, rosto, lens = Path(sys.argv[1]), sys.argv[2], (sys.argv[3:] or ["exif"])[0]
    heads = [Head(folder, path.parent.name) for path in sorted(folder.glob("*/known.json"))]
    jobs = [(head, view) for head in heads for view in head.views]
    with ThreadPoolExecutor(2) as pool:
        meshes = list(pool.map(lambda job: mesh(rosto, lens, *job), jobs))
    report(lens, jobs, meshes)
    if lens == "exif":
        calibrate(jobs, meshes)


def report(lens, jobs, meshes):
    yaws = np.array([abs(view["yaw_deg"]) for _, view in jobs])
    names = np.array([head.name for head, _ in jobs])
    found = np.array([four_numbers(head, view, shape) for (head, view), (shape, _) in zip(jobs, meshes)])
    average = np.array([four_numbers(head, view, AVERAGE) for head, view in jobs])
    print(f"lens: {lens}; {len(jobs)} photos of {len(set(names))} heads; mm, average face in brackets")
    groups = {"up to 25°": yaws <= 25.5, "18° to 34°": yaws >= 18, "all": yaws >= 0}
    for title, chosen in {**groups, **{name: names == name for name in sorted(set(names))}}.items():
        ours, theirs = found[chosen].mean(0), average[chosen].mean(0)
        numbers = zip(("ICP", "metric", "landmarks", "depth"), ours, theirs)
        text = ", ".join(f"{name} {a:.2f} ({b:.2f})" for name, a, b in numbers)
        print(f"{title:10} {text}; ICP {ours[0] / theirs[0]:.3f}")
    ours = np.mean([by_region(head, shape) for (head, _), (shape, _) in zip(jobs, meshes)], axis=0)
    theirs = np.mean([by_region(head, AVERAGE) for head, _ in jobs], axis=0)
    print("ICP by region:", ", ".join(f"{name} {a:.2f} ({b:.2f})" for name, a, b in zip(REGIONS, ours, theirs)))
    print(f"worst photo {(found[:, 0] / average[:, 0]).max():.3f}")
    distances = np.array([view["distance_mm"] for _, view in jobs])
    said = np.array([1000 * about["distance_m"] for _, about in meshes])
    ends = 1000 * np.array([about["distance_interval_m"] for _, about in meshes])
    error, fronts = np.abs(said / distances - 1), yaws < 9
    covered = ((ends[:, 0] <= distances) & (distances <= ends[:, 1])).mean()
    print(f"distance of fronts: median error {np.median(error[fronts]):.3f}, largest {error[fronts].max():.3f}; "
          f"90 % intervals cover {covered:.3f}")


def calibrate(jobs, meshes):
    smooth, rows, shapes = fairing(), [], []
    for (head, view), (shape, about) in zip(jobs, meshes):
        turn = np.clip(about["yaw_deg"] / UNIT_DEG, -MAX_TURN, MAX_TURN)
        _, (scale, rotation, offset), near = head.icp(shape)
        residual = ((near - offset) @ rotation / scale) - shape
        out = normals(shape)
        rows.append((head.name, turn, np.clip((residual * out).sum(1), -8, 8)))
        shapes.append((shape, out))
    left, table = learnt(rows), built_in()
    others = {name: learnt([row for row in rows if row[0] != name]) for name in {row[0] for row in rows}}
    print("correction in mm at 30°, near and far side: built in; left to correct ± spread between heads")
    for area, value in left.items():
        drawn = np.array([table[area] for table in others.values()])
        spread = np.sqrt((len(drawn) - 1) * ((drawn - drawn.mean(0)) ** 2).mean(0))
        print(f"{area:14} {table[area]}; {value.round(2)} ± {spread.round(2)}")
    ratios = []
    for (head, view), (name, turn, _), (shape, out) in zip(jobs, rows, shapes):
        # The influence of this head on the table is removed.
        by = outward({area: others[name][area] - left[area] for area in left}, turn, smooth)
        ratios.append((abs(view["yaw_deg"]), head.icp(shape + out * by[:, None])[0], head.average))
    yaws, ours, theirs = np.array(ratios).T
    for title, chosen in (("up to 25°", yaws <= 25.5), ("18° to 34°", yaws >= 18), ("all", yaws >= 0)):
        print(f"ICP relative to the average face, corrected by the other heads, {title}: "
              f"{ours[chosen].sum() / theirs[chosen].sum():.3f}")


if __name__ == "__main__":
    main()
