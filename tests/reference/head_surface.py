"""Heads of known shape for heads.py: their surfaces, cameras, and alignment to the landmarks."""

import json
import re
from pathlib import Path

import numpy as np
from scipy.spatial import cKDTree

ROOT = Path(__file__).resolve().parents[2]
TABLES = ROOT / "crates" / "face" / "src"
# Multi-PIE points and the landmarks at the same places.
SAME = {30: 1, 33: 2, 36: 33, 39: 133, 42: 362, 45: 263, 48: 61, 54: 291, 27: 168, 8: 152}
PHOTOS = ("turn05", "turn08", "turn12", "turn17", "expr00", "view")
MIRROR = np.array([-1, 1, 1])


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
        self.points = np.array(json.loads((folder / f"{name}_lm68.json").read_text())["multipie68"])
        self.marks = self.points[list(SAME)]
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


def normals(shape):
    a, b, c = shape[TRIANGLES].transpose(1, 0, 2)
    total = np.zeros_like(shape)
    for corner in range(3):
        np.add.at(total, TRIANGLES[:, corner], np.cross(b - a, c - a))
    return total / np.linalg.norm(total, axis=1, keepdims=True)
