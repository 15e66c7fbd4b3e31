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
from head_surface import AREA, AVERAGE, PARTNER, SAME, TABLES, TRIANGLES, Head, aligned, moved, normals

UNIT_DEG, MAX_TURN, RIDGE, FAIRING = 30, 1.3, 2.0, 60.0


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


# Measures between two of the 68 points, and these.
MEASURED = {"inner-eye-distance": (39, 42), "outer-eye-distance": (36, 45), "mouth-width": (48, 54)}


def covered_measures(jobs, meshes):
    """Share of the measures with a true length whose 95 % interval contains it, and how many were given."""
    found = []
    for (head, _), (_, about) in zip(jobs, meshes):
        for name, (one, other) in MEASURED.items():
            true = np.linalg.norm(head.points[one] - head.points[other])
            if name in about["measures_mm"]:
                _, low, high = about["measures_mm"][name]
                found.append(low <= true <= high)
    return np.mean(found), len(found)


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
    share, count = covered_measures(jobs, meshes)
    print(f"measures: 95 % intervals cover {share:.3f} of {count}")


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
